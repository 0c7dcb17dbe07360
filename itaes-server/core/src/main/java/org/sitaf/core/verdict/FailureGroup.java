package org.sitaf.core.verdict;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Cases that did not pass for the same reason: their verdicts and messages are equal except for
 * numbers in the first line. The other lines, such as the place of an exception, are equal.
 *
 * @param cases in the order of the suite; at least one
 */
public record FailureGroup(Verdict verdict, List<CaseResult> cases) {
  private static final Pattern NUMBER =
      Pattern.compile(
          "(?<![\\w.])[-+]?(?:\\d+(?:\\.\\d+)?(?:[eE][-+]?\\d+)?|NaN|Infinity)(?![\\w])");
  private static final String ANY_NUMBER = "…";

  /** Numbers beyond these are compared as text. */
  private static final int MAX_NUMBERS = 100;

  public FailureGroup {
    cases = List.copyOf(cases);
  }

  /** The groups of the cases that did not pass; the group of the first such case is first. */
  public static List<FailureGroup> of(List<CaseResult> results) {
    Map<String, List<CaseResult>> groups = new LinkedHashMap<>();
    for (CaseResult result : results) {
      if (result.verdict() != Verdict.PASS) {
        groups.computeIfAbsent(kind(result), key -> new ArrayList<>()).add(result);
      }
    }
    return groups.values().stream()
        .map(cases -> new FailureGroup(cases.get(0).verdict(), cases))
        .toList();
  }

  /** The message of the first case. */
  public String message() {
    return cases.get(0).message().strip();
  }

  /** Whether all cases have the same message. */
  public boolean isUniform() {
    return cases.stream().allMatch(c -> c.message().strip().equals(message()));
  }

  /** The verdict and the message without the numbers of its first line: equal within a group. */
  public static String kind(CaseResult result) {
    String message = result.message().strip();
    int end = endOfFirstLine(message);
    return result.verdict()
        + ": "
        + withoutNumbers(message.substring(0, end))
        + message.substring(end);
  }

  private static int endOfFirstLine(String message) {
    int end = message.indexOf('\n');
    return end < 0 ? message.length() : end;
  }

  private static String withoutNumbers(String line) {
    StringBuilder text = new StringBuilder();
    Matcher matcher = NUMBER.matcher(line);
    int numbers = 0;
    while (numbers < MAX_NUMBERS && matcher.find()) {
      matcher.appendReplacement(text, ANY_NUMBER);
      numbers++;
    }
    return matcher.appendTail(text).toString();
  }
}
