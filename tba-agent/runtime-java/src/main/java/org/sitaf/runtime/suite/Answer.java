package org.sitaf.runtime.suite;

import java.time.Duration;
import java.util.Objects;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;

/**
 * What a stubbed method does when it is called.
 *
 * @param delay that passes first; zero for none
 * @param error name of what is thrown; null where a value is returned
 * @param value what is returned; null for nothing
 */
public record Answer<T>(Duration delay, @Nullable String error, @Nullable T value) {
  /** Begins an error, thrown or expected. */
  static final String ERROR = "!error:";

  private static final String DELAY = "!delay:";

  public Answer {
    Objects.requireNonNull(delay);
  }

  /**
   * Reads {@code VALUE}, {@code !error:NAME}, {@code !delay:SECONDS} or a delay and, after a space,
   * one of the others.
   *
   * @param unset what is returned where the literal has no value
   */
  static <T> Answer<T> read(String literal, @Nullable T unset, Function<String, T> reading) {
    Duration delay = Duration.ZERO;
    String rest = literal;
    if (literal.startsWith(DELAY)) {
      int space = literal.indexOf(' ');
      String seconds = literal.substring(DELAY.length(), space < 0 ? literal.length() : space);
      delay = Duration.ofNanos(Math.round(Literals.real(seconds) * 1e9));
      if (space < 0) {
        return new Answer<>(delay, null, unset);
      }
      rest = literal.substring(space + 1);
    }
    return rest.startsWith(ERROR)
        ? new Answer<>(delay, rest.substring(ERROR.length()), null)
        : new Answer<>(delay, null, reading.apply(rest));
  }
}
