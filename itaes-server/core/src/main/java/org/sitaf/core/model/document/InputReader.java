package org.sitaf.core.model.document;

import static org.sitaf.core.model.document.Problems.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sitaf.core.description.DataType;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.TestSpec;
import org.sitaf.core.model.Value;
import org.sitaf.schemas.TestElementType;

/** Reads the elements of {@code input_spec_list}. */
final class InputReader {
  /** The paper's Table 2 writes TDS for TDSD. */
  private static final Map<String, InputKind> KINDS =
      Map.of(
          "TDI", InputKind.TDI,
          "TDSD", InputKind.TDSD,
          "TDS", InputKind.TDSD,
          "TDTS", InputKind.TDTS);

  private final Problems problems;
  private final TestElementReader elements;

  InputReader(Problems problems) {
    this.problems = problems;
    this.elements = new TestElementReader(problems);
  }

  Optional<InputElement> read(TestElementType element) {
    String where = TestElementReader.where(element);
    String name = TestElementReader.name(element);
    int line = XmlDocuments.line(element);
    Optional<InputKind> kind = elements.kind(element, KINDS);
    if (element.getExpected() != null || element.getTolerance() != null) {
      problems.error(line, where, "expected and tolerance belong to elements of output_spec_list");
    }
    DataType declared = elements.type(element);
    // The name of a type alone does not say whether it is a struct or a sequence.
    DataType type =
        declared instanceof DataType.Unknown
                && TestElementReader.abstractType(element).equals("SEQUENCE")
            ? new DataType.Sequence(declared)
            : declared;
    TestSpecReader specReader = new TestSpecReader(problems, where + "/test_spec");
    List<TestSpec> specs = new ArrayList<>();
    element.getTestSpec().forEach(spec -> specReader.read(spec, type).ifPresent(specs::add));
    List<Value> userValues = new ArrayList<>();
    if (element.getUserValueList() != null) {
      for (String literal : element.getUserValueList().getValue()) {
        problems
            .attempt(
                line,
                where + "/user_value_list",
                () ->
                    kind.equals(Optional.of(InputKind.TDTS))
                        ? Value.parseAnswer(literal, type)
                        : Value.parse(literal, type))
            .ifPresent(userValues::add);
      }
    }
    boolean noUserValues =
        element.getUserValueList() == null || element.getUserValueList().getValue().isEmpty();
    boolean hasImpliedValues =
        TestElementReader.isBoolean(type) || TestElementReader.abstractType(element).equals("ENUM");
    if (element.getTestSpec().isEmpty() && noUserValues && !hasImpliedValues) {
      problems.error(line, where, "has no values; add a test_spec or a user_value_list");
    }
    if (name.isEmpty() || kind.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new InputElement(
            name,
            kind.get(),
            text(element.getRealType()),
            type,
            text(element.getDescription()),
            specs,
            userValues,
            line));
  }
}
