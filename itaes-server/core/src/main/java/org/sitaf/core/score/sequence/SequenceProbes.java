package org.sitaf.core.score.sequence;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.suite.sequence.AbstractState;
import org.sitaf.core.suite.sequence.StepStates;

/** Allowed sequences beyond the suite, which show what a fault that it never reaches changes. */
final class SequenceProbes {
  private static final int MIN_LENGTH = 6;

  private final SequenceSpec sequence;
  private final TestSuite suite;
  private final StepStates states;
  private final List<TestStep> pool;
  private final Random random = new Random(1);

  SequenceProbes(TestModel model, SequenceSpec sequence, TestSuite suite) {
    this.sequence = sequence;
    this.suite = suite;
    this.states = new StepStates(model, suite.generation().seed());
    Set<TestStep> steps = new LinkedHashSet<>();
    for (TestCase testCase : suite.cases()) {
      for (TestStep step : testCase.steps()) {
        if (step.valid()) {
          steps.add(step.withoutExpected());
        }
      }
    }
    this.pool = List.copyOf(steps);
  }

  /**
   * Different cases.
   *
   * @param firstNo number of the first one
   */
  List<TestCase> cases(int count, int firstNo) {
    List<TestCase> valid = suite.cases().stream().filter(TestCase::valid).toList();
    List<TestCase> cases = new ArrayList<>();
    Set<List<TestStep>> known = new LinkedHashSet<>();
    for (int attempt = 0; attempt < count && !valid.isEmpty(); attempt++) {
      List<TestStep> steps = walk();
      if (!steps.isEmpty() && known.add(steps)) {
        List<String> values = valid.get(attempt % valid.size()).values();
        cases.add(new TestCase(firstNo + cases.size(), true, values, List.of(), steps));
      }
    }
    return cases;
  }

  private List<TestStep> walk() {
    List<TestStep> steps = new ArrayList<>();
    AbstractState state = states.initial();
    int length = Math.max(MIN_LENGTH, sequence.length());
    while (steps.size() < length) {
      List<TestStep> order = new ArrayList<>(pool);
      Collections.shuffle(order, random);
      Optional<AbstractState> after = Optional.empty();
      for (TestStep step : order) {
        boolean again = steps.stream().anyMatch(s -> s.name().equals(step.name()));
        after = again && !sequence.repeat() ? Optional.empty() : states.planned(state, step);
        if (after.isPresent()) {
          steps.add(step);
          break;
        }
      }
      if (after.isEmpty()) {
        break;
      }
      state = after.get();
    }
    return steps;
  }
}
