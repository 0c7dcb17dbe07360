package org.sitaf.server.suite;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.server.suite.SuiteView.CaseView;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.json.JsonMapper;

/** The cases of a suite as JSON: one object with the parameters and the cases. */
final class SuiteJson {
  private SuiteJson() {}

  /** The exported document. Values are literals, as in the XML document. */
  record Document(String name, String model, List<String> parameters, List<CaseView> cases) {}

  /** A case of an imported document; expected values are keyed by the name of the output. */
  record ImportedCase(
      int no,
      @Nullable Boolean valid,
      @Nullable List<String> values,
      @Nullable Map<String, String> expected,
      @Nullable List<ImportedStep> steps) {}

  /** A step of an imported sequence; inputs and expected values are keyed by their names. */
  record ImportedStep(
      @Nullable String name,
      @Nullable Boolean valid,
      @Nullable Map<String, String> inputs,
      @Nullable Map<String, String> expected) {}

  /** An imported document; other properties are ignored. */
  record ImportedDocument(@Nullable List<ImportedCase> cases) {}

  static byte[] write(TestSuite suite, JsonMapper json) {
    return json.writeValueAsBytes(
        new Document(
            suite.name(),
            suite.modelName(),
            suite.parameters().stream().map(CaseParameter::name).toList(),
            suite.cases().stream().map(c -> CaseView.of(c, suite)).toList()));
  }

  /** Returns the suite with the cases of a document. */
  static TestSuite read(byte[] document, TestSuite suite, JsonMapper json) {
    try {
      List<ImportedCase> cases = json.readValue(document, ImportedDocument.class).cases();
      if (cases == null) {
        throw InvalidInputException.of("the JSON document", "has no cases");
      }
      boolean oneOutput =
          cases.stream().allMatch(c -> c.expected() == null || c.expected().size() <= 1);
      return suite.withCases(cases.stream().map(c -> read(c, oneOutput, suite)).toList());
    } catch (JacksonException e) {
      throw InvalidInputException.of(
          "the JSON document", "cannot be read: " + e.getOriginalMessage());
    } catch (IllegalArgumentException e) {
      throw InvalidInputException.of("the JSON document", String.valueOf(e.getMessage()));
    }
  }

  private static TestCase read(ImportedCase testCase, boolean oneOutput, TestSuite suite) {
    List<ImportedStep> steps = testCase.steps() == null ? List.of() : testCase.steps();
    if (suite.isOfSequences() == steps.isEmpty()) {
      throw new IllegalArgumentException(
          "case "
              + testCase.no()
              + (steps.isEmpty()
                  ? " has no steps, but the suite consists of sequences"
                  : " has steps, but the suite consists of single calls"));
    }
    return new TestCase(
        testCase.no(),
        testCase.valid() == null || testCase.valid(),
        testCase.values() == null ? List.of() : testCase.values(),
        expected(testCase.expected(), oneOutput),
        steps.stream().map(step -> read(step, testCase.no(), suite)).toList());
  }

  private static TestStep read(ImportedStep step, int no, TestSuite suite) {
    String name = step.name() == null ? "" : step.name();
    Map<String, String> inputs = step.inputs() == null ? Map.of() : step.inputs();
    List<String> names = suite.stepParameters(name).stream().map(CaseParameter::name).toList();
    if (!inputs.keySet().equals(Set.copyOf(names))) {
      throw new IllegalArgumentException(
          "a step '"
              + name
              + "' of case "
              + no
              + " has the inputs "
              + inputs.keySet()
              + ", but its parameters are "
              + names);
    }
    return new TestStep(
        name,
        step.valid() == null || step.valid(),
        names.stream().map(inputs::get).toList(),
        expected(step.expected(), isUnnamed(name, suite)));
  }

  /** Whether the only output of a call has no name in the suite; also if no step tells. */
  private static boolean isUnnamed(String step, TestSuite suite) {
    return suite.cases().stream()
        .flatMap(c -> c.steps().stream())
        .filter(s -> s.name().equals(step))
        .flatMap(s -> s.expected().stream())
        .allMatch(e -> e.output().isEmpty());
  }

  /**
   * Expected values by output.
   *
   * @param oneOutput whether the value of a single output is kept without the output's name
   */
  private static List<ExpectedValue> expected(
      @Nullable Map<String, String> given, boolean oneOutput) {
    Map<String, String> expected = given == null ? new LinkedHashMap<>() : given;
    return expected.entrySet().stream()
        .map(e -> new ExpectedValue(oneOutput ? "" : e.getKey(), e.getValue()))
        .toList();
  }
}
