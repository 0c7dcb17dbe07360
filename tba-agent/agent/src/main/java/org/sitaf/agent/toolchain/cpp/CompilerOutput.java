package org.sitaf.agent.toolchain.cpp;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.agent.toolchain.SourceDiagnostic;

/**
 * Parses the output of compiler and linker: {@code FILE:LINE:COLUMN: error: MESSAGE}, and the same
 * with {@code warning}, of both g++ and clang++, and the linker's undefined references.
 */
final class CompilerOutput {
  private static final int AT_MOST = 100;

  private static final Pattern ERROR =
      Pattern.compile("(.+?):(\\d+):(?:(\\d+):)? (?:fatal )?error: (.*)");

  /** Location where a template was instantiated; precedes the error in the template. */
  private static final Pattern REQUIRED =
      Pattern.compile("(.+?):(\\d+):(?:(\\d+):)?\\s+required from .*");

  private static final Pattern UNDEFINED =
      Pattern.compile("(?:.*?ld[^:]*: )?(?:(.+?):(\\d+): )?(undefined reference to .*)");
  private static final Pattern OTHER_LINK =
      Pattern.compile(".*?ld[^:]*: (.*(?:cannot find|multiple definition|not found).*)");

  private static final Pattern WARNING = Pattern.compile("(.+?):(\\d+):(?:(\\d+):)? warning: (.*)");

  private final Function<String, Place> places;
  private final Set<SourceDiagnostic> found = new LinkedHashSet<>();
  private final Set<String> warnings = new LinkedHashSet<>();

  /**
   * A file as the user knows it.
   *
   * @param path in the layout of the application; empty if it is not part of the application
   */
  record Place(String path, boolean generated) {
    static final Place ELSEWHERE = new Place("", true);
  }

  CompilerOutput(Function<String, Place> places) {
    this.places = places;
  }

  /** Parses the error stream of one run. */
  void read(String errors) {
    SourceDiagnostic used = null;
    for (String line : errors.lines().toList()) {
      Matcher required = REQUIRED.matcher(line);
      Matcher error = ERROR.matcher(line);
      Matcher undefined = UNDEFINED.matcher(line);
      Matcher other = OTHER_LINK.matcher(line);
      if (required.matches()) {
        SourceDiagnostic place = diagnostic(required, "");
        used = place.file().isEmpty() ? used : place;
      } else if (error.matches()) {
        SourceDiagnostic diagnostic = diagnostic(error, error.group(4));
        add(diagnostic.file().isEmpty() && used != null ? at(used, diagnostic) : diagnostic);
        used = null;
      } else if (undefined.matches()) {
        Place place =
            undefined.group(1) == null ? Place.ELSEWHERE : places.apply(undefined.group(1));
        int lineNumber = place.path().isEmpty() ? 0 : number(undefined.group(2));
        add(
            new SourceDiagnostic(
                place.path(), lineNumber, 0, undefined.group(3), place.generated()));
      } else if (other.matches()) {
        add(new SourceDiagnostic("", 0, 0, other.group(1), false));
      }
    }
  }

  /** Parses the warnings of one run; those outside of the user's sources are dropped. */
  void readWarnings(String errors) {
    for (String line : errors.lines().toList()) {
      Matcher warning = WARNING.matcher(line);
      if (warning.matches() && warnings.size() < AT_MOST) {
        SourceDiagnostic place = diagnostic(warning, "");
        if (!place.generated()) {
          String column = place.column() == 0 ? "" : place.column() + ":";
          warnings.add(
              place.file() + ":" + place.line() + ":" + column + " warning: " + warning.group(4));
        }
      }
    }
  }

  /** The warnings about the user's sources, one line each. */
  Set<String> warnings() {
    return warnings;
  }

  /** The errors; those in the user's files come first. */
  List<SourceDiagnostic> errors() {
    List<SourceDiagnostic> sorted = new ArrayList<>(found);
    sorted.sort(java.util.Comparator.comparing(SourceDiagnostic::generated));
    return sorted;
  }

  private void add(SourceDiagnostic diagnostic) {
    if (found.size() < AT_MOST) {
      found.add(diagnostic);
    }
  }

  private SourceDiagnostic diagnostic(Matcher line, String message) {
    Place place = places.apply(line.group(1));
    boolean known = !place.path().isEmpty();
    return new SourceDiagnostic(
        place.path(),
        known ? number(line.group(2)) : 0,
        known && line.group(3) != null ? number(line.group(3)) : 0,
        message,
        place.generated());
  }

  private static SourceDiagnostic at(SourceDiagnostic place, SourceDiagnostic what) {
    return new SourceDiagnostic(
        place.file(), place.line(), place.column(), what.message(), place.generated());
  }

  private static int number(String digits) {
    return digits.length() > 9 ? Integer.MAX_VALUE : Integer.parseInt(digits);
  }
}
