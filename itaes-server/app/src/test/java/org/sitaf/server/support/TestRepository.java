package org.sitaf.server.support;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/** A Git repository with a working tree, made by Git itself. */
public final class TestRepository {
  private static final int TIMEOUT_S = 60;

  private final Path folder;

  private TestRepository(Path folder) {
    this.folder = folder;
  }

  /** Creates a repository with the branch {@code main}. */
  public static TestRepository create(Path folder) {
    try {
      Files.createDirectories(folder);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    TestRepository repository = new TestRepository(folder);
    repository.git("init", "-q", "-b", "main");
    repository.git("config", "user.name", "Tester");
    repository.git("config", "user.email", "tester@example.org");
    repository.git("config", "http.receivepack", "true");
    return repository;
  }

  public Path folder() {
    return folder;
  }

  public String fileUrl() {
    return "file://" + folder;
  }

  public void write(String path, byte[] content) {
    try {
      Path file = folder.resolve(path);
      Files.createDirectories(file.getParent());
      Files.write(file, content);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  public void write(String path, String text) {
    write(path, text.getBytes(StandardCharsets.UTF_8));
  }

  public void write(String below, Map<String, byte[]> files) {
    files.forEach((path, content) -> write(below + "/" + path, content));
  }

  /** Commits everything and returns the id. */
  public String commit(String subject) {
    git("add", "-A");
    git("commit", "-q", "--allow-empty", "-m", subject);
    return git("rev-parse", "HEAD").strip();
  }

  /** Runs Git in the working tree, without the configuration of the user. */
  public String git(String... arguments) {
    List<String> command = new ArrayList<>(List.of("git"));
    command.addAll(List.of(arguments));
    ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
    builder.environment().put("GIT_CONFIG_GLOBAL", "/dev/null");
    builder.environment().put("GIT_CONFIG_SYSTEM", "/dev/null");
    builder.redirectErrorStream(true);
    try {
      Process process = builder.start();
      String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      if (!process.waitFor(TIMEOUT_S, TimeUnit.SECONDS) || process.exitValue() != 0) {
        throw new AssertionError(command + ": " + output);
      }
      return output;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(e);
    }
  }
}
