package org.sitaf.cli.explain;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.cli.file.Installation;
import org.sitaf.cli.file.UserFiles;
import org.sitaf.cli.option.SandboxOption;
import org.sitaf.cli.run.LocalBuilds;
import org.sitaf.cli.run.ResultTable;
import org.sitaf.cli.terminal.Printable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.ActivityArchive;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.explain.report.Bundle;
import org.sitaf.core.explain.report.RunRecord;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.suite.document.TestSuiteXml;
import org.sitaf.core.verdict.TestResult;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Runs the case of a bundle. */
@Command(
    name = "replay",
    description = {
      "Runs the case of a bundle of ./sitaf explain --bundles, and compares verdict and outputs"
          + " with those of the bundle.",
      "Exit code 0: they are equal; 1: they differ, and what else differs is printed; 2: the case"
          + " could not be executed."
    },
    mixinStandardHelpOptions = true)
public final class ReplayCommand implements Callable<Integer> {
  private static final int DIFFERS = 1;
  private static final int MAX_SHOWN = 3;
  private static final List<String> CONDITIONS =
      List.of("component", "harness", "simulator", "compiler", "packages", "machine");

  @Spec private @Nullable CommandSpec spec;

  @Parameters(paramLabel = "BUNDLE", description = "A zip of ./sitaf explain --bundles.")
  private Path file = Path.of("");

  @Mixin private final SandboxOption sandbox = new SandboxOption();

  @Override
  public Integer call() throws IOException, InterruptedException {
    PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
    PrintWriter err = spec.commandLine().getErr();
    if (Files.isDirectory(file)) {
      throw InvalidInputException.of(file.toString(), "is a folder; " + bundlesOf(file));
    }
    FileTree bundle;
    try (InputStream zip = new ByteArrayInputStream(UserFiles.file(file))) {
      bundle = ActivityArchive.read(zip, file.toString());
    }
    JsonNode recorded = recorded(bundle);
    Activity activity = Installation.read(bundle.below(Bundle.ACTIVITY));
    TestSuite suite =
        TestSuiteXml.read(
            new ByteArrayInputStream(
                bundle.content(Bundle.SUITE).orElseThrow(() -> missing(Bundle.SUITE))),
            Bundle.SUITE);
    TestModel model =
        activity
            .model(recorded.path("model").asString(""))
            .orElseThrow(() -> missing("the model " + recorded.path("model")));
    if (suite.cases().size() != 1 || suite.parameters().size() != model.inputs().size()) {
      throw InvalidInputException.of(
          file.toString(),
          "is no bundle: " + Bundle.SUITE + " must have one case of " + model.name());
    }
    TestResult result;
    try (LocalBuilds builds =
        new LocalBuilds(
            Installation.current(),
            sandbox.open(),
            false,
            new LocalBuilds.OutputFolders(null, null, false),
            activity.profile().world() == null ? 0 : 1)) {
      err.println("sandbox: " + builds.sandbox());
      err.flush();
      result =
          builds.completed(
              activity, builds.run(activity.withoutTiming(), model.withoutTiming(), suite));
    }
    ResultTable.printAll(result, out);
    return compare(recorded, RunRecord.of(result).entries(), out);
  }

  private static int compare(JsonNode recorded, Map<String, String> now, PrintWriter out) {
    boolean sameVerdict = isSame(recorded, now, RunRecord.VERDICT);
    boolean sameDigest = isSame(recorded, now, RunRecord.DIGEST);
    if (sameVerdict && sameDigest) {
      out.println("the verdict and the outputs are the same as in the bundle");
      out.flush();
      return 0;
    }
    out.println(
        sameVerdict
            ? "the verdict is the same as in the bundle, but the outputs differ"
            : "the verdict is "
                + now.get(RunRecord.VERDICT)
                + ", but "
                + Printable.line(recorded.path(RunRecord.VERDICT).asString(""))
                + " in the bundle");
    boolean any = false;
    for (String name : CONDITIONS) {
      // Bundles of earlier releases lack some of them.
      if (recorded.has(name) && !isSame(recorded, now, name)) {
        any = true;
        out.println(
            "  the "
                + name
                + " differs: "
                + Printable.line(recorded.path(name).asString(""))
                + " in the bundle, "
                + Printable.line(String.valueOf(now.get(name)))
                + " here");
      }
    }
    if (!any) {
      out.println(
          "  component, harness, simulator, compiler, packages and machine are the same, so the"
              + " case is not reproducible");
    }
    out.flush();
    return DIFFERS;
  }

  private static boolean isSame(JsonNode recorded, Map<String, String> now, String name) {
    return recorded.path(name).asString("").equals(now.get(name));
  }

  private JsonNode recorded(FileTree bundle) {
    String text = bundle.text(Bundle.RECORD).orElseThrow(() -> missing(Bundle.RECORD));
    try {
      return new JsonMapper().readTree(text);
    } catch (JacksonException e) {
      throw InvalidInputException.of(
          file.toString(), Bundle.RECORD + " is not JSON: " + e.getOriginalMessage());
    }
  }

  /** What to name instead of a folder. */
  private static String bundlesOf(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      List<String> bundles =
          files
              .map(Path::toString)
              .filter(name -> name.endsWith(".zip"))
              .sorted()
              .limit(MAX_SHOWN)
              .toList();
      return bundles.isEmpty()
          ? "name a zip that ./sitaf explain --bundles has written"
          : "name one of its bundles, such as " + String.join(", ", bundles);
    }
  }

  private InvalidInputException missing(String what) {
    return InvalidInputException.of(file.toString(), "is no bundle: " + what + " is missing");
  }
}
