package org.sitaf.core.harness;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.FileTree;

/**
 * Compiles sources of a language with the tools of this machine.
 *
 * @param folder an empty folder for the sources
 */
public record LanguageCompiler(Language language, Path folder) {
  /** Whether the tools are installed. */
  public boolean isInstalled() {
    String program =
        switch (language) {
          case JAVA -> "java";
          case CPP -> "g++";
          case PYTHON -> "python3";
        };
    return Arrays.stream(System.getenv("PATH").split(File.pathSeparator))
        .anyMatch(bin -> Files.isExecutable(Path.of(bin, program)));
  }

  private void write(String path, byte[] content) throws IOException {
    Path file = folder.resolve(path);
    Files.createDirectories(file.getParent());
    Files.write(file, content);
  }

  /**
   * Writes component and harness to the folder and compiles them.
   *
   * @return the output of the compiler; empty if the sources compile
   */
  String compile(TestApplication application) throws IOException, InterruptedException {
    for (String path : application.harness().paths()) {
      write(path, application.harness().content(path).orElseThrow());
    }
    FileTree files = application.activity().files();
    for (String path : files.paths()) {
      write(path.substring("component/".length()), files.content(path).orElseThrow());
    }
    Path runtimes = Path.of("../../tba-agent").toAbsolutePath().normalize();
    List<String> command =
        switch (language) {
          case JAVA ->
              List.of(
                  Path.of(System.getProperty("java.home"), "bin", "javac").toString(),
                  "-proc:none",
                  "-Xmaxerrs",
                  "20",
                  "-encoding",
                  "UTF-8",
                  "-d",
                  folder.resolve("classes").toString(),
                  "-cp",
                  System.getProperty("java.class.path"));
          case CPP ->
              List.of(
                  "g++",
                  "-std=c++17",
                  "-fsyntax-only",
                  "-I",
                  folder.toString(),
                  "-I",
                  folder.resolve(application.entryPoint()).toString(),
                  "-I",
                  runtimes.resolve("runtime-cpp/include").toString());
          // Importing the entry point executes the other modules, but not its main function.
          case PYTHON ->
              List.of(
                  "python3",
                  "-W",
                  "error",
                  "-c",
                  "import sys; sys.path[:0] = sys.argv[1:3]; import " + application.entryPoint(),
                  folder.toString(),
                  runtimes.resolve("runtime-python/src").toString());
        };
    List<String> whole = new ArrayList<>(command);
    if (language == Language.JAVA) {
      try (Stream<Path> paths = Files.walk(folder)) {
        paths.map(Path::toString).filter(p -> p.endsWith(".java")).forEach(whole::add);
      }
    } else if (language == Language.CPP) {
      // As one unit, so that the headers are read once.
      StringBuilder all = new StringBuilder();
      application.harness().paths().stream()
          .filter(p -> p.endsWith(".cpp"))
          .forEach(p -> all.append("#include \"").append(p).append("\"\n"));
      Path unit = folder.resolve("all.cpp");
      Files.writeString(unit, all);
      whole.add(unit.toString());
    }
    Process compiler = new ProcessBuilder(whole).redirectErrorStream(true).start();
    String output = new String(compiler.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    return compiler.waitFor() == 0 ? "" : "failed: " + output;
  }
}
