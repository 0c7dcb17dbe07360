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

  /** The document. Values are literals, as in the XML document. */
  record Document(String name, String model, List<String> parameters, List<CaseView> cases) {}

  /** A case as people write it: what is expected is absent or by the name of the output. */
  record Line(
      int no,
      @Nullable Boolean valid,
      @Nullable List<String> values,
      @Nullable Map<String, String> expected) {}

  /** What is read of a document. */
  record Lines(@Nullable List<Line> cases) {}

  static byte[] write(TestSuite suite, JsonMapper json) {
    return json.writeValueAsBytes(
        new Document(
            suite.name(),
            suite.modelName(),
            suite.parameters().stream().map(CaseParameter::name).toList(),
            suite.cases().stream().map(CaseView::of).toList()));
  }

  /** Reads cases into the place of a suite's. */
  static TestSuite read(byte[] document, TestSuite suite, JsonMapper json) {
    try {
      List<Line> lines = json.readValue(document, Lines.class).cases();
      if (lines == null) {
        throw InvalidInputException.of("the JSON document", "has no cases");
      }
      boolean one = lines.stream().allMatch(l -> l.expected() == null || l.expected().size() <= 1);
      return suite.withCases(lines.stream().map(l -> read(l, one)).toList());
    } catch (JacksonException e) {
      throw InvalidInputException.of(
          "the JSON document", "cannot be read: " + e.getOriginalMessage());
    } catch (IllegalArgumentException e) {
      throw InvalidInputException.of("the JSON document", String.valueOf(e.getMessage()));
    }
  }

  private static TestCase read(Line line, boolean oneOutput) {
    Map<String, String> expected =
        line.expected() == null ? new LinkedHashMap<>() : line.expected();
    return new TestCase(
        line.no(),
        line.valid() == null || line.valid(),
        line.values() == null ? List.of() : line.values(),
        expected.entrySet().stream()
            .map(e -> new ExpectedValue(oneOutput ? "" : e.getKey(), e.getValue()))
            .toList());
  }
}
