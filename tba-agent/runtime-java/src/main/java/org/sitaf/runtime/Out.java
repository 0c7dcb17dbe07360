package org.sitaf.runtime;

import org.jspecify.annotations.Nullable;

/**
 * An out-parameter of a method under test: the component sets the value, the test driver reads it.
 */
public final class Out<T> {
  private @Nullable T value;

  /** An out-parameter without a value. */
  public Out() {}

  /** An in-out-parameter with its input value. */
  public Out(T value) {
    this.value = value;
  }

  /** The value that was set last; null when none was set. */
  public @Nullable T get() {
    return value;
  }

  /** Sets the value. */
  public void set(T newValue) {
    value = newValue;
  }
}
