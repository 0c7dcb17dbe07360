package org.sitaf.runtime.stub;

import java.util.Objects;
import org.sitaf.runtime.Out;
import org.sitaf.runtime.suite.Answers;

/**
 * An out-parameter of a stubbed method.
 *
 * @param <T> the boxed type
 */
public final class StubbedOut<T> {
  private Answers<T> answers;
  private int calls;

  /**
   * Creates an out-parameter that gets a default value until the test sets an answer.
   *
   * @param unset the value in cases without an answer
   */
  public StubbedOut(T unset) {
    this.answers = Answers.none(Objects.requireNonNull(unset));
  }

  /** Sets the answers of a case, or from a step on, and restarts the count of calls. */
  public synchronized void answerWith(Answers<T> fromNow) {
    answers = fromNow;
    calls = 0;
  }

  /** Sets the out-parameter to the answer for the next call. */
  public synchronized void fill(Out<T> out) {
    T value = answers.of(++calls).value();
    out.set(Objects.requireNonNull(value));
  }
}
