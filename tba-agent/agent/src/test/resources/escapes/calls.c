/* Tries system calls that lead out of a sandbox, and some that programs need. One line each: NAME ok|ERRNO. */
#define _GNU_SOURCE
#include <errno.h>
#include <linux/netlink.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

static void print_result(const char *name, long result) {
  if (result < 0) printf("%s %d\n", name, errno);
  else printf("%s ok\n", name);
}

static char zeros[4096];

/* Arguments with which an open call succeeds or fails with another error than a closed one. */
#define CALL(name, ...) print_result(#name, syscall(SYS_##name, __VA_ARGS__))

static void in_child(const char *name, long flags) {
  long pid = syscall(SYS_clone, flags | SIGCHLD, 0, 0, 0, 0);
  if (pid == 0) _exit(0);
  int saved = errno;
  if (pid > 0) waitpid((pid_t)pid, NULL, 0);
  errno = saved;
  print_result(name, pid);
}

static void *nothing(void *argument) { return argument; }

int main(void) {
  /* Some of them would change the machine. */
  if (getuid() == 0) return 3;
  in_child("clone:user", CLONE_NEWUSER);
  in_child("clone:mount", CLONE_NEWNS);
  in_child("clone:net", CLONE_NEWNET);
  in_child("clone:pid", CLONE_NEWPID);
  in_child("clone:plain", 0);
  // Before there is a thread, with which the kernel refuses it anyway.
  CALL(unshare, CLONE_NEWUSER);
  pthread_t thread;
  errno = 0;
  print_result("thread", pthread_create(&thread, NULL, nothing, NULL) ? -1 : 0);
  long child = syscall(SYS_clone3, zeros, 88);
  if (child == 0) _exit(0);
  print_result("clone3", child);
  CALL(setns, 0, 0);
  CALL(mount, "none", "/tmp", "tmpfs", 0, 0);
  CALL(umount2, "/tmp", 0);
  CALL(pivot_root, "/", "/");
  CALL(chroot, "/");
  CALL(open_tree, -100, "/", 0);
  CALL(move_mount, -1, "", -1, "", 0);
  CALL(fsopen, "tmpfs", 0);
  CALL(fsconfig, -1, 0, 0, 0, 0);
  CALL(fsmount, -1, 0, 0);
  CALL(fspick, -100, "/", 0);
  CALL(mount_setattr, -1, "", 0, 0, 0);
  CALL(name_to_handle_at, -100, "/tmp", zeros, zeros + 64, 0);
  CALL(open_by_handle_at, -1, zeros, 0);
  CALL(io_uring_setup, 4, zeros);
  CALL(io_uring_enter, -1, 0, 0, 0, 0, 0);
  CALL(io_uring_register, -1, 0, 0, 0);
  CALL(userfaultfd, 1);
  CALL(bpf, 0, zeros, 48);
  CALL(perf_event_open, zeros, 0, -1, -1, 0);
  CALL(keyctl, 0, -3, 1);
  CALL(add_key, "user", "a", "b", 1, -3);
  CALL(request_key, "user", "a", 0, -3);
  CALL(ptrace, PTRACE_TRACEME, 0, 0, 0);
  CALL(process_vm_readv, getppid(), 0, 0, 0, 0, 0);
  CALL(process_vm_writev, getppid(), 0, 0, 0, 0, 0);
  CALL(pidfd_getfd, -1, 0, 0);
  CALL(kcmp, getpid(), getpid(), 0, 0, 0);
  CALL(kexec_load, 0, 0, 0, 0);
  CALL(init_module, 0, 0, "");
  CALL(finit_module, -1, "", 0);
  CALL(delete_module, "x", 0);
  CALL(reboot, 0, 0, 0, 0);
  CALL(swapon, "/x", 0);
  CALL(swapoff, "/x");
  CALL(quotactl, 0, 0, 0, 0);
  CALL(acct, "/x");
  CALL(settimeofday, 0, 0);
  CALL(clock_settime, 0, zeros);
  CALL(syslog, 3, zeros, 100);
  CALL(vhangup, 0);
  CALL(sethostname, "x", 1);
  CALL(fanotify_init, 0, 0);
  CALL(io_setup, 1, zeros + 8);
  CALL(memfd_secret, 0);
  CALL(mbind, 0, 0, 0, 0, 0, 0);
  CALL(move_pages, 0, 0, 0, 0, 0, 0);
#ifdef __x86_64__
  CALL(iopl, 0);
  CALL(ioperm, 0, 0, 0);
  CALL(modify_ldt, 0, zeros, 16);
  print_result("x32:getpid", syscall(0x40000000 | 39));
#endif
  print_result("unknown:999", syscall(999));
  print_result("ioctl:TIOCSTI", ioctl(0, 0x5412, "x"));
  print_result("ioctl:TIOCLINUX", ioctl(0, 0x541C, zeros));
  print_result("personality:norandom", syscall(SYS_personality, 0x0040000));
  print_result("personality:ask", syscall(SYS_personality, 0xffffffff));
  print_result("socket:vsock", socket(40, SOCK_STREAM, 0));
  print_result("socket:alg", socket(38, SOCK_SEQPACKET, 0));
  print_result("socket:packet", socket(AF_PACKET, SOCK_RAW, 0));
  print_result("socket:bluetooth", socket(31, SOCK_RAW, 0));
  print_result("socket:can", socket(29, SOCK_RAW, 1));
  print_result("socket:netlink-uevent", socket(AF_NETLINK, SOCK_RAW, NETLINK_KOBJECT_UEVENT));
  print_result("socket:netlink-netfilter", socket(AF_NETLINK, SOCK_RAW, NETLINK_NETFILTER));
  print_result("socket:netlink-route", socket(AF_NETLINK, SOCK_RAW, NETLINK_ROUTE));
  print_result("socket:unix", socket(AF_UNIX, SOCK_STREAM, 0));
  print_result("socket:inet", socket(AF_INET, SOCK_STREAM, 0));
  print_result("socket:inet6", socket(AF_INET6, SOCK_DGRAM, 0));
  int pair[2];
  print_result("socketpair:unix", socketpair(AF_UNIX, SOCK_STREAM, 0, pair));
  print_result("memfd_create", syscall(SYS_memfd_create, "x", 0));
  print_result("shmget", syscall(SYS_shmget, 0, 4096, 01600));
  return 0;
}
