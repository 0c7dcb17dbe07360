package org.sitaf.runtime.stub;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.runtime.suite.Answer;
import org.sitaf.runtime.suite.Answers;
import org.sitaf.runtime.suite.CaseResult;

/**
 * A method of a required interface in the test stub: records each call and gives the answer that
 * the case defines. The time of the call counts as time in stubs.
 *
 * @param <T> the boxed return type; {@code Void} for none
 */
public final class StubbedMethod<T> {
  private final Stubbing stubbing;
  private final String name;
  private final List<String> parameters;
  private Answers<T> answers;
  private int calls;

  /**
   * Creates a method that returns a default value until the test sets an answer.
   *
   * @param name {@code Interface.Method}
   * @param unset the value in cases without an answer; null for a method that returns nothing
   * @param parameters names of the input parameters
   */
  public StubbedMethod(Stubbing stubbing, String name, @Nullable T unset, String... parameters) {
    this.stubbing = Objects.requireNonNull(stubbing);
    this.name = Objects.requireNonNull(name);
    this.parameters = List.of(parameters);
    this.answers = Answers.none(unset);
  }

  /** Sets the answers of a case, or from a step on, and restarts the count of calls. */
  public synchronized void answerWith(Answers<T> fromNow) {
    answers = fromNow;
    calls = 0;
  }

  /**
   * Handles a call of the component.
   *
   * @param arguments values of the input parameters, in order
   */
  public @Nullable T call(@Nullable Object... arguments) {
    long entered = stubbing.stopwatch().enter();
    try {
      record(arguments);
      Answer<T> answer = next();
      Duration delay = answer.delay();
      if (!delay.isZero()) {
        stubbing.pass(delay);
      }
      String error = answer.error();
      if (error != null) {
        throw DeclaredError.named(error, name + " throws this error in this case");
      }
      return answer.value();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(name + " was interrupted while its answer is delayed", e);
    } finally {
      stubbing.stopwatch().leaveStub(entered);
    }
  }

  private synchronized Answer<T> next() {
    return answers.of(++calls);
  }

  private void record(@Nullable Object... arguments) {
    List<String> literals = new ArrayList<>();
    if (stubbing.calls().hasRoom()) {
      for (Object argument : arguments) {
        literals.add(CaseResult.literal(argument));
      }
    }
    stubbing.calls().add(name, parameters, literals);
  }
}
