import java.io.FileOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.sitaf.core.activity.ActivityProfile.Language;

/** Measures simpler alternatives on the same machine for comparison. */
final class Alternatives {
  private static final int LINES = 50_000;
  private static final int READINGS = 200_000;
  private static final int ROUNDS = 5;

  private Alternatives() {}

  /** Writes results of typical length, one write per line; microseconds per line. */
  static double lineMicros(Path directory) throws Exception {
    byte[] line = ("x".repeat(249) + "\n").getBytes(StandardCharsets.UTF_8);
    Path file = directory.resolve("lines");
    double best = Double.MAX_VALUE;
    for (int round = 0; round < ROUNDS; round++) {
      try (FileOutputStream out = new FileOutputStream(file.toFile())) {
        long began = System.nanoTime();
        for (int i = 0; i < LINES; i++) {
          out.write(line);
        }
        best = Math.min(best, (System.nanoTime() - began) / 1e3 / LINES);
      }
    }
    Files.delete(file);
    return best;
  }

  /** Reading the monotonic clock twice, in microseconds. */
  static double clockMicros() {
    double best = Double.MAX_VALUE;
    for (int round = 0; round < ROUNDS; round++) {
      long sum = 0;
      long began = System.nanoTime();
      for (int i = 0; i < READINGS; i++) {
        sum -= System.nanoTime() - System.nanoTime();
      }
      long took = System.nanoTime() - began;
      if (sum < 0) {
        throw new IllegalStateException("the clock runs backwards");
      }
      best = Math.min(best, took / 1e3 / READINGS);
    }
    return best;
  }

  /** The compiler on the component's sources, as in a shell; in seconds. */
  static double compilerSeconds(Language language, Path example, Path runtimes, Path directory)
      throws Exception {
    Path out = Files.createDirectories(directory.resolve("compiler-" + language.id()));
    List<String> sources = new ArrayList<>();
    try (Stream<Path> files = Files.walk(example.resolve("component"))) {
      files
          .map(Path::toString)
          .filter(path -> path.matches(".*\\.(java|cpp|py)"))
          .sorted()
          .forEach(sources::add);
    }
    List<String> command =
        new ArrayList<>(
            switch (language) {
              case JAVA ->
                  List.of(
                      Path.of(System.getProperty("java.home"), "bin", "javac").toString(),
                      "-proc:none", "-d", out.toString(), "-cp", runtimes.resolve("runtime-java") + "/*");
              case CPP ->
                  List.of(
                      "c++", "-std=c++17", "-O1", "-g1", "-fPIC", "-c",
                      "-I", runtimes.resolve("runtime-cpp/include").toString());
              case PYTHON -> List.of("python3", "-m", "py_compile");
            });
    command.addAll(sources);
    List<Double> seconds = new ArrayList<>();
    for (int round = 0; round < ROUNDS; round++) {
      long began = System.nanoTime();
      ProcessBuilder builder = new ProcessBuilder(command).directory(out.toFile());
      builder.environment().put("PYTHONPYCACHEPREFIX", out.toString());
      int code =
          builder
              .redirectErrorStream(true)
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .start()
              .waitFor();
      if (code != 0) {
        throw new IllegalStateException(String.join(" ", command) + " ended with " + code);
      }
      seconds.add((System.nanoTime() - began) / 1e9);
    }
    seconds.sort(null);
    return seconds.get(ROUNDS / 2);
  }
}
