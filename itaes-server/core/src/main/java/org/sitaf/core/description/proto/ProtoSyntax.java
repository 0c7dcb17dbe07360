package org.sitaf.core.description.proto;

import com.squareup.wire.schema.Location;
import com.squareup.wire.schema.internal.parser.ProtoFileElement;
import com.squareup.wire.schema.internal.parser.ProtoParser;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.core.diagnostic.Diagnostics;

/** Parses {@code .proto} files. */
final class ProtoSyntax {
  /** Maximum nesting of brackets. The parser recurses once per level. */
  private static final int MAX_DEPTH = 40;

  /**
   * A fixed file name for the parser: a real one could contain anything and break {@link #WHERE}.
   */
  private static final String PLACE = "file.proto";

  private static final Pattern WHERE = Pattern.compile(PLACE + ":(\\d{1,8}):\\d+");

  private ProtoSyntax() {}

  /** Returns the parsed file, or empty after a syntax error, which is added to the diagnostics. */
  static Optional<ProtoFileElement> parse(String text, String file, Diagnostics diagnostics) {
    int deepLine = firstTooDeepLine(text);
    if (deepLine > 0) {
      diagnostics.error(file, deepLine, "", "brackets nest deeper than " + MAX_DEPTH + " levels");
      return Optional.empty();
    }
    try {
      return Optional.of(
          ProtoParser.Companion.parse(Location.get("", PLACE), ProtoEdition.asProto3(text)));
    } catch (RuntimeException e) {
      // Wire reports syntax errors as IllegalStateException; hostile text can also cause other
      // exceptions, such as NumberFormatException.
      String message = String.valueOf(e.getMessage());
      Matcher where = WHERE.matcher(message);
      int line = where.find() ? Integer.parseInt(where.group(1)) : 0;
      String reason =
          where
              .reset(message.replaceFirst("^Syntax error in " + WHERE + ": ", ""))
              .replaceAll("line $1");
      diagnostics.error(
          file,
          line,
          "",
          "cannot be read: "
              + (reason.length() <= 300 ? reason : reason.substring(0, 300) + "..."));
      return Optional.empty();
    }
  }

  /**
   * The first line with too deep nesting; 0 if there is none. Brackets in comments and strings are
   * ignored.
   */
  private static int firstTooDeepLine(String text) {
    int depth = 0;
    int line = 1;
    for (int i = 0; i < text.length(); i++) {
      switch (text.charAt(i)) {
        case '\n' -> line++;
        case '{', '[', '(', '<' -> depth++;
        case '}', ']', ')', '>' -> depth = Math.max(0, depth - 1);
        case '"', '\'' -> i = endOfText(text, i);
        case '/' -> {
          int end = endOfComment(text, i);
          for (; i < end; i++) {
            line += text.charAt(i) == '\n' ? 1 : 0;
          }
        }
        default -> {
          // Other characters do not change the nesting.
        }
      }
      if (depth > MAX_DEPTH) {
        return line;
      }
    }
    return 0;
  }

  /** Index of the closing quote. A string ends at the end of its line. */
  private static int endOfText(String text, int quote) {
    int i = quote + 1;
    while (i < text.length() && text.charAt(i) != text.charAt(quote) && text.charAt(i) != '\n') {
      i += text.charAt(i) == '\\' ? 2 : 1;
    }
    return i < text.length() && text.charAt(i) == '\n' ? i - 1 : i;
  }

  /** Index of the last character of a comment, or of the slash if no comment begins there. */
  private static int endOfComment(String text, int slash) {
    if (text.startsWith("//", slash)) {
      int end = text.indexOf('\n', slash);
      return end < 0 ? text.length() : end - 1;
    }
    if (text.startsWith("/*", slash)) {
      int end = text.indexOf("*/", slash + 2);
      return end < 0 ? text.length() : end + 1;
    }
    return slash;
  }
}
