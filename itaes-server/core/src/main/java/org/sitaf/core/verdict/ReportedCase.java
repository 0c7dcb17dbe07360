package org.sitaf.core.verdict;

import java.util.List;
import java.util.Locale;
import java.util.Objects;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.TestCase;

/**
 * What a test application says about a case of the suite. What it measured is its own; the values
 * and what is expected are the suite's.
 */
public record ReportedCase(TestCase testCase, CaseResult result) {
  public ReportedCase {
    Objects.requireNonNull(testCase);
    Objects.requireNonNull(result);
  }

  /** Whether it names the values, and what is expected, as the suite has them. */
  public boolean isOfSuite() {
    return sameValues(testCase.values(), result.values()) && sameExpectations();
  }

  /** The result with the values of the suite. */
  public CaseResult withValuesOfSuite() {
    return new CaseResult(
        testCase.no(),
        result.verdict(),
        testCase.values(),
        testCase.expected().stream().map(e -> new NamedValue(e.output(), e.literal())).toList(),
        result.actual(),
        result.calls(),
        result.time(),
        result.message());
  }

  private static boolean sameValues(List<String> wanted, List<String> reported) {
    if (wanted.size() != reported.size()) {
      return false;
    }
    for (int i = 0; i < wanted.size(); i++) {
      if (!same(wanted.get(i), reported.get(i))) {
        return false;
      }
    }
    return true;
  }

  private boolean sameExpectations() {
    List<ExpectedValue> wanted = testCase.expected();
    List<NamedValue> reported = result.expected();
    if (wanted.size() != reported.size()) {
      return false;
    }
    for (int i = 0; i < wanted.size(); i++) {
      if (!wanted.get(i).output().equals(reported.get(i).output())
          || !same(wanted.get(i).literal(), reported.get(i).literal())) {
        return false;
      }
    }
    return true;
  }

  /** A line spells out the characters that XML cannot hold. */
  private static boolean same(String wanted, String reported) {
    return wanted.equals(reported) || spelledOut(wanted).equals(reported);
  }

  /** A text as results spell it. */
  static String spelledOut(String text) {
    StringBuilder escaped = new StringBuilder();
    text.codePoints()
        .forEach(
            c -> {
              boolean isXml =
                  c == '\t'
                      || c == '\n'
                      || c == '\r'
                      || c >= 0x20 && c <= 0xD7FF
                      || c >= 0xE000 && c <= 0xFFFD
                      || c >= 0x10000;
              if (isXml) {
                escaped.appendCodePoint(c);
              } else {
                escaped.append(String.format(Locale.ROOT, "\\u%04X", c));
              }
            });
    return escaped.toString();
  }
}
