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
 * All processes of one test application, also those that outlived their parents: each inherits a
 * variable of the environment by which it is found. (On a system without {@code /proc} only
 * descendants are found.)
 */
public final class ProcessGroup {
  /** Variable of the environment. */
  static final String VARIABLE = "SITAF_RUN";

  private static final Path PROC = Path.of("/proc");
  private static final int MAX_ROUNDS = 20;

  private final String mark;

  /**
   * The processes whose mark begins so; an agent's own begin with its directory, so that it finds
   * what it left behind.
   */
  public ProcessGroup(String mark) {
    this.mark = Objects.requireNonNull(mark);
  }

  /** The mark for a folder's processes. */
  public static String markOf(Path directory) {
    return directory.toAbsolutePath().normalize() + "/";
  }

  String mark() {
    return mark;
  }

  /** Ends all processes of the group at once, and those that they start meanwhile. */
  public void kill() {
    // A cancelled build's thread may be interrupted, and then reads no file.
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
        if (holds(process.resolve("environ"), wanted)) {
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

  private static boolean holds(Path environ, byte[] wanted) {
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
      // It ended meanwhile, or is another user's.
      return false;
    }
  }
}
