package org.sitaf.core.suite;

import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;

/** The test cases of a model (paper, Fig. 9). */
public record TestSuite(
    String name,
    String description,
    String modelName,
    Generation generation,
    List<CaseParameter> parameters,
    List<TestCase> cases) {
  public TestSuite {
    Objects.requireNonNull(name);
    Objects.requireNonNull(description);
    Objects.requireNonNull(modelName);
    Objects.requireNonNull(generation);
    parameters = List.copyOf(parameters);
    cases = List.copyOf(cases);
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
    }
  }

  /**
   * A copy with other cases.
   *
   * @throws IllegalArgumentException if a case does not have one value per parameter, or a number
   *     is used twice
   */
  public TestSuite withCases(List<TestCase> others) {
    return new TestSuite(name, description, modelName, generation, parameters, others);
  }

  /** A copy without expected values, for test applications. */
  public TestSuite withoutExpected() {
    return withCases(
        cases.stream().map(c -> new TestCase(c.no(), c.valid(), c.values(), List.of())).toList());
  }

  /** The number of valid cases. */
  public long validCount() {
    return cases.stream().filter(TestCase::valid).count();
  }
}
