package org.sitaf.core.compare;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.core.verdict.CaseRecord;

/**
 * The type and message of an error without what differs between runs and checkouts of the same
 * code: line numbers, addresses, folders, and the places that the runtimes append.
 */
public final class ErrorText {
  private static final String CAUSE = "; caused by ";

  /** {@code robot.Arm.move(Arm.java:12)} or {@code move (arm.py:12)}. */
  private static final String FRAME = "[^\\s()]{1,300} ?\\([^()]{0,300}:-?\\d{1,9}\\)";

  private static final Pattern PLACES =
      Pattern.compile(",? at " + FRAME + "(?:, " + FRAME + "){0,20}$");

  private static final Pattern QUALIFIER =
      Pattern.compile("^(?:[A-Za-z_$][\\w$]{0,200}(?:\\.|::)){1,40}(?=[A-Za-z_$])");

  /**
   * Few digits are an address only after a Java class or array, {@code a.Foo@1fc}, and after the
   * address of a hidden class: {@code a.Foo$$Lambda$25/0x00007f28@1c}.
   */
  private static final Pattern ADDRESS =
      Pattern.compile(
          "\\b0x[0-9a-fA-F]{1,16}\\b|(?<=[\\w$;])@[0-9a-f]{5,16}\\b"
              + "|(?<=/0x[0-9a-fA-F]{1,16})@[0-9a-f]{1,4}\\b"
              + "|(?<=\\w\\.[\\w$]{1,99}|\\[[A-Z]|[\\w$];)@[0-9a-f]{1,4}\\b");

  /** An absolute folder, or a relative one of a file with an extension. */
  private static final Pattern FOLDER =
      Pattern.compile(
          "(?<![\\w.~)])(?:[A-Za-z]:)?[/\\\\](?:[^\\s/\\\\'\"():,;<>]{1,255}[/\\\\]){0,50}"
              + "(?=[\\w.])"
              + "|(?<![\\w./\\\\])(?:[\\w.+@~-]{1,255}[/\\\\]){1,50}(?=[\\w+-]{1,255}\\.[A-Za-z])");

  private static final Pattern LINE =
      Pattern.compile("(?<=\\.[A-Za-z]{1,4}):\\d{1,9}(?::\\d{1,9})?|\\b([Ll]ine) \\d{1,9}\\b");

  private ErrorText() {}

  /** The normalised text; empty if the call returned. */
  static String of(CaseRecord record) {
    if (record.outcome() == CaseRecord.Outcome.RETURNED) {
      return "";
    }
    String message = withoutPlaces(record.message());
    if (record.outcome() != CaseRecord.Outcome.THREW) {
      return normalised(message.isEmpty() ? "error" : message);
    }
    Matcher qualifier = QUALIFIER.matcher(message);
    String text = normalised(qualifier.replaceFirst(""));
    return text.startsWith(record.thrown())
        ? text
        : record.thrown() + (text.isEmpty() ? "" : ": " + text);
  }

  /** A message without what differs between runs of the same code. */
  public static String ofMessage(String message) {
    return normalised(withoutPlaces(message));
  }

  private static String withoutPlaces(String message) {
    int cause = message.indexOf(CAUSE);
    return PLACES.matcher(cause < 0 ? message : message.substring(0, cause)).replaceFirst("");
  }

  /** The type of the error for groups. */
  static String type(CaseRecord record) {
    return switch (record.outcome()) {
      case RETURNED -> "";
      case THREW -> record.thrown();
      case ERROR, NOT_CALLED -> "error";
    };
  }

  static String normalised(String message) {
    String text = ADDRESS.matcher(message).replaceAll("0x");
    text = FOLDER.matcher(text).replaceAll("");
    text = LINE.matcher(text).replaceAll("$1");
    return text.strip();
  }
}
