package org.sitaf.core.document;

import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Cells of comma-separated values (RFC 4180) that are safe from formula injection: a text that a
 * spreadsheet would evaluate as a formula is prefixed with an apostrophe, which is removed when the
 * cell is read.
 */
public final class CsvCells {
  /**
   * Also matches text that already has leading apostrophes: without another one, reading would
   * remove one of them.
   */
  private static final Pattern FORMULA = Pattern.compile("(?s)'*[=+\\-@\t\r].*");

  private static final Pattern NUMBER =
      Pattern.compile("'*[+-]?((\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?|Infinity|Inf|inf)");

  private CsvCells() {}

  /** Formats a line, including the line break. */
  public static String line(List<String> cells) {
    return cells.stream().map(CsvCells::cell).collect(Collectors.joining(",", "", "\r\n"));
  }

  /** The original text of a cell that {@link #line} wrote. */
  public static String read(String cell) {
    return cell.startsWith("'") && isFormula(cell.substring(1)) ? cell.substring(1) : cell;
  }

  private static String cell(String text) {
    String safe = isFormula(text) ? "'" + text : text;
    return safe.matches("(?s).*[\",\r\n].*") || safe.startsWith(" ") || safe.endsWith(" ")
        ? '"' + safe.replace("\"", "\"\"") + '"'
        : safe;
  }

  private static boolean isFormula(String text) {
    return FORMULA.matcher(text).matches() && !NUMBER.matcher(text).matches();
  }
}
