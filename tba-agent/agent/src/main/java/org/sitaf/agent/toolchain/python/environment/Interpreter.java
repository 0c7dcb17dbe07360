package org.sitaf.agent.toolchain.python.environment;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.TimeUnit;

/**
 * A Python of this machine that can create virtual environments.
 *
 * @param executable absolute path
 * @param version such as {@code 3.11.7}
 * @param prefixes folders of its library
 */
public record Interpreter(Path executable, String version, List<Path> prefixes) {
  private static final List<String> NAMES =
      List.of("python3", "python3.13", "python3.12", "python3.11", "python");
  private static final String QUERY =
      """
      import sys, venv, ensurepip
      if sys.version_info < (3, 11): sys.exit(3)
      print(sys.executable, "%d.%d.%d" % sys.version_info[:3], sys.base_prefix, sys.base_exec_prefix, sep="\\n")
      """;
  private static final long TIMEOUT_S = 20;

  public Interpreter {
    Objects.requireNonNull(executable);
    Objects.requireNonNull(version);
    prefixes = List.copyOf(prefixes);
  }

  /** The first one on the path that is new enough and complete. */
  public static Optional<Interpreter> find() {
    for (String name : NAMES) {
      try {
        Optional<Interpreter> answer = query(name);
        if (answer.isPresent()) {
          return answer;
        }
      } catch (IOException e) {
        // There is no program of this name.
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        return Optional.empty();
      }
    }
    return Optional.empty();
  }

  private static Optional<Interpreter> query(String name) throws IOException, InterruptedException {
    Process process =
        new ProcessBuilder(name, "-I", "-c", QUERY)
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    process.getOutputStream().close();
    List<String> lines =
        new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8)
            .lines()
            .toList();
    if (!process.waitFor(TIMEOUT_S, TimeUnit.SECONDS)) {
      process.destroyForcibly();
      return Optional.empty();
    }
    if (process.exitValue() != 0 || lines.size() != 4) {
      return Optional.empty();
    }
    List<Path> prefixes = new ArrayList<>();
    for (String line : lines.subList(2, 4)) {
      Path prefix = Path.of(line);
      if (!prefixes.contains(prefix)) {
        prefixes.add(prefix);
      }
    }
    return Optional.of(new Interpreter(Path.of(lines.get(0)), lines.get(1), prefixes));
  }
}
