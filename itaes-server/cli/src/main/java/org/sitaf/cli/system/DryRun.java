package org.sitaf.cli.system;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.spool.Folders;
import org.sitaf.cli.Sitaf;
import org.sitaf.cli.file.Installation;
import org.sitaf.cli.file.UserFiles;
import org.sitaf.cli.terminal.ProgressLine;
import org.sitaf.core.activity.FileTree;

/**
 * Runs an example by the command line, and on a server with an agent, once per installation. The
 * classes that the three programs load are stored in class-data archives, which reduce their start
 * time.
 */
final class DryRun {
  private static final String EXAMPLE = "ir-sensor";

  private static final int LIMIT_MIN = 20;

  /** For writing an archive, on a slow machine. */
  private static final Duration STOP_LIMIT = Duration.ofMinutes(5);

  private DryRun() {}

  /** Takes no arguments; the exit code is not 0 if the example could not be run. */
  public static void main(String[] arguments) throws InterruptedException {
    System.setProperty(Installation.ARCHIVING, "true");
    Installation installation = Installation.current();
    // At the same time, because starting without archives and writing them takes long.
    ExecutorService executor = Executors.newSingleThreadExecutor();
    Future<@Nullable Void> system =
        executor.submit(
            () -> {
              onServer(installation);
              return null;
            });
    int exitCode =
        Sitaf.commandLine()
            .setOut(new PrintWriter(OutputStream.nullOutputStream()))
            .execute("run", installation.example(EXAMPLE).toString());
    try {
      system.get(LIMIT_MIN, TimeUnit.MINUTES);
    } catch (ExecutionException | TimeoutException e) {
      // Both end with this process.
      System.err.println("The server or its agent: " + e);
      exitCode = Sitaf.UNUSABLE;
    }
    System.exit(exitCode);
  }

  private static void onServer(Installation installation) throws IOException, InterruptedException {
    Path directory = Files.createTempDirectory("sitaf-dry-run-");
    try (ProgressLine progress = new ProgressLine(System.err)) {
      LocalSystem system = LocalSystem.start(installation, directory, 0, 0, Map.of(), progress);
      try {
        ServerClient server = system.client();
        FileTree files = UserFiles.folder(installation.example(EXAMPLE));
        String activity = RemoteActivity.upload(server, null, EXAMPLE, files).id();
        String suites = "activities/" + activity + "/models/GetInfraredData/suites";
        RemoteBuild build = new RemoteBuild(server, progress);
        build.build(server.post(suites, Map.of()).path("id").asString());
      } finally {
        system.close(STOP_LIMIT);
      }
    } finally {
      Folders.delete(directory);
    }
  }
}
