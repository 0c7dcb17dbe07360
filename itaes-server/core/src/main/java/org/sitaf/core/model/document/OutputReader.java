package org.sitaf.core.model.document;

import static org.sitaf.core.model.document.Problems.number;
import static org.sitaf.core.model.document.Problems.text;

import java.util.Map;
import java.util.Optional;
import org.sitaf.core.description.DataType;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.OutputKind;
import org.sitaf.core.model.Tolerance;
import org.sitaf.schemas.TestElementType;

/** Reads the elements of {@code output_spec_list}. */
final class OutputReader {
  private static final Map<String, OutputKind> KINDS =
      Map.of("RETURN", OutputKind.RETURN, "OUT", OutputKind.OUT, "OBSERVED", OutputKind.OBSERVED);

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
      var given = element.getTolerance();
      tolerance =
          problems
              .attempt(
                  line,
                  where + "/tolerance",
                  () ->
                      new Tolerance(
                          number(given.getAbsolute()),
                          number(given.getRelative()),
                          number(given.getUlp())))
              .orElse(Tolerance.EXACT);
    }
    if (name.isEmpty() || kind.isEmpty()) {
      return Optional.empty();
    }
    String expected = text(element.getExpected());
    return Optional.of(
        new OutputElement(
            name,
            kind.get(),
            text(element.getRealType()),
            type,
            text(element.getDescription()),
            expected.isEmpty() ? null : expected,
            tolerance,
            line));
  }
}
