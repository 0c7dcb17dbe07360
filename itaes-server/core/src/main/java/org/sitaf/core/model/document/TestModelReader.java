package org.sitaf.core.model.document;

import static org.sitaf.core.model.document.Problems.text;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.document.ElementLines;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.MixedStrength;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.Strength;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.timing.Timing;
import org.sitaf.schemas.CaseType;
import org.sitaf.schemas.StrengthType;
import org.sitaf.schemas.TestModelDocument;
import org.sitaf.schemas.TimingType;

/** Converts the parsed document to a {@link TestModel} and reports all contradictions. */
final class TestModelReader {
  private final Problems problems;
  private final ElementLines lines;
  private final ConditionReader conditions;

  /**
   * @param lines of conditions of relations
   */
  TestModelReader(String file, Diagnostics diagnostics, ElementLines lines) {
    this.problems = new Problems(file, diagnostics);
    this.lines = lines;
    this.conditions = new ConditionReader(problems);
  }

  TestModel read(TestModelDocument root) {
    int line = XmlDocuments.line(root);
    String name = root.getName() == null ? "" : root.getName();
    if (!name.matches("[A-Za-z0-9][A-Za-z0-9._-]{0,99}")) {
      problems.error(
          line,
          "name",
          (name.isEmpty() ? "is missing" : "'" + name + "' is not a name")
              + "; use letters, digits, '.', '_' and '-', at most 100 characters");
    }
    if (root.getInputSpecList() == null) {
      problems.error(line, "input_spec_list", "is missing");
    }
    ElementListReader elements = new ElementListReader(problems);
    List<InputElement> inputs =
        root.getInputSpecList() == null
            ? List.of()
            : elements.inputs(root.getInputSpecList().getTestElement());
    List<OutputElement> outputs =
        root.getOutputSpecList() == null
            ? List.of()
            : elements.outputs(root.getOutputSpecList().getTestElement());
    TestModel model = model(root, name, inputs, outputs, line);
    return root.getSequenceSpec() == null
        ? model
        : new SequenceReader(problems, model)
            .read(root.getSequenceSpec(), root.getTarget(), cases(root));
  }

  private static List<CaseType> cases(TestModelDocument root) {
    return root.getCaseList() == null ? List.of() : root.getCaseList().getCases();
  }

  private TestModel model(
      TestModelDocument root,
      String name,
      List<InputElement> inputs,
      List<OutputElement> outputs,
      int line) {
    return new TestModel(
        name,
        text(root.getDescription()),
        new TargetReader(problems).read(root.getTarget(), name),
        root.getDefinitionList() == null
            ? List.of()
            : conditions.definitions(root.getDefinitionList().getDefine()),
        Map.of(),
        conditions.read(
            ConditionReader.PRE_CONDITION,
            root.getPreConditionSpecList() == null
                ? List.of()
                : root.getPreConditionSpecList().getPreCondition()),
        inputs,
        outputs,
        conditions.read(
            ConditionReader.POST_CONDITION,
            root.getPostConditionSpecList() == null
                ? List.of()
                : root.getPostConditionSpecList().getPostCondition()),
        new TrajectoryConditionReader(problems).read(root.getTrajectoryConditionSpecList()),
        new RelationReader(problems, lines, inputs).read(root.getRelationList()),
        invalidValues(root.getInvalidValues(), line),
        strength(root.getOrderOfCombinations(), "order_of_combinations", line),
        root.getStrength().stream().map(s -> mixed(s, inputs)).toList(),
        root.getSequenceSpec() == null
            ? new KeptCaseReader(problems).read(cases(root), inputs)
            : List.of(),
        maxCases(root.getMaxCases(), line),
        timing(root.getTiming()),
        problems.file());
  }

  private InvalidValues invalidValues(@Nullable String text, int line) {
    return switch (text == null || text.isEmpty() ? "isolate" : text) {
      case "isolate" -> InvalidValues.ISOLATE;
      case "combine" -> InvalidValues.COMBINE;
      default -> {
        problems.error(line, "invalid_values", "must be isolate or combine, not '" + text + "'");
        yield InvalidValues.ISOLATE;
      }
    };
  }

  private Strength strength(@Nullable String text, String where, int line) {
    if (text == null) {
      problems.error(line, where, "is missing; write 1 to 6, or all");
      return new Strength(1);
    }
    return problems.attempt(line, where, () -> Strength.parse(text)).orElse(new Strength(1));
  }

  private int maxCases(@Nullable String text, int line) {
    return text == null
        ? TestModel.UNBOUNDED
        : problems
            .attempt(line, "max_cases", () -> Settings.whole(text.strip(), 1))
            .orElse(TestModel.UNBOUNDED);
  }

  private @Nullable Timing timing(@Nullable TimingType given) {
    if (given == null) {
      return null;
    }
    int line = XmlDocuments.line(given);
    return problems
        .attempt(
            line,
            "timing",
            () ->
                new Timing(
                    calls("warm_up", given.getWarmUp(), Timing.DEFAULT_WARM_UP),
                    calls("repeat", given.getRepeat(), Timing.DEFAULT_REPEAT),
                    line))
        .orElse(null);
  }

  private static int calls(String name, @Nullable String text, int otherwise) {
    try {
      return text == null ? otherwise : Settings.whole(text, 0);
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(name + " " + e.getMessage(), e);
    }
  }

  private MixedStrength mixed(StrengthType strength, List<InputElement> inputs) {
    int line = XmlDocuments.line(strength);
    Set<String> known = new HashSet<>(inputs.stream().map(InputElement::name).toList());
    for (String parameter : strength.getParam()) {
      if (!known.contains(parameter)) {
        problems.error(
            line, "strength", "'" + parameter + "' is not an element of input_spec_list");
      }
    }
    return new MixedStrength(strength(strength.getT(), "strength", line), strength.getParam());
  }
}
