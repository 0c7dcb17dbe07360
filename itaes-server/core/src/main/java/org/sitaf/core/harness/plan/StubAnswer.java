package org.sitaf.core.harness.plan;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * What a stubbed method does when it is called, as a test case spells it: {@code VALUE}, {@code
 * !error:NAME}, {@code !delay:SECONDS}, or a delay and, after a space, one of the others.
 *
 * @param delay in seconds; 0 for none
 * @param error name of what is thrown; null where nothing is
 * @param value the literal that is returned; null where that is the zero of the type, or an error
 *     is thrown
 */
record StubAnswer(double delay, @Nullable String error, @Nullable String value) {
  private static final String DELAY = "!delay:";
  private static final String ERROR = "!error:";
  private static final Pattern DELAYED =
      Pattern.compile("!delay:([0-9]{1,6}(?:\\.[0-9]{1,9})?)(?: (.*))?", Pattern.DOTALL);

  /**
   * Reads an answer.
   *
   * @throws IllegalArgumentException when it is neither a value nor spelled as above
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
      throw new IllegalArgumentException(
          "'" + rest + "' is not an error such as !error:NoEcho, with the name of an exception");
    }
    return new StubAnswer(delay, error, null);
  }

  /** Whether it is a value and nothing else. */
  boolean isPlain() {
    return delay == 0 && error == null && value != null;
  }
}
