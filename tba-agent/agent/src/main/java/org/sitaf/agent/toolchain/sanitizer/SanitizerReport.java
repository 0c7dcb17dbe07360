package org.sitaf.agent.toolchain.sanitizer;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Reads the reports of AddressSanitizer, UBSan and ThreadSanitizer in an error stream, which a
 * component may forge.
 */
public final class SanitizerReport {
  /** {@code SUMMARY: AddressSanitizer: heap-buffer-overflow FILE:LINE in FUNCTION}. */
  private static final Pattern SUMMARY =
      Pattern.compile(
          "SUMMARY: (?:Address|UndefinedBehavior|Thread)Sanitizer: ([\\w-]{1,60})(?: .*)?");

  /** {@code WARNING: ThreadSanitizer: data race (pid=7)}. */
  private static final Pattern THREADS =
      Pattern.compile("WARNING: ThreadSanitizer: ([\\w -]{1,60}?) \\(.*");

  /** {@code FILE:LINE:COLUMN: runtime error: MESSAGE}. */
  private static final Pattern UNDEFINED =
      Pattern.compile("(.{1,500}?):(\\d{1,9})(?::\\d{1,9})?: runtime error: (.{1,300}).*");

  /** {@code #3 0x55d0 in FUNCTION FILE:LINE}. */
  private static final Pattern FRAME =
      Pattern.compile(
          "\\s*#\\d{1,4} .{1,2000}?\\s(\\S{1,500}?):(\\d{1,9})(?::\\d{1,9})?(?: \\(.*\\))?");

  /** Sources of the user in the layout of a test application. */
  private static final Pattern OWN = Pattern.compile("(?:.*/)?activity/(.+)");

  private SanitizerReport() {}

  /**
   * The kind of the first error and its first line in the user's sources, such as {@code
   * heap-buffer-overflow at arm_hold.cpp:38}; empty without a report.
   */
  public static Optional<String> cause(String errors) {
    String undefined = "";
    String place = "";
    boolean begun = false;
    for (String line : (Iterable<String>) errors.lines()::iterator) {
      Matcher error = UNDEFINED.matcher(line);
      Matcher summary = SUMMARY.matcher(line);
      Matcher threads = THREADS.matcher(line);
      if (error.matches()) {
        begun = true;
        undefined = error.group(3).strip();
        place = placeOf(error);
      } else if (threads.matches()) {
        begun = true;
        undefined = threads.group(1);
        place = "";
      } else if (line.contains("ERROR: AddressSanitizer: ")) {
        begun = true;
        undefined = "";
        place = "";
      } else if (begun && summary.matches()) {
        return Optional.of(describe(undefined.isEmpty() ? summary.group(1) : undefined, place));
      } else if (begun && place.isEmpty()) {
        // The first stack is that of the error; later ones tell where memory came from.
        Matcher frame = FRAME.matcher(line);
        place = frame.matches() ? placeOf(frame) : "";
      }
    }
    return undefined.isEmpty() ? Optional.empty() : Optional.of(describe(undefined, place));
  }

  private static String describe(String kind, String place) {
    return place.isEmpty() ? kind : kind + " at " + place;
  }

  private static String placeOf(Matcher line) {
    Matcher own = OWN.matcher(line.group(1));
    if (!own.matches()) {
      return "";
    }
    String path = own.group(1);
    return path.substring(path.lastIndexOf('/') + 1) + ":" + line.group(2);
  }
}
