package org.sitaf.cli.terminal;

import java.util.stream.Collectors;

/** Escapes control characters in users' text, such as escape sequences of a terminal. */
public final class Printable {
  private Printable() {}

  /**
   * Text of one or more lines. The lines after the first are indented.
   *
   * @param indent of the lines after the first
   */
  public static String lines(String text, String indent) {
    return text.strip()
        .lines()
        .map(line -> line(line.replace('\t', ' ')))
        .collect(Collectors.joining(System.lineSeparator() + indent));
  }

  /** One line of text; line breaks are escaped, too. */
  public static String line(String text) {
    StringBuilder printable = new StringBuilder(text.length());
    text.codePoints()
        .forEach(
            c -> {
              if (Character.isISOControl(c) || Character.getType(c) == Character.FORMAT) {
                printable.append(String.format("\\u%04x", c));
              } else {
                printable.appendCodePoint(c);
              }
            });
    return printable.toString();
  }
}
