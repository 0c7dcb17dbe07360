package org.sitaf.core.score.fault;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.description.WorldDescription.WorldParameter;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.verdict.Literals;

/** The faults of parameters, of what the simulation shows to sensors, and of answers of stubs. */
public final class InputFaults {
  private static final double LATE_SECONDS = 1;

  private final TestModel model;
  private final @Nullable WorldDescription world;
  private final String unit;
  private final List<Fault> faults = new ArrayList<>();

  private InputFaults(TestModel model, @Nullable WorldDescription world, String unit) {
    this.model = model;
    this.world = world;
    this.unit = unit;
  }

  /**
   * All faults of the inputs of a model.
   *
   * @param simplest the value of each input that a component uses if it ignores the input
   */
  public static List<Fault> of(
      TestModel model, @Nullable WorldDescription world, List<String> simplest) {
    return of(model, world, simplest, "case");
  }

  /**
   * All faults of the inputs of a model.
   *
   * @param unit what the values belong to: {@code case} or {@code call}
   */
  public static List<Fault> of(
      TestModel model, @Nullable WorldDescription world, List<String> simplest, String unit) {
    InputFaults all = new InputFaults(model, world, unit);
    for (int i = 0; i < model.inputs().size(); i++) {
      all.ofInput(i, simplest.get(i));
    }
    return all.faults;
  }

  private void ofInput(int index, String simplest) {
    InputElement input = model.inputs().get(index);
    for (ValueChange change : ValueChanges.of(input.type())) {
      add(index, change.text(), literal -> change.apply(literal));
    }
    add(index, "ignored, always " + simplest, literal -> simplest);
    faults.add(
        new Fault.OfInputs(
            input.name(),
            input.name() + ": value of the " + unit + " before",
            (values, before) ->
                before == null ? Optional.empty() : replaced(values, index, before.get(index))));
    if (input.kind() == InputKind.TDTS) {
      ofAnswer(index);
    }
    for (int other = 0; other < index; other++) {
      if (isExchangeable(model.inputs().get(other), input)) {
        swapped(other, index);
      }
    }
  }

  private void ofAnswer(int index) {
    InputElement input = model.inputs().get(index);
    faults.add(
        new Fault.OfInputs(
            input.name(),
            input.name() + ": exception of the required interface swallowed",
            (values, before) ->
                values.get(index).startsWith(Value.ERROR_PREFIX)
                    ? replaced(values, index, ValueChanges.zero(input.type()))
                    : Optional.empty()));
    faults.add(
        new Fault.OfInputs(
            input.name(),
            input.name() + ": exception instead of the answer",
            (values, before) ->
                replaced(values, index, Value.ERROR_PREFIX + OutputFaults.INJECTED)));
    faults.add(
        new Fault.OfInputs(
            input.name(),
            input.name() + ": answer " + LATE_SECONDS + " s late",
            (values, before) ->
                values.get(index).startsWith(Value.DELAY_PREFIX)
                    ? Optional.empty()
                    : replaced(
                        values,
                        index,
                        Value.DELAY_PREFIX + LATE_SECONDS + " " + values.get(index))));
  }

  private void swapped(int one, int other) {
    InputElement first = model.inputs().get(one);
    InputElement second = model.inputs().get(other);
    faults.add(
        new Fault.OfInputs(
            second.name(),
            second.name() + ": swapped with " + first.name(),
            (values, before) ->
                replaced(values, one, values.get(other))
                    .flatMap(swapped -> replaced(swapped, other, values.get(one)))));
  }

  private static boolean isExchangeable(InputElement one, InputElement other) {
    return one.kind() == other.kind()
        && one.kind() != InputKind.TDTS
        && one.type().equals(other.type())
        && !(one.type() instanceof DataType.Unknown);
  }

  private void add(int index, String text, Function<String, String> change) {
    InputElement input = model.inputs().get(index);
    faults.add(
        new Fault.OfInputs(
            input.name(),
            input.name() + ": " + text,
            (values, before) -> {
              String literal = values.get(index);
              return Value.isErrorOrDelay(literal)
                  ? Optional.empty()
                  : replaced(values, index, change.apply(literal));
            }));
  }

  /** Empty if the value does not change, or if the input cannot have it. */
  private Optional<List<String>> replaced(List<String> values, int index, String literal) {
    InputElement input = model.inputs().get(index);
    if (literal.equals(values.get(index)) || !isPossible(input, literal)) {
      return Optional.empty();
    }
    List<String> changed = new ArrayList<>(values);
    changed.set(index, literal);
    return Optional.of(List.copyOf(changed));
  }

  private boolean isPossible(InputElement input, String literal) {
    try {
      Value unused = input.value(literal);
    } catch (IllegalArgumentException e) {
      return false;
    }
    if (input.kind() != InputKind.TDSD) {
      return true;
    }
    WorldParameter parameter = world == null ? null : world.parameter(input.name()).orElse(null);
    return Literals.isReal(literal)
        && Double.isFinite(Literals.real(literal))
        && (parameter == null || parameter.contains(Literals.real(literal)));
  }
}
