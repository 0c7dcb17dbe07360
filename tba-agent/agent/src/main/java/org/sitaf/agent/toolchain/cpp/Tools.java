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

/** Programs of this machine, asked for what they are; nothing of a user's is in it. */
final class Tools {
  private static final long PATIENCE_S = 20;

  private Tools() {}

  /** The first of these programs that the search path has; an absolute path is taken as it is. */
  static Optional<Path> find(String... names) {
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

  /** What a program says on its output; empty when it fails. */
  static Optional<String> ask(List<String> command) {
    return ask(new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD), false);
  }

  /** What a program says on its error stream; empty when it fails. */
  static Optional<String> askForErrors(List<String> command) {
    return ask(new ProcessBuilder(command).redirectOutput(ProcessBuilder.Redirect.DISCARD), true);
  }

  private static Optional<String> ask(ProcessBuilder command, boolean errors) {
    try {
      // What it says is read by programs.
      command.environment().put("LC_ALL", "C");
      Process process = command.start();
      process.getOutputStream().close();
      InputStream stream = errors ? process.getErrorStream() : process.getInputStream();
      String output = new String(stream.readAllBytes(), StandardCharsets.UTF_8);
      boolean ended = process.waitFor(PATIENCE_S, TimeUnit.SECONDS);
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
