package org.sitaf.core.harness.plan;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * The answer of a stubbed method in a test case: {@code VALUE}, {@code !error:NAME}, {@code
 * !delay:SECONDS}, or a delay followed by a space and one of the others.
 *
 * @param delay in seconds; 0 for none
 * @param error name of the thrown exception; null for none
 * @param value returned literal; null for zero or if an exception is thrown
 */
record StubAnswer(double delay, @Nullable String error, @Nullable String value) {
  private static final String DELAY = "!delay:";
  private static final String ERROR = "!error:";
  private static final Pattern DELAYED =
      Pattern.compile("!delay:([0-9]{1,6}(?:\\.[0-9]{1,9})?)(?: (.*))?", Pattern.DOTALL);

  /**
   * Parses an answer.
   *
   * @throws IllegalArgumentException if it is invalid
   */
  static StubAnswer parse(String answer) {
    double delay = 0;
    String rest = answer;
    if (answer.startsWith(DELAY)) {
      Matcher delayed = DELAYED.matcher(answer);
      if (!delayed.matches()) {
        throw new IllegalArgumentException(
            "'" + answer + "' is not a delay such as !delay:0.5 or !delay:0.5 VALUE, in seconds");
      }
      delay = Double.parseDouble(delayed.group(1));
      rest = delayed.group(2);
    }
    if (rest == null || !rest.startsWith(ERROR)) {
      return new StubAnswer(delay, null, rest);
    }
    String error = rest.substring(ERROR.length());
    if (!Words.isWord(error)) {
      throw new IllegalArgumentException("'" + rest + "' is not an error such as !error:NoEcho");
    }
    return new StubAnswer(delay, error, null);
  }

  /** Whether the answer is only a value. */
  boolean isPlain() {
    return delay == 0 && error == null && value != null;
  }
}
