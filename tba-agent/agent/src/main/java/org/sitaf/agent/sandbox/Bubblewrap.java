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
 * Processes in namespaces of their own, made by bubblewrap: a read-only system, no network, nothing
 * of other processes, no file that is not named, no system call that other people's code does not
 * need. Limits are those of control groups, where this machine gives some, and of {@code prlimit}.
 * Where the agent runs as root, the process runs as a user that exists nowhere else, because limits
 * do not bind root.
 */
final class Bubblewrap implements Sandbox {
  private static final String INSTALL = "apt-get install bubblewrap";
  private static final String DISABLE_NAMESPACES = "--disable-userns";
  private static final long PROBE_SECONDS = 20;

  /** The monitor, the first process of its namespace, then the command. */
  private static final int GENERATIONS = 2;

  private final Path program;
  private final String version;
  private final boolean required;
  private final ControlGroups groups;
  private final @Nullable SystemCallFilter filter;
  private final Rights rights = Rights.ofThisProcess();

  /** Null where the agent is not root. */
  private final @Nullable SandboxUsers users;

  private final boolean disablesNamespaces;

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
  }

  /**
   * Looks for it and tries it out.
   *
   * @throws SandboxMissingException when it is not there or does not work here, or cannot do what
   *     is required
   */
  static Bubblewrap find(boolean required) throws SandboxMissingException {
    return find(required, ControlGroups.ofThisMachine(), true);
  }

  /** As {@link #find(boolean)}, with these control groups, and perhaps without a filter. */
  static Bubblewrap find(boolean required, ControlGroups groups, boolean filtered)
      throws SandboxMissingException {
    Path program =
        inPath("bwrap")
            .orElseThrow(
                () ->
                    new SandboxMissingException(
                        "bubblewrap is not installed; install it with: " + INSTALL));
    for (String tool : List.of("prlimit", "setpriv")) {
      if (inPath(tool).isEmpty()) {
        throw new SandboxMissingException(
            tool + " is not installed; install it with: apt-get install util-linux");
      }
    }
    try {
      Optional<SystemCallFilter> filter =
          filtered
              ? SystemCallFilter.of(groups.bindMemory(), groups.shareProcessors())
              : Optional.empty();
      Bubblewrap found = new Bubblewrap(program, required, groups, filter.orElse(null));
      if (required && !found.bindsMemory()) {
        throw new SandboxMissingException(
            "the memory of components cannot be bounded: "
                + groups.description()
                + ", and there is no filter of system calls for "
                + System.getProperty("os.arch")
                + " that would keep memory where it can be counted");
      }
      probe(found.trial());
      return found;
    } catch (SandboxMissingException e) {
      throw e;
    } catch (IOException e) {
      throw new SandboxMissingException(
          "bubblewrap does not work here ("
              + e.getMessage()
              + "); it needs user namespaces, or a start as root");
    }
  }

  private List<String> trial() throws IOException {
    List<String> command = Entry.before(ControlGroup.NONE, filterPath());
    namespaces(command, false);
    MountPlan.system().appendTo(command);
    command.addAll(List.of("--chdir", "/", "--"));
    command.addAll(rights.limit(ProcessLimits.TOOL));
    if (users != null) {
      command.addAll(Rights.become(users.first()));
    }
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
      text.append(", each process as a user of its own (")
          .append(users.first())
          .append(" to ")
          .append(users.last())
          .append(')');
    }
    if (groups.bindMemory()) {
      text.append(", ").append(groups.description());
    } else if (bindsMemory()) {
      text.append(", memory is watched from outside: ").append(groups.description());
    } else {
      text.append(", MEMORY IS NOT BOUNDED: ").append(groups.description());
    }
    if (filter == null) {
      text.append(", SYSTEM CALLS ARE NOT FILTERED on ").append(System.getProperty("os.arch"));
    }
    if (!groups.shareProcessors() && (filter == null || !AutomaticGroups.shareProcessors())) {
      text.append(", PROCESSORS ARE NOT SHARED OUT");
    }
    return text.toString();
  }

  @Override
  public boolean isRequired() {
    return required;
  }

  private boolean bindsMemory() {
    return groups.bindMemory() || filter != null;
  }

  @Override
  public ConfinedProcess start(Confinement confinement) throws IOException {
    ControlGroup group = groups.make(confinement.limits().ofGroup());
    int user = -1;
    try {
      user = users == null ? -1 : users.take();
      List<String> command = command(confinement, group, user);
      if (user >= 0) {
        Ownership.giveTo(user, confinement);
      }
      int taken = user;
      return ConfinedProcess.start(
          command, confinement, Map.of(), group, GENERATIONS, () -> release(taken));
    } catch (IOException | RuntimeException e) {
      group.remove();
      release(user);
      throw e;
    }
  }

  private List<String> command(Confinement confinement, ControlGroup group, int user)
      throws IOException {
    List<String> command = Entry.before(group, filterPath());
    namespaces(command, confinement.network());
    MountPlan.of(confinement, group.bindsMemory()).appendTo(command);
    command.addAll(List.of("--chdir", confinement.working().toString(), "--"));
    command.addAll(rights.limit(confinement.limits()));
    if (user >= 0) {
      command.addAll(Rights.become(user));
    }
    command.addAll(Rights.with(confinement.environment(), confinement.command()));
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
      command.addAll(List.of("--seccomp", Integer.toString(Entry.FILTER)));
    }
    if (!network) {
      command.add("--unshare-net");
    }
    if (users != null) {
      // What the command before the component needs to become another user; it gives them up then.
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
      String said = new String(process.getInputStream().readNBytes(20_000), StandardCharsets.UTF_8);
      if (!process.waitFor(PROBE_SECONDS, TimeUnit.SECONDS)) {
        throw new IOException("it does not end");
      }
      if (process.exitValue() != 0) {
        throw new IOException(said.lines().findFirst().orElse("it ends without a word"));
      }
      return said;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    } finally {
      process.destroyForcibly();
    }
  }

  private static Optional<Path> inPath(String name) {
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
