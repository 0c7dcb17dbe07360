package org.sitaf.core.harness.java;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.harness.TestApplication;

/** Compiles a generated test application and runs it in its own process, like an agent. */
final class HarnessBuild {
  private final Path folder;

  HarnessBuild(Path folder) {
    this.folder = folder;
  }

  /** Creates files from their contents by path. */
  static FileTree tree(Map<String, String> texts) {
    Map<String, byte[]> files = new HashMap<>();
    texts.forEach((path, text) -> files.put(path, text.getBytes(StandardCharsets.UTF_8)));
    return FileTree.of(files);
  }

  /** The files of a folder. */
  static FileTree tree(Path root) throws IOException {
    Map<String, byte[]> files = new HashMap<>();
    try (Stream<Path> paths = Files.walk(root)) {
      for (Path path : paths.filter(Files::isRegularFile).toList()) {
        files.put(root.relativize(path).toString().replace('\\', '/'), Files.readAllBytes(path));
      }
    }
    return FileTree.of(files);
  }

  /** Compiles harness and component; javac must not report errors or warnings. */
  void compile(TestApplication application) throws IOException {
    FileTree files = application.files();
    files.paths().forEach(path -> write(path, files.content(path).orElseThrow()));
    List<String> arguments =
        new ArrayList<>(
            List.of(
                "-proc:none",
                "-encoding",
                "UTF-8",
                "--release",
                "17",
                "-Xlint:all",
                "-Werror",
                "-d"));
    arguments.add(folder.resolve("classes").toString());
    arguments.addAll(List.of("-cp", System.getProperty("java.class.path")));
    files.paths().stream()
        .filter(
            p ->
                p.endsWith(".java")
                    && (p.startsWith("harness/")
                        || p.startsWith("activity/component/")
                        || p.startsWith("activity/adapter/")))
        .forEach(p -> arguments.add(folder.resolve(p).toString()));
    JavaCompiler javac = ToolProvider.getSystemJavaCompiler();
    var messages = new java.io.ByteArrayOutputStream();
    int exit = javac.run(null, messages, messages, arguments.toArray(String[]::new));
    assertThat(exit).as(messages.toString(StandardCharsets.UTF_8)).isZero();
  }

  /** Runs the suite and returns the lines of results. */
  List<String> run(TestApplication application) throws IOException, InterruptedException {
    Path results = folder.resolve("results");
    Path errors = folder.resolve("errors");
    String classPath =
        folder.resolve("classes")
            + java.io.File.pathSeparator
            + System.getProperty("java.class.path");
    Process process =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                classPath,
                application.entryPoint(),
                "--suite",
                folder.resolve("suite.xml").toString(),
                "--results",
                results.toString())
            .redirectError(errors.toFile())
            .start();
    assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
    assertThat(process.exitValue()).as(Files.readString(errors)).isZero();
    return Files.readAllLines(results).stream().filter(line -> !line.isEmpty()).toList();
  }

  private void write(String path, byte[] content) {
    try {
      Path file = folder.resolve(path);
      Files.createDirectories(file.getParent());
      Files.write(file, content);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
