package org.sitaf.core.verdict;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Cases that did not pass for the same reason: an exception of the same type from the same place,
 * or messages that are equal except for numbers in the first line.
 *
 * @param cases in the order of the suite; at least one
 */
public record FailureGroup(Verdict verdict, List<CaseResult> cases) {
  private static final Pattern NUMBER =
      Pattern.compile(
          "(?<![\\w.])[-+]?(?:\\d+(?:\\.\\d+)?(?:[eE][-+]?\\d+)?|NaN|Infinity)(?![\\w])");
  private static final String ANY_NUMBER = "…";

  /** The frames of an exception as the runtimes of Java and Python describe it. */
  private static final Pattern FRAMES =
      Pattern.compile(
          " at ([^\\s():]{1,300} ?\\([^():]{1,300}:\\d{1,9}\\)"
              + "(?:, [^\\s():]{1,300} ?\\([^():]{1,300}:\\d{1,9}\\)){0,9})");

  private static final Pattern TYPE = Pattern.compile("[\\w.$]{1,300}");

  /** Numbers of cases in a line. */
  private static final int MAX_CASES = 40;

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

  /** The group in one line: verdict, number and numbers of the cases, message of the first. */
  public String line() {
    String first = message().substring(0, endOfFirstLine(message()));
    return title(true) + (first.isEmpty() ? "" : ": " + first);
  }

  /**
   * Verdict and number of the cases.
   *
   * @param numbered whether the numbers of the cases follow
   */
  public String title(boolean numbered) {
    String numbers =
        cases.stream()
            .limit(MAX_CASES)
            .map(c -> Integer.toString(c.no()))
            .collect(Collectors.joining(", ", " (", cases.size() > MAX_CASES ? ", ...)" : ")"));
    return verdict
        + " in "
        + cases.size()
        + (cases.size() == 1 ? " case" : " cases")
        + (numbered ? numbers : "")
        + (isUniform() ? "" : "; case " + cases.get(0).no());
  }

  /** Whether all cases have the same message. */
  public boolean isUniform() {
    return cases.stream().allMatch(c -> c.message().strip().equals(message()));
  }

  /**
   * Equal within a group: the verdict, and the type and the place of an exception, or the message
   * without the numbers of its first line.
   */
  public static String kind(CaseResult result) {
    String message = result.message().strip();
    Matcher frames = FRAMES.matcher(message);
    Matcher type = TYPE.matcher(message);
    if (result.verdict() == Verdict.ERROR && type.lookingAt() && frames.find()) {
      return result.verdict() + ": " + type.group() + " at " + frames.group(1);
    }
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
