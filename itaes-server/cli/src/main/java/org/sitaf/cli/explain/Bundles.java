package org.sitaf.cli.explain;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.BufferedOutputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sitaf.cli.run.LocalBuilds;
import org.sitaf.cli.terminal.Printable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.ActivityArchive;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.explain.Explanation;
import org.sitaf.core.explain.Explanation.Cause;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GivenCases;
import org.sitaf.core.suite.InputValidity;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.suite.document.TestSuiteXml;
import org.sitaf.core.value.TestValue;
import org.sitaf.core.verdict.TestResult;
import tools.jackson.databind.json.JsonMapper;

/**
 * Writes a bundle for each cause: the activity, a suite with the simplest case alone, what its
 * execution gave, and a README.md with the cause.
 */
record Bundles(
    LocalBuilds builds, Activity activity, FileTree files, TestModel model, TestSuite suite) {
  static final String ACTIVITY = "activity/";
  static final String SUITE = "suite.xml";
  static final String RECORD = "bundle.json";

  void write(Explanation explanation, Path folder, PrintWriter out)
      throws IOException, InterruptedException {
    Files.createDirectories(folder);
    int number = 1;
    for (Cause cause : explanation.causes()) {
      Optional<TestCase> testCase = testCase(cause);
      if (testCase.isEmpty()) {
        continue;
      }
      Path file = folder.resolve(model.name() + "-" + number++ + ".zip");
      TestSuite one = suite.withCases(List.of(testCase.get()));
      TestResult result = builds.completed(activity, builds.runQuietly(activity, model, one));
      ByteArrayOutputStream document = new ByteArrayOutputStream();
      TestSuiteXml.write(one, document);
      Map<String, Object> record = new LinkedHashMap<>();
      record.put("model", model.name());
      record.put("seed", suite.generation().seed());
      record.putAll(RunRecord.of(result).entries());
      FileTree bundle =
          FileTree.of(Map.of())
              .with(ACTIVITY, files)
              .with(SUITE, document.toByteArray())
              .with(
                  RECORD,
                  (new JsonMapper().writerWithDefaultPrettyPrinter().writeValueAsString(record)
                          + "\n")
                      .getBytes(UTF_8))
              .with("README.md", readme(cause, file).getBytes(UTF_8));
      try (OutputStream zip = new BufferedOutputStream(Files.newOutputStream(file))) {
        ActivityArchive.write(bundle, zip);
      }
      out.println("  bundle: " + file);
      out.flush();
    }
  }

  private Optional<TestCase> testCase(Cause cause) {
    InputValidity validity = new InputValidity(model, suite.generation().seed());
    List<InputElement> inputs = model.inputs();
    List<TestValue> row =
        java.util.stream.IntStream.range(0, inputs.size())
            .mapToObj(
                i -> {
                  String literal =
                      java.util.Objects.requireNonNull(cause.simplest().get(inputs.get(i).name()));
                  return new TestValue(inputs.get(i).value(literal), validity.isValid(i, literal));
                })
            .toList();
    return new GivenCases(model).ofRow(1, row);
  }

  private String readme(Cause cause, Path file) {
    StringBuilder text = new StringBuilder();
    text.append("# ").append(activity.profile().name()).append(": ").append(model.name());
    text.append("\n\nThe component ").append(ExplanationText.sentence(cause)).append(".\n\n");
    text.append("| input | value |\n|---|---|\n");
    cause
        .simplest()
        .forEach((name, value) -> text.append("| " + code(name) + " | " + code(value) + " |\n"));
    text.append("\n").append(cause.verdict()).append(":\n\n");
    text.append("    ").append(Printable.lines(cause.message(), "    ")).append('\n');
    text.append("\nRun it again with `./sitaf replay ").append(file.getFileName()).append("`.\n");
    return text.toString();
  }

  /** A cell of a table in Markdown, which no text can leave. */
  static String code(String text) {
    return "`" + Printable.line(text).replace('`', '\'').replace("|", "\\|") + "`";
  }
}
