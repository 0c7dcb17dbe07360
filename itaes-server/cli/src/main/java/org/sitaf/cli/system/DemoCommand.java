package org.sitaf.cli.system;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.spool.Folders;
import org.sitaf.cli.file.Installation;
import org.sitaf.cli.file.UserFiles;
import org.sitaf.cli.run.ResultTable;
import org.sitaf.cli.terminal.OnExit;
import org.sitaf.cli.terminal.ProgressLine;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.verdict.TestResult;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import tools.jackson.databind.JsonNode;

/** Runs the paper's evaluation (section 4) with server, agent and simulation. */
@Command(
    name = "demo",
    description =
        "Runs the paper's evaluation: tests the interface of an infrared sensor, with a"
            + " verdict for each case. Exit code 1: a case did not pass.",
    mixinStandardHelpOptions = true)
public final class DemoCommand implements Callable<Integer> {
  private static final String EXAMPLE = "ir-sensor";
  private static final String MODEL = "GetInfraredData";

  @Spec private @Nullable CommandSpec spec;

  @Option(names = "--keep", description = "Keeps server, agent and portal running until Ctrl-C.")
  private boolean keep;

  @Override
  public Integer call() throws IOException, InterruptedException {
    PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
    Installation installation = Installation.current();
    Path directory = Files.createTempDirectory("sitaf-demo-");
    try (OnExit onExit = new OnExit(Thread.currentThread()::interrupt)) {
      try (ProgressLine progress = new ProgressLine(System.err);
          LocalSystem system =
              LocalSystem.start(installation, directory, 0, 0, Map.of(), progress)) {
        int exitCode = evaluate(installation, system, progress, out);
        if (keep) {
          SignInLinks.printAndKeep(system, out);
          system.await();
        }
        return exitCode;
      } finally {
        Folders.delete(directory);
      }
    }
  }

  private int evaluate(
      Installation installation, LocalSystem system, ProgressLine progress, PrintWriter out)
      throws IOException, InterruptedException {
    ServerClient server = system.client();
    progress.step("Creating the activity from examples/ir-sensor");
    FileTree files = UserFiles.folder(installation.example(EXAMPLE));
    String activity = RemoteActivity.upload(server, null, EXAMPLE, files).id();
    String suites = "activities/" + activity + "/models/" + MODEL + "/suites";

    RemoteBuild builds = new RemoteBuild(server, progress);
    progress.step("Generating test cases");
    byte[] isolatedDocument = builds.build(suite(server.post(suites, Map.of()), progress, out));
    TestResult isolated = RemoteBuild.parse(isolatedDocument);
    byte[] combinedDocument =
        builds.build(suite(server.post(suites, Map.of("invalidValues", "combine")), progress, out));
    TestResult combined = RemoteBuild.parse(combinedDocument);

    progress.close();
    out.println();
    ResultTable.printCases(isolated, isolated.cases(), out);
    out.println();
    ResultTable.printSummary(isolated, out);
    out.println();
    out.println("With invalid values combined instead of isolated:");
    ResultTable.printSummary(combined, out);
    out.println();
    Path folder = Files.createDirectories(installation.state().resolve("demo"));
    Path file = folder.resolve(MODEL + ".xml");
    Files.write(file, isolatedDocument);
    Files.write(folder.resolve(MODEL + "-combined.xml"), combinedDocument);
    out.println("Results as XML: " + file + " and, with combined invalid values, next to it.");
    out.flush();
    return allPassed(isolated) && allPassed(combined) ? 0 : 1;
  }

  private static String suite(JsonNode suite, ProgressLine progress, PrintWriter out) {
    progress.close();
    out.println(
        "Generated "
            + suite.path("total").asInt()
            + " test cases: "
            + suite.path("valid").asInt()
            + " valid, "
            + suite.path("invalid").asInt()
            + " with an invalid value");
    out.flush();
    return suite.path("id").asString();
  }

  private static boolean allPassed(TestResult result) {
    return result.allPassed();
  }
}
