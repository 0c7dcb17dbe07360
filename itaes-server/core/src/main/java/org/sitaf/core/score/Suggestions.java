package org.sitaf.core.score;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Tolerance;
import org.sitaf.core.model.Value;
import org.sitaf.core.score.fault.Fault;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.Literals;

/** What to add to a specification so that it notices a fault. */
public final class Suggestions {
  private static final int MAX_SHOWN = 60;

  private final TestModel model;
  private final List<TestCase> cases;

  Suggestions(TestModel model, TestSuite suite) {
    this.model = model;
    this.cases = suite.cases();
  }

  /**
   * A suggestion for a fault that survives.
   *
   * @param effects at least one
   */
  String of(Fault fault, List<Effect> effects) {
    Effect first = effects.get(0);
    if (first.no() == 0) {
      return unreached(first);
    }
    List<Effect> passing = effects.stream().filter(Effect::passes).toList();
    if (passing.isEmpty()) {
      return "only changes cases that do not pass without the fault, such as " + first.label();
    }
    return of(model, fault.where(), passing);
  }

  /**
   * What the specification of a call should add.
   *
   * @param model of the call
   * @param where the output, input or required method of the fault
   * @param passing effects in cases that pass without the fault; at least one
   */
  public static String of(TestModel model, String where, List<Effect> passing) {
    Effect effect = passing.get(0);
    if (effect.with().outcome() == CaseRecord.Outcome.THREW
        || effect.without().outcome() == CaseRecord.Outcome.THREW) {
      return ofException(effect);
    }
    for (OutputElement output : model.outputs()) {
      Optional<Effect> changed = passing.stream().filter(e -> e.changes(output.name())).findFirst();
      if (changed.isPresent()) {
        return ofOutput(output, changed.get(), passing);
      }
    }
    if (!effect.with().calls().equals(effect.without().calls())) {
      return ofCalls(where, effect);
    }
    return "add a trajectory condition that looks at the motion in "
        + effect.label()
        + ", or an output of the kind OBSERVED";
  }

  /** The value or the combination that the suite does not have. */
  private String unreached(Effect effect) {
    for (int i = 0; i < model.inputs().size(); i++) {
      int index = i;
      Set<String> used = cases.stream().map(c -> c.values().get(index)).collect(Collectors.toSet());
      if (!used.contains(effect.values().get(i))) {
        return "no case reaches it: add the value "
            + shown(effect.values().get(i))
            + " of "
            + model.inputs().get(i).name();
      }
    }
    return "no case reaches it: add a case with "
        + IntStream.range(0, model.inputs().size())
            .mapToObj(i -> model.inputs().get(i).name() + " = " + shown(effect.values().get(i)))
            .collect(Collectors.joining(", "));
  }

  private static String ofException(Effect effect) {
    CaseRecord without = effect.without();
    return without.outcome() == CaseRecord.Outcome.THREW
        ? "expect "
            + Value.ERROR_PREFIX
            + without.thrown()
            + " in "
            + effect.label()
            + ", and nothing else"
        : effect.label()
            + " passes with any exception: give the expected value instead of "
            + Value.ANY
            + " or no value";
  }

  private static String ofOutput(OutputElement output, Effect effect, List<Effect> passing) {
    List<Effect> judged =
        passing.stream().filter(e -> e.changes(output.name()) && isJudged(output, e)).toList();
    String change =
        effect.label()
            + " gives "
            + shown(String.valueOf(effect.changed(output.name())))
            + " instead of "
            + shown(String.valueOf(effect.original(output.name())));
    if (judged.isEmpty()) {
      return output.expected() == null
          ? "add an expected value of " + output.name() + ": " + change
          : "replace "
              + Value.ANY
              + " by an expected value of "
              + output.name()
              + " where it applies: "
              + change;
    }
    Effect widest = effect;
    double difference = -1;
    for (Effect each : judged) {
      double found = difference(output, each);
      if (found > difference) {
        difference = found;
        widest = each;
      }
    }
    if (difference >= 0) {
      return "the tolerance of "
          + output.name()
          + " ("
          + text(output.tolerance())
          + ") allows it: "
          + widest.label()
          + " differs by "
          + difference
          + "; narrow the tolerance if that is too much";
    }
    return "add an expected value or a post-condition that looks at all of "
        + output.name()
        + ": "
        + change;
  }

  private static boolean isJudged(OutputElement output, Effect effect) {
    for (ExpectedValue expected : effect.expected()) {
      if (expected.output().isEmpty() || expected.output().equals(output.name())) {
        return !expected.literal().strip().equals(Value.ANY);
      }
    }
    return false;
  }

  private static double difference(OutputElement output, Effect effect) {
    String one = effect.original(output.name());
    String other = effect.changed(output.name());
    boolean numbers =
        one != null && other != null && Literals.isReal(one) && Literals.isReal(other);
    return numbers && !output.tolerance().equals(Tolerance.EXACT)
        ? Math.abs(Literals.real(one) - Literals.real(other))
        : -1;
  }

  private static String text(Tolerance tolerance) {
    return "absolute "
        + tolerance.absolute()
        + ", relative "
        + tolerance.relative()
        + (tolerance.ulp() == 0 ? "" : ", ulp " + tolerance.ulp());
  }

  private static String ofCalls(String where, Effect effect) {
    List<String> methods =
        effect.without().calls().recorded().stream().map(c -> c.method()).distinct().toList();
    String method =
        methods.stream()
            .filter(m -> where.equals(m) || where.startsWith(m + "."))
            .findFirst()
            .orElse(methods.isEmpty() ? where : methods.get(0));
    long count =
        effect.without().calls().recorded().stream().filter(c -> c.method().equals(method)).count();
    String calls = "calls[\"" + method + "\"]";
    String condition =
        where.startsWith(method + ".")
            ? "about " + calls + "[0]." + where.substring(method.length() + 1)
            : calls + ".size() == " + count;
    return "add a post-condition such as " + condition + " (" + effect.label() + ")";
  }

  private static String shown(String literal) {
    return literal.length() <= MAX_SHOWN ? literal : literal.substring(0, MAX_SHOWN) + "...";
  }
}
