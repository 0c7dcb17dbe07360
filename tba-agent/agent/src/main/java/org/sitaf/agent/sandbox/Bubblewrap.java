package org.sitaf.agent.sandbox;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Processes in namespaces of their own, made by bubblewrap: a read-only system, no network, nothing
 * of other processes, no file that is not named. Limits are those of {@code prlimit}. Where the
 * agent runs as root, the process runs as a user that exists nowhere else, because limits do not
 * bind root.
 */
final class Bubblewrap implements Sandbox {
  private static final String INSTALL = "apt-get install bubblewrap";
  private static final long PROBE_SECONDS = 20;

  /** Beyond those that distributions give away; each process has another one. */
  private static final int FIRST_USER = 847_000;

  private static final int USERS = 1000;
  private static final AtomicInteger NEXT_USER = new AtomicInteger();

  /** The monitor, the first process of its namespace, then the command. */
  private static final int GENERATIONS = 2;

  private final Path program;
  private final String version;
  private final boolean required;
  private final boolean root;

  private Bubblewrap(Path program, String version, boolean required, boolean root) {
    this.program = program;
    this.version = version;
    this.required = required;
    this.root = root;
  }

  /**
   * Looks for it and tries it out.
   *
   * @throws SandboxMissingException when it is not there or does not work here
   */
  static Bubblewrap find(boolean required) throws SandboxMissingException {
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
      String version = probe(List.of(program.toString(), "--version")).strip();
      Bubblewrap found = new Bubblewrap(program, version, required, isRoot());
      Path nowhere = Path.of("/");
      List<String> trial = new ArrayList<>();
      found.namespaces(trial, false);
      MountPlan.system().appendTo(trial);
      trial.addAll(List.of("--chdir", nowhere.toString(), "--"));
      found.rights(trial, ProcessLimits.TOOL);
      trial.add("/bin/true");
      probe(trial);
      return found;
    } catch (IOException e) {
      throw new SandboxMissingException(
          "bubblewrap does not work here ("
              + e.getMessage()
              + "); it needs user namespaces, or a start as root");
    }
  }

  @Override
  public String kind() {
    return version;
  }

  @Override
  public String description() {
    return version + (root ? ", each process as a user of its own" : "");
  }

  @Override
  public boolean isRequired() {
    return required;
  }

  @Override
  public ConfinedProcess start(Confinement confinement) throws IOException {
    List<String> command = new ArrayList<>();
    namespaces(command, confinement.network());
    MountPlan.of(confinement).appendTo(command);
    command.addAll(List.of("--chdir", confinement.working().toString(), "--"));
    int user = rights(command, confinement.limits());
    if (root) {
      Ownership.giveTo(user, confinement);
    }
    command.addAll(confinement.command());
    return ConfinedProcess.start(command, confinement, GENERATIONS);
  }

  private void namespaces(List<String> command, boolean network) {
    command.add(program.toString());
    command.addAll(List.of("--die-with-parent", "--new-session"));
    command.addAll(
        List.of("--unshare-pid", "--unshare-ipc", "--unshare-uts", "--unshare-cgroup-try"));
    command.addAll(List.of("--hostname", "sandbox"));
    if (!network) {
      command.add("--unshare-net");
    }
    if (root) {
      // What the command before the component needs to become another user; it gives them up then.
      for (String capability : List.of("CAP_SETUID", "CAP_SETGID", "CAP_SETPCAP")) {
        command.addAll(List.of("--cap-add", capability));
      }
    } else {
      command.add("--unshare-user");
    }
  }

  /** What limits the process and takes its rights away, before it begins; returns its user. */
  private int rights(List<String> command, ProcessLimits limits) {
    command.addAll(
        List.of(
            "prlimit",
            "--core=0",
            "--nofile=4096",
            "--nproc=" + limits.processes(),
            "--fsize=" + ((long) limits.fileMiB() << 20),
            "--data=" + limits.dataBytes(),
            "--cpu=" + limits.cpuSeconds(),
            "--"));
    int user = FIRST_USER + Math.floorMod(NEXT_USER.getAndIncrement(), USERS);
    if (root) {
      command.addAll(
          List.of(
              "setpriv",
              "--reuid=" + user,
              "--regid=" + user,
              "--clear-groups",
              "--inh-caps=-all",
              "--bounding-set=-all",
              "--no-new-privs",
              "--"));
    }
    return user;
  }

  private static boolean isRoot() throws IOException {
    return probe(List.of("id", "-u")).strip().equals("0");
  }

  private static String probe(List<String> command) throws IOException {
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    process.getOutputStream().close();
    try {
      String said = new String(process.getInputStream().readNBytes(2000), StandardCharsets.UTF_8);
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
