package org.sitaf.core.harness.python;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.harness.plan.HarnessPlan;

/**
 * The plan of a test application in Python. All names are valid in Python.
 *
 * @param packageName package of the model's modules
 * @param component name of the class under test in generated modules
 * @param componentModule module of the class under test
 * @param componentClass name of the class in this module
 * @param callName name of the driver's method that makes the call
 * @param steps of a sequence; empty if a case is one call
 */
record PythonPlan(
    HarnessPlan neutral,
    String packageName,
    String component,
    String componentModule,
    String componentClass,
    List<Argument> arguments,
    List<Setting> settings,
    List<Stub> stubs,
    String callName,
    List<Step> steps) {

  /**
   * A step of a sequence.
   *
   * @param method name of the driver's method that executes it
   * @param prepare name of the test stub's method that sets the answers of a call
   * @param call the plan of a call; null for an event
   * @param event null for a call
   */
  record Step(
      String name,
      String method,
      String prepare,
      @Nullable PythonPlan call,
      HarnessPlan.@Nullable EventStep event) {}

  /** Whether a case is a sequence of steps. */
  boolean isSequence() {
    return !steps.isEmpty();
  }

  /** The plans of the calls: those of a sequence, or this one. */
  List<PythonPlan> calls() {
    List<PythonPlan> calls = new ArrayList<>();
    for (Step step : steps) {
      PythonPlan call = step.call();
      if (call != null) {
        calls.add(call);
      }
    }
    return steps.isEmpty() ? List.of(this) : calls;
  }

  /** The inputs that are properties or constructor arguments of the component. */
  List<HarnessPlan.Given> properties() {
    HarnessPlan.Sequence sequence = neutral.sequence();
    return sequence == null ? List.of() : sequence.properties();
  }

  /** A parameter of the method under test and its variable. */
  record Argument(HarnessPlan.Argument neutral, String local) {
    DataType type() {
      return neutral.parameter().type();
    }

    Direction direction() {
      return neutral.parameter().direction();
    }

    /** The type annotation of the variable. */
    String hint() {
      String hint = PythonType.hint(type());
      return switch (direction()) {
        case IN -> hint;
        case OUT -> "Out[" + hint + "]";
        case INOUT -> "InOut[" + hint + "]";
      };
    }
  }

  /** A parameter of the world and its variable. */
  record Setting(HarnessPlan.World.Setting neutral, String local) {}

  /**
   * A required interface.
   *
   * @param field field of the test stub
   */
  record Stub(HarnessPlan.Stub neutral, String field, List<StubMethod> methods) {
    String name() {
      return neutral.name();
    }
  }

  /**
   * A method of a required interface.
   *
   * @param field field with the answers
   * @param alias name in snake case; null if the name is already in snake case
   */
  record StubMethod(
      HarnessPlan.StubMethod neutral,
      String field,
      @Nullable String alias,
      List<String> inputs,
      List<Answer> answers) {
    String name() {
      return neutral.method().name();
    }

    List<Parameter> parameters(boolean out) {
      return neutral.method().parameters().stream()
          .filter(p -> p.direction() != (out ? Direction.IN : Direction.OUT))
          .toList();
    }
  }

  /** An answer and its variable. */
  record Answer(HarnessPlan.Answer neutral, String local) {}

  /** All answers that the suite sets. */
  List<Answer> answers() {
    return stubs.stream()
        .flatMap(s -> s.methods().stream())
        .flatMap(m -> m.answers().stream())
        .toList();
  }

  /** Whether simulation time passes after the call. */
  boolean runsOn() {
    return neutral.world() != null && !neutral.world().runFor().isZero();
  }

  /** Whether the component is executed periodically. */
  boolean isPeriodic() {
    return neutral.component().period() != null;
  }

  boolean observes() {
    return calls().stream()
        .flatMap(c -> c.neutral.outputs().stream())
        .anyMatch(o -> o.source() instanceof HarnessPlan.Source.Observation);
  }
}
