package org.sitaf.agent.sandbox;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;

/**
 * All processes of one test application, including those that outlived their parents. They are
 * found by an inherited environment variable. On systems without {@code /proc} nothing is found.
 */
public final class ProcessGroup {
  /** Name of the environment variable. */
  static final String VARIABLE = "SITAF_RUN";

  private static final Path PROC = Path.of("/proc");
  private static final int MAX_ROUNDS = 20;

  private final String mark;

  /**
   * The processes whose mark starts with the given one. The marks of an agent's processes start
   * with the agent's directory, so a restarted agent finds the processes of the previous run.
   */
  public ProcessGroup(String mark) {
    this.mark = Objects.requireNonNull(mark);
  }

  /** The mark for the processes of a folder. */
  public static String markOf(Path directory) {
    return directory.toAbsolutePath().normalize() + "/";
  }

  String mark() {
    return mark;
  }

  /** Kills all processes of the group, including those started meanwhile. */
  public void kill() {
    // The thread of a cancelled build may be interrupted, and an interrupted thread cannot read
    // files.
    boolean interrupted = Thread.interrupted();
    List<ProcessHandle> members = members();
    for (int round = 0; round < MAX_ROUNDS && !members.isEmpty(); round++) {
      members.forEach(ProcessHandle::destroyForcibly);
      members = members();
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  private List<ProcessHandle> members() {
    byte[] wanted = (VARIABLE + "=" + mark).getBytes(StandardCharsets.UTF_8);
    List<ProcessHandle> members = new ArrayList<>();
    try (DirectoryStream<Path> processes = Files.newDirectoryStream(PROC, "[0-9]*")) {
      for (Path process : processes) {
        if (hasVariable(process.resolve("environ"), wanted)) {
          ProcessHandle.of(Long.parseLong(process.getFileName().toString()))
              .filter(ProcessHandle::isAlive)
              .ifPresent(members::add);
        }
      }
    } catch (IOException | DirectoryIteratorException e) {
      return members;
    }
    return members;
  }

  private static boolean hasVariable(Path environ, byte[] wanted) {
    try {
      byte[] content = Files.readAllBytes(environ);
      int start = 0;
      for (int i = 0; i <= content.length; i++) {
        if (i == content.length || content[i] == 0) {
          if (i - start >= wanted.length
              && java.util.Arrays.equals(
                  content, start, start + wanted.length, wanted, 0, wanted.length)) {
            return true;
          }
          start = i + 1;
        }
      }
      return false;
    } catch (IOException e) {
      // The process has ended or belongs to another user.
      return false;
    }
  }
}
