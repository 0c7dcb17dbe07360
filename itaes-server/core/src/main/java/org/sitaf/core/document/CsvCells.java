package org.sitaf.core.document;

import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Cells of comma-separated values, as RFC 4180 has them, which no spreadsheet takes for a formula:
 * a text that begins like one gets an apostrophe before it, and loses it when it is read again.
 */
public final class CsvCells {
  /** With further apostrophes before it, it must get one too, or it would lose one. */
  private static final Pattern FORMULA = Pattern.compile("(?s)'*[=+\\-@\t\r].*");

  private static final Pattern NUMBER =
      Pattern.compile("'*[+-]?((\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?|Infinity|Inf|inf)");

  private CsvCells() {}

  /** A line, with its end. */
  public static String line(List<String> cells) {
    return cells.stream().map(CsvCells::cell).collect(Collectors.joining(",", "", "\r\n"));
  }

  /** What a cell that was written so held. */
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
