package org.sitaf.runtime.suite;

import java.time.Duration;
import java.util.Objects;
import java.util.function.Function;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * The behaviour of a stubbed method in a call.
 *
 * @param delay delay of the answer; zero for none
 * @param error name of the exception to throw; null where a value is returned
 * @param value to return; null for a method without a return value
 */
public record Answer<T>(Duration delay, @Nullable String error, @Nullable T value) {
  private static final String ERROR = "!error:";

  private static final String DELAY = "!delay:";
  private static final Pattern SECONDS = Pattern.compile("[0-9]{1,6}(\\.[0-9]{1,9})?");

  public Answer {
    Objects.requireNonNull(delay);
  }

  /**
   * Reads {@code VALUE}, {@code !error:NAME} or {@code !delay:SECONDS}; a value or an error may
   * follow a delay after a space.
   *
   * @param unset the value for a literal without a value
   */
  static <T> Answer<T> read(String literal, @Nullable T unset, Function<String, T> reading) {
    Duration delay = Duration.ZERO;
    String rest = literal;
    if (literal.startsWith(DELAY)) {
      int space = literal.indexOf(' ');
      String seconds = literal.substring(DELAY.length(), space < 0 ? literal.length() : space);
      if (!SECONDS.matcher(seconds).matches()) {
        throw new CaseDataException(
            "'" + literal + "' is not a delay such as !delay:0.5 or !delay:0.5 VALUE, in seconds");
      }
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
