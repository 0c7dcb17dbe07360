package org.sitaf.cli.file;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;

/**
 * The installation that the launcher has set up.
 *
 * @param home the folder of the script {@code sitaf}
 */
public record Installation(Path home) {
  private static final String HOME = "sitaf.home";

  /**
   * System property: whether started servers and agents write archives of the classes that they
   * load, when they end.
   */
  public static final String ARCHIVING = "sitaf.archiving";

  private static final Pattern ROS_FILE = Pattern.compile("\\w/(?:srv|action)/\\w");

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
    List<String> command = new ArrayList<>(java("server", "sitaf-server.jar"));
    command.add("--sitaf.ros-interfaces=" + rosInterfaces());
    command.add("--sitaf.documentation=" + state().resolve("book").resolve("site"));
    return command;
  }

  /** The command that starts an agent; its arguments are appended. */
  public List<String> agentCommand() {
    List<String> command = new ArrayList<>(java("agent", "agent.jar"));
    command.add("--bridge-command");
    command.add(String.join(" ", bridgeCommand().stream().map(word -> "'" + word + "'").toList()));
    return command;
  }

  /** The interface files of ROS 2, by package. */
  public Path rosInterfaces() {
    return state().resolve("ros2").resolve("jazzy");
  }

  /** Reads an activity, which may use the interface files of ROS 2. */
  public static Activity read(FileTree files) {
    String home = System.getProperty(HOME);
    String profile = files.text("activity.yaml").orElse("");
    boolean mayUse = profile.contains("ros2-") || ROS_FILE.matcher(profile).find();
    if (home == null || !mayUse) {
      return Activity.read(files);
    }
    Path folder = new Installation(Path.of(home).toAbsolutePath()).rosInterfaces();
    return Files.isDirectory(folder)
        ? Activity.read(files, UserFiles.folder(folder))
        : Activity.read(files);
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
    if (Boolean.getBoolean(ARCHIVING)) {
      command.add("-XX:ArchiveClassesAtExit=" + archive + ".new");
    } else if (Files.exists(archive)) {
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
