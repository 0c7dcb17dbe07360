package org.sitaf.agent.sandbox.seccomp;

import static org.sitaf.agent.sandbox.seccomp.SystemCallRule.EAFNOSUPPORT;
import static org.sitaf.agent.sandbox.seccomp.SystemCallRule.ENOSYS;
import static org.sitaf.agent.sandbox.seccomp.SystemCallRule.EPERM;
import static org.sitaf.agent.sandbox.seccomp.SystemCallRule.NONE;
import static org.sitaf.agent.sandbox.seccomp.SystemCallRule.of;

import java.util.List;
import org.sitaf.agent.sandbox.seccomp.SystemCallRule.AnyBit;
import org.sitaf.agent.sandbox.seccomp.SystemCallRule.NoneOf;
import org.sitaf.agent.sandbox.seccomp.SystemCallRule.OneOf;

/**
 * The blocked calls: those that Docker's default profile blocks in containers without capabilities,
 * and those that neither runtimes nor compilers need. Numbers are those of the kernel's {@code
 * unistd_64.h} and {@code asm-generic/unistd.h}. Newer calls are unknown, see {@link
 * FilterProgram}.
 */
final class SystemCallRules {
  /** The newest known call, {@code removexattrat} of Linux 6.13. */
  static final int NEWEST = 466;

  /** CLONE_NEWNS, NEWCGROUP, NEWUTS, NEWIPC, NEWUSER, NEWPID, NEWNET of {@code linux/sched.h}. */
  private static final int NEW_NAMESPACES = 0x7E020000;

  private static final int UNIX = 1;
  private static final int INET = 2;
  private static final int INET6 = 10;
  private static final int NETLINK = 16;
  private static final int NETLINK_ROUTE = 0;
  private static final int TIOCSTI = 0x5412;
  private static final int TIOCLINUX = 0x541C;

  /** PER_LINUX, UNAME26, PER_LINUX32, both, and a query. */
  private static final List<Integer> PERSONALITIES = List.of(0, 0x20000, 8, 0x20008, -1);

  /** Blocked on all machines. */
  static final List<SystemCallRule> ALWAYS =
      List.of(
          // Rules with conditions come first, because the kernel cannot cache their result.
          of("clone", 56, 220, EPERM, new AnyBit(0, NEW_NAMESPACES)),
          of("ioctl", 16, 29, EPERM, new OneOf(1, List.of(TIOCSTI, TIOCLINUX))),
          of("socket", 41, 198, EAFNOSUPPORT, new NoneOf(0, List.of(UNIX, INET, INET6, NETLINK))),
          // NETLINK_ROUTE gives the names of network interfaces; other protocols are blocked.
          of(
              "socket",
              41,
              198,
              EAFNOSUPPORT,
              new OneOf(0, List.of(NETLINK)),
              new NoneOf(2, List.of(NETLINK_ROUTE))),
          of("socketpair", 53, 199, EAFNOSUPPORT, new NoneOf(0, List.of(UNIX))),
          of("personality", 135, 92, EPERM, new NoneOf(0, PERSONALITIES)),

          // Namespaces and mounts. The flags of clone3 lie in memory; glibc uses clone without it.
          of("clone3", 435, 435, ENOSYS),
          of("unshare", 272, 97, EPERM),
          of("setns", 308, 268, EPERM),
          of("mount", 165, 40, EPERM),
          of("umount2", 166, 39, EPERM),
          of("pivot_root", 155, 41, EPERM),
          of("chroot", 161, 51, EPERM),
          of("open_tree", 428, 428, EPERM),
          of("move_mount", 429, 429, EPERM),
          of("fsopen", 430, 430, EPERM),
          of("fsconfig", 431, 431, EPERM),
          of("fsmount", 432, 432, EPERM),
          of("fspick", 433, 433, EPERM),
          of("mount_setattr", 442, 442, EPERM),
          of("statmount", 457, 457, EPERM),
          of("listmount", 458, 458, EPERM),
          of("open_by_handle_at", 304, 265, EPERM),
          of("name_to_handle_at", 303, 264, EPERM),
          of("quotactl", 179, 60, EPERM),
          of("quotactl_fd", 443, 443, EPERM),

          // Large kernel features with a history of vulnerabilities.
          of("io_uring_setup", 425, 425, ENOSYS),
          of("io_uring_enter", 426, 426, ENOSYS),
          of("io_uring_register", 427, 427, ENOSYS),
          of("userfaultfd", 323, 282, ENOSYS),
          of("bpf", 321, 280, EPERM),
          of("perf_event_open", 298, 241, EPERM),
          of("fanotify_init", 300, 262, EPERM),
          of("io_setup", 206, 0, ENOSYS),
          of("memfd_secret", 447, 447, ENOSYS),
          of("lookup_dcookie", 212, 18, ENOSYS),
          of("nfsservctl", 180, 42, ENOSYS),
          of("modify_ldt", 154, NONE, ENOSYS),
          of("uselib", 134, NONE, ENOSYS),
          of("ustat", 136, NONE, ENOSYS),
          of("_sysctl", 156, NONE, ENOSYS),
          of("sysfs", 139, NONE, ENOSYS),
          of("vserver", 236, NONE, ENOSYS),

          // Kernel keyrings are not part of any namespace.
          of("add_key", 248, 217, EPERM),
          of("request_key", 249, 218, EPERM),
          of("keyctl", 250, 219, EPERM),

          // Access to other processes; builds run no debugger.
          of("ptrace", 101, 117, EPERM),
          of("process_vm_readv", 310, 270, EPERM),
          of("process_vm_writev", 311, 271, EPERM),
          of("process_madvise", 440, 440, EPERM),
          of("pidfd_getfd", 438, 438, EPERM),
          of("kcmp", 312, 272, EPERM),

          // NUMA placement.
          of("mbind", 237, 235, EPERM),
          of("set_mempolicy", 238, 237, EPERM),
          of("set_mempolicy_home_node", 450, 450, EPERM),
          of("get_mempolicy", 239, 236, EPERM),
          of("migrate_pages", 256, 238, EPERM),
          of("move_pages", 279, 239, EPERM),

          // Administration of the machine.
          of("init_module", 175, 105, EPERM),
          of("finit_module", 313, 273, EPERM),
          of("delete_module", 176, 106, EPERM),
          of("create_module", 174, NONE, ENOSYS),
          of("query_module", 178, NONE, ENOSYS),
          of("get_kernel_syms", 177, NONE, ENOSYS),
          of("kexec_load", 246, 104, EPERM),
          of("kexec_file_load", 320, 294, EPERM),
          of("reboot", 169, 142, EPERM),
          of("swapon", 167, 224, EPERM),
          of("swapoff", 168, 225, EPERM),
          of("acct", 163, 89, EPERM),
          of("iopl", 172, NONE, EPERM),
          of("ioperm", 173, NONE, EPERM),
          of("settimeofday", 164, 170, EPERM),
          of("clock_settime", 227, 112, EPERM),
          of("clock_adjtime", 305, 266, EPERM),
          of("adjtimex", 159, 171, EPERM),
          of("vhangup", 153, 58, EPERM),
          of("syslog", 103, 116, EPERM),
          of("sethostname", 170, 161, EPERM),
          of("setdomainname", 171, 162, EPERM));

  /**
   * Blocked if no control group counts memory: calls that allocate memory outside of any process,
   * which a measurement of the processes cannot see.
   */
  static final List<SystemCallRule> WITHOUT_MEMORY_GROUP =
      List.of(
          of("memfd_create", 319, 279, ENOSYS),
          of("shmget", 29, 194, ENOSYS),
          of("msgget", 68, 186, ENOSYS),
          of("semget", 64, 190, ENOSYS),
          of("mq_open", 240, 180, ENOSYS));

  /**
   * Blocked if no control group distributes processor time: the kernel then distributes it among
   * sessions, so a process tree must stay in its session. The call succeeds without effect, because
   * programs treat its failure as an error.
   */
  static final List<SystemCallRule> WITHOUT_CPU_GROUP = List.of(of("setsid", 112, 157, 0));

  private SystemCallRules() {}
}
