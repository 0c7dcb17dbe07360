package org.sitaf.runtime;

import org.jspecify.annotations.Nullable;

/**
 * An out-parameter of a method under test: the component puts the value in, the test driver takes
 * it out.
 */
public final class Out<T> {
  private @Nullable T value;

  /** An out-parameter that holds nothing yet. */
  public Out() {}

  /** A parameter that carries data both ways. */
  public Out(T value) {
    this.value = value;
  }

  /** What was put in last; null when nothing was. */
  public @Nullable T get() {
    return value;
  }

  /** Puts a value in. */
  public void set(T newValue) {
    value = newValue;
  }
}
