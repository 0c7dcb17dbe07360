package org.sitaf.agent.toolchain.cpp;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;

/** Queries programs of this machine; passes no files of users. */
public final class Tools {
  private static final long TIMEOUT_S = 20;

  private Tools() {}

  /** The first of these programs in the search path; absolute paths are allowed. */
  public static Optional<Path> find(String... names) {
    for (String name : names) {
      for (String folder :
          System.getenv().getOrDefault("PATH", "/usr/bin:/bin").split(File.pathSeparator)) {
        Path program = Path.of(folder.isEmpty() ? "." : folder).resolve(name).toAbsolutePath();
        if (Files.isExecutable(program)) {
          return Optional.of(program);
        }
      }
    }
    return Optional.empty();
  }

  /** The output of a program; empty if it fails. */
  static Optional<String> outputOf(List<String> command) {
    return outputOf(
        new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD), false);
  }

  /** The error stream of a program; empty if it fails. */
  static Optional<String> errorsOf(List<String> command) {
    return outputOf(
        new ProcessBuilder(command).redirectOutput(ProcessBuilder.Redirect.DISCARD), true);
  }

  private static Optional<String> outputOf(ProcessBuilder command, boolean errors) {
    try {
      // Untranslated output, because it is parsed.
      command.environment().put("LC_ALL", "C");
      Process process = command.start();
      process.getOutputStream().close();
      InputStream stream = errors ? process.getErrorStream() : process.getInputStream();
      String output = new String(stream.readAllBytes(), StandardCharsets.UTF_8);
      boolean ended = process.waitFor(TIMEOUT_S, TimeUnit.SECONDS);
      if (!ended) {
        process.destroyForcibly();
      }
      return ended && process.exitValue() == 0 ? Optional.of(output.strip()) : Optional.empty();
    } catch (IOException e) {
      return Optional.empty();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return Optional.empty();
    }
  }
}
