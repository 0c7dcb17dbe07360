package org.sitaf.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.sitaf.core.diagnostic.InvalidInputException;

/**
 * The installation that the launcher has set up.
 *
 * @param home the folder of the script {@code sitaf}
 */
public record Installation(Path home) {
  private static final String HOME = "sitaf.home";

  /**
   * The installation of this command.
   *
   * @throws InvalidInputException if the command was not started by the launcher
   */
  public static Installation current() {
    String home = System.getProperty(HOME);
    if (home == null) {
      throw InvalidInputException.of(
          "-D" + HOME, "is not set; start this command by ./sitaf, which sets it");
    }
    return new Installation(Path.of(home).toAbsolutePath());
  }

  /** The command that starts a simulation bridge; its arguments are appended. */
  public List<String> bridgeCommand() {
    return List.of(state().resolve("venv/bin/python").toString(), "-m", "sitaf_bridge");
  }

  /** The runtimes of test applications, one folder per language. */
  public Path runtimes() {
    return state().resolve("dist/agent");
  }

  /** The cache of builds. */
  public Path cache() {
    return state().resolve("cache");
  }

  /** The command that starts a server; its arguments are appended. */
  public List<String> serverCommand() {
    return java("server", "sitaf-server.jar");
  }

  /** The command that starts an agent; its arguments are appended. */
  public List<String> agentCommand() {
    List<String> command = new ArrayList<>(java("agent", "agent.jar"));
    command.add("--bridge-command");
    command.add(String.join(" ", bridgeCommand().stream().map(word -> "'" + word + "'").toList()));
    return command;
  }

  /** An example activity of the project. */
  public Path example(String name) {
    return home.resolve("examples").resolve(name);
  }

  /** The folder for files of commands. */
  public Path state() {
    return home.resolve(".sitaf");
  }

  private List<String> java(String part, String jar) {
    Path folder = state().resolve("dist").resolve(part);
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    Path archive = folder.resolve(part + ".jsa");
    if (Files.exists(archive)) {
      command.add("-XX:SharedArchiveFile=" + archive);
      command.add("-Xlog:disable");
      command.add("-Xlog:all=error:stderr");
    }
    command.add("-XX:TieredStopAtLevel=1");
    command.add("-jar");
    command.add(folder.resolve(jar).toString());
    return command;
  }
}
