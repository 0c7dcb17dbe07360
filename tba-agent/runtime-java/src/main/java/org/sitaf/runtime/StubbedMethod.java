package org.sitaf.runtime;

import java.util.Objects;

/**
 * One method of a required interface, as the test stub answers it. Between two cases every call
 * gets the same answer.
 *
 * @param <T> the boxed return type
 */
public final class StubbedMethod<T> {
  private final Stopwatch stopwatch;
  private final T unset;
  private volatile T answer;

  /**
   * A method that answers with a neutral value until the test says otherwise.
   *
   * @param unset what is answered in cases that set nothing
   */
  public StubbedMethod(Stopwatch stopwatch, T unset) {
    this.stopwatch = Objects.requireNonNull(stopwatch);
    this.unset = unset;
    this.answer = unset;
  }

  /** Sets the answer of this case. */
  public void answerWith(T value) {
    answer = value;
  }

  /** Goes back to the neutral value. */
  public void reset() {
    answer = unset;
  }

  /** What the component gets; the time counts as the stub's. */
  public T call() {
    long entered = stopwatch.enter();
    T value = answer;
    stopwatch.leaveStub(entered);
    return value;
  }
}
