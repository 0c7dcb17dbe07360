package org.sitaf.cli.begin;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.sitaf.agent.spool.Folders;
import org.sitaf.cli.file.Installation;
import org.sitaf.cli.file.UserFiles;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;

/**
 * The world that the simulation bridge proposes for a robot.
 *
 * @param path path of the world description in the activity
 * @param files the description and the robot's files
 */
record RobotWorld(String path, FileTree files) {
  private static final String FOLDER = "world";
  private static final int MAX_SECONDS = 180;

  /** No robot, and no world. */
  static RobotWorld of(Path robot, Installation installation)
      throws IOException, InterruptedException {
    Path temporary = Files.createTempDirectory("sitaf-new-");
    try {
      Path into = temporary.resolve(FOLDER);
      Path messages = temporary.resolve("messages");
      List<String> command = new ArrayList<>(installation.bridgeCommand());
      command.addAll(List.of("propose", robot.toAbsolutePath().toString(), "--into", "" + into));
      ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
      builder.redirectInput(ProcessBuilder.Redirect.from(Path.of("/dev/null").toFile()));
      builder.redirectOutput(messages.toFile());
      Process process = builder.start();
      boolean ended = process.waitFor(MAX_SECONDS, TimeUnit.SECONDS);
      if (!ended) {
        process.destroyForcibly();
      }
      String said = Files.readString(messages, StandardCharsets.UTF_8).strip();
      if (!ended || process.exitValue() != 0) {
        throw InvalidInputException.of(
            "--robot " + robot,
            ended ? said : "its world takes longer than " + MAX_SECONDS + " s; simplify the model");
      }
      FileTree files = FileTree.of(Map.of()).with(FOLDER, UserFiles.folder(into));
      String description = said.substring(said.lastIndexOf('\n') + 1);
      return new RobotWorld(FOLDER + "/" + description, files);
    } finally {
      Folders.delete(temporary);
    }
  }
}
