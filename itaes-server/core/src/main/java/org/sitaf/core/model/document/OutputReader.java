package org.sitaf.core.model.document;

import static org.sitaf.core.model.document.Problems.number;
import static org.sitaf.core.model.document.Problems.text;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import org.sitaf.core.description.DataType;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.OutputKind;
import org.sitaf.core.model.Tolerance;
import org.sitaf.schemas.ExpectedFormulaType;
import org.sitaf.schemas.TestElementType;

/** Reads the elements of {@code output_spec_list}. */
final class OutputReader {
  private static final Map<String, OutputKind> KINDS =
      Map.of("RETURN", OutputKind.RETURN, "OUT", OutputKind.OUT, "OBSERVED", OutputKind.OBSERVED);

  private static final Pattern ERROR_NAME = Pattern.compile("\\w+");

  private final Problems problems;
  private final TestElementReader elements;

  OutputReader(Problems problems) {
    this.problems = problems;
    this.elements = new TestElementReader(problems);
  }

  Optional<OutputElement> read(TestElementType element) {
    String where = TestElementReader.where(element);
    String name = TestElementReader.name(element);
    int line = XmlDocuments.line(element);
    Optional<OutputKind> kind = elements.kind(element, KINDS);
    if (!element.getTestSpec().isEmpty() || element.getUserValueList() != null) {
      problems.error(
          line, where, "test_spec and user_value_list belong to elements of input_spec_list");
    }
    DataType type = elements.type(element);
    Tolerance tolerance = Tolerance.EXACT;
    if (element.getTolerance() != null) {
      var allowed = element.getTolerance();
      tolerance =
          problems
              .attempt(
                  line,
                  where + "/tolerance",
                  () ->
                      new Tolerance(
                          number(allowed.getAbsolute()),
                          number(allowed.getRelative()),
                          number(allowed.getUlp())))
              .orElse(Tolerance.EXACT);
    }
    if (name.isEmpty() || kind.isEmpty()) {
      return Optional.empty();
    }
    ExpectedFormulaType given = element.getExpected();
    String expected = given == null ? "" : text(given.getValue());
    List<String> orErrors = given == null ? List.of() : orErrors(given, expected, where);
    return Optional.of(
        new OutputElement(
            name,
            kind.get(),
            text(element.getRealType()),
            type,
            text(element.getDescription()),
            expected.isEmpty() ? null : expected,
            orErrors,
            tolerance,
            line,
            given == null || XmlDocuments.line(given) == 0 ? line : XmlDocuments.line(given)));
  }

  private List<String> orErrors(ExpectedFormulaType given, String expected, String where) {
    if (given.getOrError() == null) {
      return List.of();
    }
    List<String> names = List.of(text(given.getOrError()).split("\\s+"));
    for (String name : names) {
      if (!ERROR_NAME.matcher(name).matches()) {
        problems.error(
            XmlDocuments.line(given),
            where + "/expected",
            "or_error lists names of exceptions, separated by blanks, not '" + name + "'");
      }
    }
    if (expected.isEmpty()) {
      problems.error(
          XmlDocuments.line(given), where + "/expected", "or_error needs an expected value");
    }
    return names;
  }
}
