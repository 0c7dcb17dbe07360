package org.sitaf.server.suite;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.TestCase;
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
      @Nullable Map<String, String> expected) {}

  /** An imported document; other properties are ignored. */
  record ImportedDocument(@Nullable List<ImportedCase> cases) {}

  static byte[] write(TestSuite suite, JsonMapper json) {
    return json.writeValueAsBytes(
        new Document(
            suite.name(),
            suite.modelName(),
            suite.parameters().stream().map(CaseParameter::name).toList(),
            suite.cases().stream().map(CaseView::of).toList()));
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
      return suite.withCases(cases.stream().map(c -> read(c, oneOutput)).toList());
    } catch (JacksonException e) {
      throw InvalidInputException.of(
          "the JSON document", "cannot be read: " + e.getOriginalMessage());
    } catch (IllegalArgumentException e) {
      throw InvalidInputException.of("the JSON document", String.valueOf(e.getMessage()));
    }
  }

  private static TestCase read(ImportedCase testCase, boolean oneOutput) {
    Map<String, String> expected =
        testCase.expected() == null ? new LinkedHashMap<>() : testCase.expected();
    return new TestCase(
        testCase.no(),
        testCase.valid() == null || testCase.valid(),
        testCase.values() == null ? List.of() : testCase.values(),
        expected.entrySet().stream()
            .map(e -> new ExpectedValue(oneOutput ? "" : e.getKey(), e.getValue()))
            .toList());
  }
}
