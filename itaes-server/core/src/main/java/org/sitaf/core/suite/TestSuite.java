package org.sitaf.core.suite;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;

/**
 * The test cases of a model (paper, Fig. 9).
 *
 * @param parameters of each case; of sequences, what is set before the first step
 * @param stepParameters the kinds of steps in the order of the model; empty if a case is one call
 */
public record TestSuite(
    String name,
    String description,
    String modelName,
    Generation generation,
    List<CaseParameter> parameters,
    List<StepParameters> stepParameters,
    List<TestCase> cases) {
  public TestSuite {
    Objects.requireNonNull(name);
    Objects.requireNonNull(description);
    Objects.requireNonNull(modelName);
    Objects.requireNonNull(generation);
    parameters = List.copyOf(parameters);
    stepParameters = List.copyOf(stepParameters);
    cases = List.copyOf(cases);
    Map<String, Integer> sizes = new HashMap<>();
    stepParameters.forEach(s -> sizes.put(s.name(), s.parameters().size()));
    Set<Integer> numbers = new HashSet<>();
    for (TestCase testCase : cases) {
      if (testCase.values().size() != parameters.size()) {
        throw new IllegalArgumentException(
            "case "
                + testCase.no()
                + " has "
                + testCase.values().size()
                + " values for "
                + parameters.size()
                + " parameters");
      }
      if (!numbers.add(testCase.no())) {
        throw new IllegalArgumentException("case number " + testCase.no() + " is used twice");
      }
      for (TestStep step : testCase.steps()) {
        Integer size = sizes.get(step.name());
        if (size == null || size != step.values().size()) {
          throw new IllegalArgumentException(
              "case "
                  + testCase.no()
                  + ": the step "
                  + step.name()
                  + (size == null
                      ? " is not described by the suite"
                      : " has " + step.values().size() + " values for " + size + " parameters"));
        }
      }
    }
  }

  /** A suite whose cases are one call each. */
  public TestSuite(
      String name,
      String description,
      String modelName,
      Generation generation,
      List<CaseParameter> parameters,
      List<TestCase> cases) {
    this(name, description, modelName, generation, parameters, List.of(), cases);
  }

  /** Whether the cases are sequences of steps. */
  public boolean isOfSequences() {
    return !stepParameters.isEmpty();
  }

  /** The parameters of a kind of step; none if it is unknown. */
  public List<CaseParameter> stepParameters(String step) {
    return stepParameters.stream()
        .filter(s -> s.name().equals(step))
        .findFirst()
        .map(StepParameters::parameters)
        .orElse(List.of());
  }

  /**
   * A copy with other cases.
   *
   * @throws IllegalArgumentException if a case does not have one value per parameter, or a number
   *     is used twice
   */
  public TestSuite withCases(List<TestCase> others) {
    return new TestSuite(
        name, description, modelName, generation, parameters, stepParameters, others);
  }

  /** A copy without expected values, for test applications. */
  public TestSuite withoutExpected() {
    return withCases(cases.stream().map(TestCase::withoutExpected).toList());
  }

  /** The number of valid cases. */
  public long validCount() {
    return cases.stream().filter(TestCase::valid).count();
  }
}
