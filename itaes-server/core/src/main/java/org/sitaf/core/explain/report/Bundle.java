package org.sitaf.core.explain.report;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.ByteArrayOutputStream;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.IntStream;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.explain.Explanation.Cause;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GivenCases;
import org.sitaf.core.suite.InputValidity;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.suite.document.TestSuiteXml;
import org.sitaf.core.value.TestValue;

/**
 * A bundle: the activity, a suite with the simplest case of a cause alone, what its execution gave,
 * and a README.md with the cause.
 */
public final class Bundle {
  public static final String ACTIVITY = "activity/";
  public static final String SUITE = "suite.xml";
  public static final String RECORD = "bundle.json";

  private Bundle() {}

  /**
   * A suite with the simplest case of a cause alone; empty if the case may not be executed.
   *
   * @param no number of the case
   */
  public static Optional<TestSuite> simplest(
      TestModel model, TestSuite suite, Cause cause, int no) {
    if (suite.isOfSequences()) {
      return Optional.empty();
    }
    InputValidity validity = new InputValidity(model, suite.generation().seed());
    List<InputElement> inputs = model.inputs();
    List<TestValue> row =
        IntStream.range(0, inputs.size())
            .mapToObj(
                i -> {
                  String literal =
                      Objects.requireNonNull(cause.simplest().get(inputs.get(i).name()));
                  return new TestValue(inputs.get(i).value(literal), validity.isValid(i, literal));
                })
            .toList();
    Optional<TestCase> testCase = new GivenCases(model).ofRow(no, row);
    return testCase.map(each -> suite.withCases(List.of(each)));
  }

  /**
   * The entries of {@link #RECORD}, in their order.
   *
   * @param executed what the execution of the case gave
   */
  public static Map<String, Object> record(TestModel model, TestSuite suite, RunRecord executed) {
    Map<String, Object> record = new LinkedHashMap<>();
    record.put("model", model.name());
    record.put("seed", suite.generation().seed());
    record.putAll(executed.entries());
    return record;
  }

  /**
   * The files of a bundle.
   *
   * @param activity the files of the activity
   * @param only the suite with one case
   * @param record {@link #record} as JSON
   * @param readme the text of README.md
   */
  public static FileTree files(FileTree activity, TestSuite only, byte[] record, String readme) {
    ByteArrayOutputStream document = new ByteArrayOutputStream();
    TestSuiteXml.write(only, document);
    return FileTree.of(Map.of())
        .with(ACTIVITY, activity)
        .with(SUITE, document.toByteArray())
        .with(RECORD, record)
        .with("README.md", readme.getBytes(UTF_8));
  }

  /**
   * The text of README.md.
   *
   * @param activity name of the activity
   * @param file name of the bundle
   */
  public static String readme(
      String activity, String model, Cause cause, CauseText sentences, String file) {
    StringBuilder text = new StringBuilder();
    text.append("# ").append(activity).append(": ").append(model);
    text.append("\n\nThe component ").append(sentences.sentence(cause)).append(".\n\n");
    text.append("| input | value |\n|---|---|\n");
    cause
        .simplest()
        .forEach(
            (name, value) ->
                text.append(
                    "| " + code(name, sentences) + " | " + code(value, sentences) + " |\n"));
    text.append("\n").append(cause.verdict()).append(":\n\n");
    cause
        .message()
        .lines()
        .forEach(line -> text.append("    ").append(sentences.shown(line)).append('\n'));
    text.append("\nRun it again with `./sitaf replay ").append(file).append("`.\n");
    return text.toString();
  }

  /** A cell of a table in Markdown, which no text can leave. */
  public static String code(String text, CauseText sentences) {
    return "`" + sentences.shown(text).replace('`', '\'').replace("|", "\\|") + "`";
  }
}
