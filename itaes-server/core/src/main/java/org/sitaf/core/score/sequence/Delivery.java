package org.sitaf.core.score.sequence;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;

/**
 * What reaches the component instead of the steps of a case, and which answers the driver gets.
 *
 * @param values set before the first step
 * @param steps in the order in which they reach the component
 * @param answers for each step of the case, the index of the step whose answer the driver gets;
 *     {@link #NONE} if the step never reaches the component
 */
record Delivery(List<String> values, List<TestStep> steps, List<Integer> answers) {
  /** The step is left out: its outputs are never set. */
  static final int NONE = -1;

  Delivery {
    values = List.copyOf(values);
    steps = List.copyOf(steps);
    answers = List.copyOf(answers);
  }

  /** The unchanged steps of a case with other values before the first step. */
  static Delivery withValues(TestCase testCase, List<String> values) {
    return new Delivery(values, testCase.steps(), identity(testCase));
  }

  /** Steps with other values of their inputs. */
  static Delivery withSteps(TestCase testCase, List<TestStep> steps) {
    return new Delivery(testCase.values(), steps, identity(testCase));
  }

  /** Without some steps. */
  static Delivery without(TestCase testCase, IntPredicate isLeftOut) {
    List<TestStep> steps = new ArrayList<>();
    List<Integer> answers = new ArrayList<>();
    for (int i = 0; i < testCase.steps().size(); i++) {
      answers.add(isLeftOut.test(i) ? NONE : steps.size());
      if (!isLeftOut.test(i)) {
        steps.add(testCase.steps().get(i));
      }
    }
    return new Delivery(testCase.values(), steps, answers);
  }

  /**
   * With some steps twice.
   *
   * @param first whether the driver gets the first of the two answers
   */
  static Delivery twice(TestCase testCase, boolean first, IntPredicate isRepeated) {
    List<TestStep> steps = new ArrayList<>();
    List<Integer> answers = new ArrayList<>();
    for (int i = 0; i < testCase.steps().size(); i++) {
      TestStep step = testCase.steps().get(i);
      steps.add(step);
      if (isRepeated.test(i)) {
        steps.add(step);
        answers.add(first ? steps.size() - 2 : steps.size() - 1);
      } else {
        answers.add(steps.size() - 1);
      }
    }
    return new Delivery(testCase.values(), steps, answers);
  }

  /**
   * With neighbours exchanged; each step gets its own answer.
   *
   * @param isExchanged of a step and the next one
   */
  static Delivery exchanged(
      TestCase testCase, BiFunction<TestStep, TestStep, Boolean> isExchanged) {
    List<TestStep> steps = new ArrayList<>(testCase.steps());
    Integer[] answers = identity(testCase).toArray(new Integer[0]);
    for (int i = 0; i + 1 < steps.size(); i++) {
      if (isExchanged.apply(steps.get(i), steps.get(i + 1))) {
        Collections.swap(steps, i, i + 1);
        answers[i] = i + 1;
        answers[i + 1] = i;
        i++;
      }
    }
    return new Delivery(testCase.values(), steps, Arrays.asList(answers));
  }

  private static List<Integer> identity(TestCase testCase) {
    return IntStream.range(0, testCase.steps().size()).boxed().toList();
  }

  /** The number, from 1, of the step of the case during which each delivered step is executed. */
  double[] numbers() {
    double[] numbers = new double[steps.size()];
    double last = 1;
    for (int i = 0; i < numbers.length; i++) {
      int original = answers.indexOf(i);
      last = original < 0 ? last : original + 1;
      numbers[i] = last;
    }
    return numbers;
  }
}
