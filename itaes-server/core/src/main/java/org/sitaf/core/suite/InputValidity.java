package org.sitaf.core.suite;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.TestSpec;
import org.sitaf.core.model.Value;
import org.sitaf.core.value.TestDataGenerator;
import org.sitaf.core.value.TestValue;

/**
 * Which values of a case are valid. A suite says so only of whole cases; the values of the model
 * say the rest.
 */
public final class InputValidity {
  private final TestModel model;
  private final long seed;
  private @Nullable List<Set<String>> validLiterals;

  /**
   * @param seed seed of the suite
   */
  public InputValidity(TestModel model, long seed) {
    this.model = model;
    this.seed = seed;
  }

  /** Adds {@code valid} and the validity of each input of a case. */
  public void put(Variables variables, TestCase testCase) {
    variables.put(Variables.VALID, testCase.valid());
    for (int i = 0; i < model.inputs().size(); i++) {
      InputElement input = model.inputs().get(i);
      variables.putValidity(input.name(), testCase.valid() || isValid(i, testCase.values().get(i)));
    }
  }

  /** A related value is always valid. */
  private static boolean isRelated(InputElement input) {
    return input.specs().stream().anyMatch(TestSpec.Related.class::isInstance);
  }

  /** Whether a value of an input is valid, as when cases are combined. */
  public synchronized boolean isValid(int input, String literal) {
    if (isRelated(model.inputs().get(input))) {
      return true;
    }
    if (validLiterals == null) {
      List<Set<String>> all = new ArrayList<>();
      for (InputElement each : model.inputs()) {
        all.add(
            TestDataGenerator.generate(each, seed).values().stream()
                .filter(TestValue::valid)
                .map(v -> v.value().literal())
                .collect(Collectors.toSet()));
      }
      validLiterals = all;
    }
    InputElement element = model.inputs().get(input);
    return validLiterals.get(input).contains(literal)
        || element.kind() != InputKind.TDTS
            && TestDataGenerator.isInClasses(element, Value.parse(literal, element.type()));
  }
}
