package org.sitaf.core.model.document;

import static org.sitaf.core.model.document.Problems.number;
import static org.sitaf.core.model.document.Problems.text;

import java.time.Duration;
import java.util.ArrayList;
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
import org.sitaf.core.model.Target;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.timing.Timing;
import org.sitaf.schemas.StrengthType;
import org.sitaf.schemas.TargetType;
import org.sitaf.schemas.TestModelDocument;
import org.sitaf.schemas.TimingType;

/** Converts the parsed document to a {@link TestModel} and reports all contradictions. */
final class TestModelReader {
  private final Problems problems;
  private final ElementLines lines;
  private final ConditionReader conditions;

  /**
   * @param lines of conditions
   */
  TestModelReader(String file, Diagnostics diagnostics, ElementLines lines) {
    this.problems = new Problems(file, diagnostics);
    this.lines = lines;
    this.conditions = new ConditionReader(problems, lines);
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
    List<InputElement> inputs = new ArrayList<>();
    List<OutputElement> outputs = new ArrayList<>();
    if (root.getInputSpecList() != null) {
      InputReader reader = new InputReader(problems);
      root.getInputSpecList().getTestElement().forEach(e -> reader.read(e).ifPresent(inputs::add));
    }
    if (root.getOutputSpecList() != null) {
      OutputReader reader = new OutputReader(problems);
      root.getOutputSpecList()
          .getTestElement()
          .forEach(e -> reader.read(e).ifPresent(outputs::add));
    }
    new RelationCheck(problems, inputs).verify();
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
        root.getCaseList() == null
            ? List.of()
            : new KeptCaseReader(problems).read(root.getCaseList().getCases(), inputs),
        maxCases(root.getMaxCases(), line),
        timing(root.getTiming()),
        problems.file());
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
    return problems
        .attempt(
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

  private void checkUniqueNames(List<String> names, List<Integer> lines) {
    Set<String> seen = new HashSet<>();
    for (int i = 0; i < names.size(); i++) {
      if (!seen.add(names.get(i))) {
        problems.error(
            lines.get(i), "test_element " + names.get(i), "another element has this name");
      }
    }
  }
}
