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
 * @param message of the cases; a number that differs between them is shown as {@code …}
 * @param cases in the order of the suite; at least one
 */
public record FailureGroup(Verdict verdict, String message, List<CaseResult> cases) {
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
        .map(cases -> new FailureGroup(cases.get(0).verdict(), common(cases), cases))
        .toList();
  }

  /** The verdict and the message without the numbers of its first line: equal within a group. */
  public static String kind(CaseResult result) {
    String message = result.message().strip();
    int end = endOfFirstLine(message);
    return result.verdict()
        + ": "
        + String.join(ANY_NUMBER, parts(message.substring(0, end)).get(0))
        + message.substring(end);
  }

  private static int endOfFirstLine(String message) {
    int end = message.indexOf('\n');
    return end < 0 ? message.length() : end;
  }

  /** The text without its numbers, and the numbers. */
  private static List<List<String>> parts(String line) {
    List<String> texts = new ArrayList<>();
    List<String> numbers = new ArrayList<>();
    Matcher matcher = NUMBER.matcher(line);
    int end = 0;
    while (numbers.size() < MAX_NUMBERS && matcher.find()) {
      texts.add(line.substring(end, matcher.start()));
      numbers.add(matcher.group());
      end = matcher.end();
    }
    texts.add(line.substring(end));
    return List.of(texts, numbers);
  }

  private static String common(List<CaseResult> cases) {
    String first = cases.get(0).message().strip();
    int end = endOfFirstLine(first);
    List<List<String>> parts = parts(first.substring(0, end));
    List<List<String>> numbers =
        cases.stream()
            .map(c -> c.message().strip())
            .map(m -> parts(m.substring(0, endOfFirstLine(m))).get(1))
            .toList();
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < parts.get(0).size(); i++) {
      text.append(parts.get(0).get(i));
      if (i < parts.get(1).size()) {
        String number = parts.get(1).get(i);
        int at = i;
        text.append(numbers.stream().allMatch(n -> n.get(at).equals(number)) ? number : ANY_NUMBER);
      }
    }
    return text + first.substring(end);
  }
}
