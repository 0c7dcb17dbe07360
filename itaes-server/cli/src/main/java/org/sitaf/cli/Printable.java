package org.sitaf.cli;

/**
 * Text of users, made harmless for a terminal: escape sequences and other control characters become
 * visible.
 */
public final class Printable {
  private Printable() {}

  /** One line of text. */
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
