package org.sitaf.core.activity;

import java.util.Optional;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.description.WorldDescription.WorldParameter;
import org.sitaf.core.description.fault.DeviceFaults;
import org.sitaf.core.description.fault.FaultName;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.value.TestDataGenerator;
import org.sitaf.core.value.TestValue;

/** Verifies inputs that are set through the simulation: parameters of the world and faults. */
final class WorldInputs {
  private final TestModel model;
  private final @Nullable WorldDescription world;
  private final Diagnostics diagnostics;

  WorldInputs(TestModel model, @Nullable WorldDescription world, Diagnostics diagnostics) {
    this.model = model;
    this.world = world;
    this.diagnostics = diagnostics;
  }

  /** Verifies an input of the kind TDSD. */
  void verify(InputElement input) {
    String where = "test_element " + input.name();
    if (world == null) {
      error(input.line(), where, "is a parameter of the world, but activity.yaml has no world");
      return;
    }
    if (FaultName.isFault(input.name())) {
      fault(input, world, where);
      return;
    }
    Optional<WorldParameter> parameter = world.parameter(input.name());
    if (parameter.isEmpty()) {
      error(
          input.line(),
          where,
          world.path()
              + " has no such parameter; it has "
              + world.parameters().stream()
                  .map(WorldParameter::name)
                  .collect(Collectors.joining(", ")));
      return;
    }
    for (TestValue value : TestDataGenerator.generate(input, 1).values()) {
      if (value.relation() != null) {
        continue;
      }
      Optional<Double> number = number(value.value());
      if (number.isEmpty()) {
        error(
            input.line(),
            where,
            "a parameter of the world must be a number, not " + value.value().literal());
        return;
      }
      if (!parameter.get().contains(number.get())) {
        error(
            input.line(),
            where,
            "the value "
                + value.value().literal()
                + " is outside the range "
                + parameter.get().range()
                + " that "
                + world.path()
                + " declares; extend this range or restrict the test_spec");
      }
    }
  }

  /** A fault of a device that the simulation injects. */
  private void fault(InputElement input, WorldDescription declared, String where) {
    FaultName name;
    try {
      name = FaultName.parse(input.name());
    } catch (IllegalArgumentException e) {
      error(input.line(), where, String.valueOf(e.getMessage()));
      return;
    }
    Optional<String> problem = DeviceFaults.problem(name, declared);
    if (problem.isPresent()) {
      error(input.line(), where, problem.get());
      return;
    }
    if (name.part() != FaultName.Part.FAULT
        && model.inputs().stream().noneMatch(i -> i.name().equals(name.fault()))) {
      error(
          input.line(),
          where,
          "has no effect without the fault itself; add a test_element " + name.fault());
    }
    for (TestValue value : TestDataGenerator.generate(input, 1).values()) {
      if (value.relation() != null) {
        continue;
      }
      Optional<Double> number = number(value.value());
      Optional<String> wrong =
          number.isEmpty()
              ? Optional.of("must be a number")
              : DeviceFaults.problem(name, number.get());
      if (wrong.isPresent()) {
        error(input.line(), where, "the value " + value.value().literal() + " " + wrong.get());
        return;
      }
    }
  }

  private static Optional<Double> number(Value value) {
    if (value instanceof Value.Whole whole) {
      return Optional.of(whole.number().doubleValue());
    }
    return value instanceof Value.Real real ? Optional.of(real.number()) : Optional.empty();
  }

  private void error(int line, String element, String message) {
    diagnostics.error(model.source(), line, element, message);
  }
}
