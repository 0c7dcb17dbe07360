package org.sitaf.agent.sandbox;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.cgroup.AutomaticGroups;
import org.sitaf.agent.sandbox.cgroup.ControlGroup;
import org.sitaf.agent.sandbox.cgroup.ControlGroups;
import org.sitaf.agent.sandbox.seccomp.SystemCallFilter;

/**
 * Runs processes in namespaces made by bubblewrap: a read-only system, no network, no view of other
 * processes, only the files that are named, and only the system calls that builds need. Limits come
 * from control groups where this machine offers them, and from {@code prlimit}. If the agent runs
 * as root, each process runs as an unprivileged user that owns nothing else, because limits do not
 * apply to root. do not bind root.
 */
final class Bubblewrap implements Sandbox {
  private static final String INSTALL = "apt-get install bubblewrap";
  private static final String DISABLE_NAMESPACES = "--disable-userns";
  private static final long PROBE_SECONDS = 20;

  /** The monitor process, the first process of its namespace, then the command. */
  private static final int GENERATIONS = 2;

  private final Path program;
  private final String version;
  private final boolean required;
  private final ControlGroups groups;
  private final @Nullable SystemCallFilter filter;
  private final Privileges privileges = Privileges.ofThisProcess();

  /** Null if the agent does not run as root. */
  private final @Nullable SandboxUsers users;

  private final boolean disablesNamespaces;

  /** Why components are in no Landlock domain on this machine; empty if they are. */
  private final String noDomains;

  private Bubblewrap(
      Path program, boolean required, ControlGroups groups, @Nullable SystemCallFilter filter)
      throws IOException {
    this.program = program;
    this.version = probe(List.of(program.toString(), "--version")).strip();
    this.required = required;
    this.groups = groups;
    this.filter = filter;
    this.users =
        probe(List.of("id", "-u")).strip().equals("0") ? SandboxUsers.ofThisProcess() : null;
    this.disablesNamespaces =
        users == null && probe(List.of(program.toString(), "--help")).contains(DISABLE_NAMESPACES);
    this.noDomains = LandlockDomain.missing(prefix -> probe(trialCommand(prefix)));
  }

  /**
   * Finds bubblewrap and runs a trial command in it.
   *
   * @throws SandboxMissingException if it is not installed, does not work, or cannot enforce what
   *     is required
   */
  static Bubblewrap find(boolean required) throws SandboxMissingException {
    return find(required, ControlGroups.ofThisMachine(), true);
  }

  /** Like {@link #find(boolean)}, with the given control groups and optionally without a filter. */
  static Bubblewrap find(boolean required, ControlGroups groups, boolean filterSystemCalls)
      throws SandboxMissingException {
    Path program =
        findInPath("bwrap")
            .orElseThrow(
                () ->
                    new SandboxMissingException(
                        "bubblewrap is not installed; install it with: " + INSTALL));
    for (String tool : List.of("prlimit", "setpriv")) {
      if (findInPath(tool).isEmpty()) {
        throw new SandboxMissingException(
            tool + " is not installed; install it with: apt-get install util-linux");
      }
    }
    try {
      Optional<SystemCallFilter> filter =
          filterSystemCalls
              ? SystemCallFilter.of(groups.limitsMemory(), groups.sharesCpu())
              : Optional.empty();
      Bubblewrap found = new Bubblewrap(program, required, groups, filter.orElse(null));
      if (required && !found.limitsMemory()) {
        throw new SandboxMissingException(
            "the memory of components cannot be limited: "
                + groups.description()
                + ", and there is no system call filter for "
                + System.getProperty("os.arch")
                + " that would keep their memory countable");
      }
      probe(found.trialCommand(List.of()));
      return found;
    } catch (SandboxMissingException e) {
      throw e;
    } catch (IOException e) {
      throw new SandboxMissingException(
          "bubblewrap does not work here ("
              + e.getMessage()
              + "); it needs user namespaces, or an agent that runs as root");
    }
  }

  private List<String> trialCommand(List<String> prefix) throws IOException {
    List<String> command = LaunchScript.prefix(ControlGroup.NONE, filterPath());
    namespaces(command, false);
    MountPlan.system().appendTo(command);
    command.addAll(List.of("--chdir", "/", "--"));
    command.addAll(privileges.setLimits(ProcessLimits.TOOL));
    if (users != null) {
      command.addAll(Privileges.switchTo(users.first()));
    }
    command.addAll(prefix);
    command.add("/bin/true");
    return command;
  }

  @Override
  public String kind() {
    return version;
  }

  @Override
  public String description() {
    StringBuilder text = new StringBuilder(version);
    if (users != null) {
      text.append(", each process as a separate user (")
          .append(users.first())
          .append(" to ")
          .append(users.last())
          .append(')');
    }
    if (groups.limitsMemory()) {
      text.append(", ").append(groups.description());
    } else if (limitsMemory()) {
      text.append(", the agent polls the memory in use: ").append(groups.description());
    } else {
      text.append(", MEMORY IS NOT LIMITED: ").append(groups.description());
    }
    if (filter == null) {
      text.append(", SYSTEM CALLS ARE NOT FILTERED on ").append(System.getProperty("os.arch"));
    }
    if (users == null && !noDomains.isEmpty()) {
      text.append(", THE SANDBOX'S FIRST PROCESS IS NOT PROTECTED: ").append(noDomains);
    }
    if (!groups.sharesCpu() && (filter == null || !AutomaticGroups.sharesCpu())) {
      text.append(", PROCESSOR TIME IS NOT SHARED");
    }
    return text.toString();
  }

  @Override
  public boolean isRequired() {
    return required;
  }

  @Override
  public boolean canIdle() {
    return groups.sharesCpu();
  }

  private boolean limitsMemory() {
    return groups.limitsMemory() || filter != null;
  }

  @Override
  public ConfinedProcess start(Confinement confinement) throws IOException {
    ControlGroup group = groups.create(confinement.limits().ofGroup());
    int user = -1;
    try {
      user = users == null ? -1 : users.acquire();
      List<String> command = command(confinement, group, user);
      if (user >= 0) {
        Ownership.transferTo(user, confinement);
      }
      int sandboxUser = user;
      return ConfinedProcess.start(
          command, confinement, Map.of(), group, GENERATIONS, () -> release(sandboxUser));
    } catch (IOException | RuntimeException e) {
      group.remove();
      release(user);
      throw e;
    }
  }

  private List<String> command(Confinement confinement, ControlGroup group, int user)
      throws IOException {
    List<String> command = LaunchScript.prefix(group, filterPath());
    namespaces(command, confinement.network());
    MountPlan.of(confinement).appendTo(command);
    command.addAll(List.of("--chdir", confinement.working().toString(), "--"));
    command.addAll(privileges.setLimits(confinement.limits()));
    if (user >= 0) {
      command.addAll(Privileges.switchTo(user));
    }
    if (noDomains.isEmpty()) {
      command.addAll(LandlockDomain.enter());
    }
    command.addAll(Privileges.withVariables(confinement.environment(), confinement.command()));
    return command;
  }

  private void release(int user) {
    if (users != null && user >= 0) {
      users.release(user);
    }
  }

  private void namespaces(List<String> command, boolean network) {
    command.add(program.toString());
    command.addAll(List.of("--die-with-parent", "--new-session"));
    command.addAll(
        List.of("--unshare-pid", "--unshare-ipc", "--unshare-uts", "--unshare-cgroup-try"));
    command.addAll(List.of("--hostname", "sandbox"));
    if (filter != null) {
      command.addAll(List.of("--seccomp", Integer.toString(LaunchScript.FILTER_DESCRIPTOR)));
    }
    if (!network) {
      command.add("--unshare-net");
    }
    if (users != null) {
      // Needed by the command that switches to the sandbox user, which then drops them.
      for (String capability : List.of("CAP_SETUID", "CAP_SETGID", "CAP_SETPCAP")) {
        command.addAll(List.of("--cap-add", capability));
      }
    } else {
      command.add("--unshare-user");
      if (disablesNamespaces) {
        command.add(DISABLE_NAMESPACES);
      }
    }
  }

  private @Nullable Path filterPath() {
    return filter == null ? null : filter.path();
  }

  private static String probe(List<String> command) throws IOException {
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    process.getOutputStream().close();
    try {
      String output =
          new String(process.getInputStream().readNBytes(20_000), StandardCharsets.UTF_8);
      if (!process.waitFor(PROBE_SECONDS, TimeUnit.SECONDS)) {
        throw new IOException("no exit within " + PROBE_SECONDS + " s");
      }
      if (process.exitValue() != 0) {
        throw new IOException(
            output
                .lines()
                .findFirst()
                .orElse("exit code " + process.exitValue() + " without output"));
      }
      return output;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    } finally {
      process.destroyForcibly();
    }
  }

  private static Optional<Path> findInPath(String name) {
    String path = System.getenv().getOrDefault("PATH", "/usr/bin:/bin");
    for (String folder : path.split(":")) {
      Path candidate = Path.of(folder.isEmpty() ? "." : folder, name).toAbsolutePath();
      if (Files.isExecutable(candidate)) {
        return Optional.of(candidate);
      }
    }
    return Optional.empty();
  }
}
