package org.sitaf.core.model;

import java.math.BigDecimal;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.description.TypeGrammar;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.document.ElementLines;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.schemas.CaseType;
import org.sitaf.schemas.ConditionType;
import org.sitaf.schemas.StrengthType;
import org.sitaf.schemas.TargetType;
import org.sitaf.schemas.TestElementType;
import org.sitaf.schemas.TestModelDocument;

/** Converts the parsed document to a {@link TestModel} and reports all contradictions. */
final class TestModelReader {
  /** The paper's Table 2 writes TDS for TDSD. */
  private static final Map<String, InputKind> INPUT_KINDS =
      Map.of(
          "TDI", InputKind.TDI,
          "TDSD", InputKind.TDSD,
          "TDS", InputKind.TDSD,
          "TDTS", InputKind.TDTS);

  private static final Map<String, OutputKind> OUTPUT_KINDS =
      Map.of("RETURN", OutputKind.RETURN, "OUT", OutputKind.OUT, "OBSERVED", OutputKind.OBSERVED);

  static final String PRE_CONDITION = "pre_condition";
  static final String POST_CONDITION = "post_condition";

  private final String file;
  private final Diagnostics diagnostics;
  private final ElementLines lines;

  /**
   * @param lines of conditions
   */
  TestModelReader(String file, Diagnostics diagnostics, ElementLines lines) {
    this.file = file;
    this.diagnostics = diagnostics;
    this.lines = lines;
  }

  TestModel read(TestModelDocument root) {
    int line = XmlDocuments.line(root);
    String name = root.getName() == null ? "" : root.getName();
    if (!name.matches("[A-Za-z0-9][A-Za-z0-9._-]{0,99}")) {
      diagnostics.error(
          file,
          line,
          "name",
          (name.isEmpty() ? "is missing" : "'" + name + "' is not a name")
              + "; use letters, digits, '.', '_' and '-', at most 100 characters");
    }
    if (root.getInputSpecList() == null) {
      diagnostics.error(file, line, "input_spec_list", "is missing");
    }
    List<InputElement> inputs = new ArrayList<>();
    List<OutputElement> outputs = new ArrayList<>();
    if (root.getInputSpecList() != null) {
      root.getInputSpecList().getTestElement().forEach(e -> input(e).ifPresent(inputs::add));
    }
    if (root.getOutputSpecList() != null) {
      root.getOutputSpecList().getTestElement().forEach(e -> output(e).ifPresent(outputs::add));
    }
    checkUniqueNames(
        inputs.stream().map(InputElement::name).toList(),
        inputs.stream().map(InputElement::line).toList());
    checkUniqueNames(
        outputs.stream().map(OutputElement::name).toList(),
        outputs.stream().map(OutputElement::line).toList());
    return new TestModel(
        name,
        text(root.getDescription()),
        target(root.getTarget(), name),
        conditions(
            PRE_CONDITION,
            root.getPreConditionSpecList() == null
                ? List.of()
                : root.getPreConditionSpecList().getPreCondition()),
        inputs,
        outputs,
        conditions(
            POST_CONDITION,
            root.getPostConditionSpecList() == null
                ? List.of()
                : root.getPostConditionSpecList().getPostCondition()),
        invalidValues(root.getInvalidValues(), line),
        strength(root.getOrderOfCombinations(), "order_of_combinations", line),
        root.getStrength().stream().map(s -> mixed(s, inputs)).toList(),
        root.getCaseList() == null ? List.of() : keptCases(root.getCaseList().getCases(), inputs),
        file);
  }

  private Optional<InputElement> input(TestElementType element) {
    String where = where(element);
    int line = XmlDocuments.line(element);
    Optional<InputKind> kind = kind(element, INPUT_KINDS);
    if (element.getExpected() != null || element.getTolerance() != null) {
      diagnostics.error(
          file, line, where, "expected and tolerance belong to elements of output_spec_list");
    }
    DataType type = type(element, where, line);
    TestSpec spec =
        element.getTestSpec() == null
            ? null
            : new TestSpecReader(file, where + "/test_spec", diagnostics)
                .read(element.getTestSpec(), type)
                .orElse(null);
    List<Value> userValues = new ArrayList<>();
    if (element.getUserValueList() != null) {
      for (String literal : element.getUserValueList().getValue()) {
        attempt(
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
    boolean hasImpliedValues = isBoolean(type) || "ENUM".equals(abstractType(element));
    if (element.getTestSpec() == null && noUserValues && !hasImpliedValues) {
      diagnostics.error(file, line, where, "has no values; add a test_spec or a user_value_list");
    }
    if (name(element).isEmpty() || kind.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new InputElement(
            name(element),
            kind.get(),
            text(element.getRealType()),
            type,
            text(element.getDescription()),
            spec,
            userValues,
            line));
  }

  private Optional<OutputElement> output(TestElementType element) {
    String where = where(element);
    int line = XmlDocuments.line(element);
    Optional<OutputKind> kind = kind(element, OUTPUT_KINDS);
    if (element.getTestSpec() != null || element.getUserValueList() != null) {
      diagnostics.error(
          file, line, where, "test_spec and user_value_list belong to elements of input_spec_list");
    }
    DataType type = type(element, where, line);
    Tolerance tolerance = Tolerance.EXACT;
    if (element.getTolerance() != null) {
      var given = element.getTolerance();
      tolerance =
          attempt(
                  line,
                  where + "/tolerance",
                  () ->
                      new Tolerance(
                          number(given.getAbsolute()),
                          number(given.getRelative()),
                          number(given.getUlp())))
              .orElse(Tolerance.EXACT);
    }
    if (name(element).isEmpty() || kind.isEmpty()) {
      return Optional.empty();
    }
    String expected = text(element.getExpected());
    return Optional.of(
        new OutputElement(
            name(element),
            kind.get(),
            text(element.getRealType()),
            type,
            text(element.getDescription()),
            expected.isEmpty() ? null : expected,
            tolerance,
            line));
  }

  private <K> Optional<K> kind(TestElementType element, Map<String, K> kinds) {
    Optional<K> kind = Optional.ofNullable(kinds.get(text(element.getType())));
    if (kind.isEmpty()) {
      diagnostics.error(
          file,
          XmlDocuments.line(element),
          where(element) + "/type",
          "must be one of "
              + String.join(", ", new TreeSet<>(kinds.keySet()))
              + ", not '"
              + element.getType()
              + "'");
    }
    return kind;
  }

  private DataType type(TestElementType element, String where, int line) {
    if (name(element).isEmpty()) {
      diagnostics.error(file, line, where + "/name", "is missing");
    }
    if (element.getRealType() == null) {
      diagnostics.error(file, line, where, "has no real_type, such as int or double");
      return new DataType.Unknown("");
    }
    DataType type = TypeGrammar.parse(element.getRealType()).type();
    String abstractType = abstractType(element);
    boolean fits =
        switch (abstractType) {
          case "NUMERIC" -> !(type instanceof DataType.Scalar s) || isNumber(s.type());
          case "STRING" ->
              !(type instanceof DataType.Scalar s)
                  || s.type() == ScalarType.STRING
                  || s.type() == ScalarType.CHAR;
          case "BOOLEAN" -> isBoolean(type) || type instanceof DataType.Unknown;
          case "VOID" -> type.isVoid();
          case "ENUM", "STRUCT", "SEQUENCE" -> true;
          default -> {
            diagnostics.error(
                file,
                line,
                where,
                "abstract_type must be NUMERIC, STRING, BOOLEAN, ENUM or VOID, not '"
                    + element.getAbstractType()
                    + "'");
            yield true;
          }
        };
    if (!fits) {
      diagnostics.error(
          file,
          line,
          where,
          "abstract_type "
              + abstractType
              + " and real_type "
              + element.getRealType()
              + " contradict each other");
    }
    return type;
  }

  private Target target(@Nullable TargetType target, String modelName) {
    if (target == null) {
      return new Target(null, modelName, null, Duration.ZERO, Duration.ZERO);
    }
    int line = XmlDocuments.line(target);
    return new Target(
        target.getInterface(),
        target.getMethod() == null ? modelName : target.getMethod(),
        target.getSignature(),
        seconds(target.getSettle(), "target/settle", line),
        seconds(target.getRunFor(), "target/run_for", line));
  }

  private Duration seconds(@Nullable String text, String where, int line) {
    return attempt(
            line,
            where,
            () -> {
              double seconds = number(text);
              if (seconds < 0 || seconds > 1e6) {
                throw new IllegalArgumentException("must be 0 to 1000000 seconds");
              }
              return Duration.ofNanos(Math.round(seconds * 1e9));
            })
        .orElse(Duration.ZERO);
  }

  private List<Condition> conditions(String element, List<ConditionType> conditions) {
    List<Condition> found = new ArrayList<>();
    for (int i = 0; i < conditions.size(); i++) {
      String expression = conditions.get(i).getValue();
      if (expression != null && !expression.isBlank()) {
        found.add(new Condition(expression.strip(), lines.of(element, i)));
      }
    }
    return found;
  }

  private InvalidValues invalidValues(@Nullable String text, int line) {
    return switch (text == null || text.isEmpty() ? "isolate" : text) {
      case "isolate" -> InvalidValues.ISOLATE;
      case "combine" -> InvalidValues.COMBINE;
      default -> {
        diagnostics.error(
            file, line, "invalid_values", "must be isolate or combine, not '" + text + "'");
        yield InvalidValues.ISOLATE;
      }
    };
  }

  private Strength strength(@Nullable String text, String where, int line) {
    if (text == null) {
      diagnostics.error(file, line, where, "is missing; write 1 to 6, or all");
      return new Strength(1);
    }
    return attempt(line, where, () -> Strength.parse(text)).orElse(new Strength(1));
  }

  private MixedStrength mixed(StrengthType strength, List<InputElement> inputs) {
    int line = XmlDocuments.line(strength);
    Set<String> known = new HashSet<>(inputs.stream().map(InputElement::name).toList());
    for (String parameter : strength.getParam()) {
      if (!known.contains(parameter)) {
        diagnostics.error(
            file, line, "strength", "'" + parameter + "' is not an element of input_spec_list");
      }
    }
    return new MixedStrength(strength(strength.getT(), "strength", line), strength.getParam());
  }

  private List<KeptCase> keptCases(List<CaseType> cases, List<InputElement> inputs) {
    List<KeptCase> kept = new ArrayList<>();
    for (CaseType testCase : cases) {
      int line = XmlDocuments.line(testCase);
      String where = "case_list/case " + (testCase.getNo() == null ? "" : testCase.getNo());
      if (testCase.getValues().size() != inputs.size()) {
        diagnostics.error(
            file,
            line,
            where,
            "has "
                + testCase.getValues().size()
                + " values for "
                + inputs.size()
                + " input elements");
        continue;
      }
      List<Value> values = new ArrayList<>();
      for (int i = 0; i < inputs.size(); i++) {
        InputElement element = inputs.get(i);
        String literal = testCase.getValues().get(i);
        attempt(
                line,
                where + "/" + element.name(),
                () ->
                    element.kind() == InputKind.TDTS
                        ? Value.parseAnswer(literal, element.type())
                        : Value.parse(literal, element.type()))
            .ifPresent(values::add);
      }
      kept.add(new KeptCase(testCase.getNo() == null ? 0 : testCase.getNo(), values, line));
    }
    return kept;
  }

  private void checkUniqueNames(List<String> names, List<Integer> lines) {
    Set<String> seen = new HashSet<>();
    for (int i = 0; i < names.size(); i++) {
      if (!seen.add(names.get(i))) {
        diagnostics.error(
            file, lines.get(i), "test_element " + names.get(i), "another element has this name");
      }
    }
  }

  private <T> Optional<T> attempt(int line, String where, Supplier<T> reading) {
    try {
      return Optional.of(reading.get());
    } catch (IllegalArgumentException e) {
      diagnostics.error(file, line, where, String.valueOf(e.getMessage()));
      return Optional.empty();
    }
  }

  private static double number(@Nullable String text) {
    return text == null ? 0 : Decimals.parse(text).max(BigDecimal.valueOf(-1e300)).doubleValue();
  }

  private static boolean isNumber(ScalarType type) {
    return type.isNumeric() || type == ScalarType.BOOLEAN;
  }

  private static boolean isBoolean(DataType type) {
    return type instanceof DataType.Scalar scalar && scalar.type() == ScalarType.BOOLEAN;
  }

  private static String abstractType(TestElementType element) {
    return text(element.getAbstractType()).toUpperCase(Locale.ROOT);
  }

  private static String name(TestElementType element) {
    return text(element.getName());
  }

  private static String text(@Nullable String text) {
    return text == null ? "" : text.strip();
  }

  private static String where(TestElementType element) {
    return "test_element " + name(element);
  }
}
