package org.sitaf.core.harness.ros;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Writes JSON in ASCII, in the order of the maps, with one member of the outer two levels a line.
 */
final class JsonText {
  private static final int OPEN_LEVELS = 2;

  private final StringBuilder text = new StringBuilder();

  private JsonText() {}

  static String of(Map<String, ?> document) {
    JsonText json = new JsonText();
    json.write(document, 0);
    return json.text.append('\n').toString();
  }

  private void write(@Nullable Object value, int level) {
    if (value instanceof Map<?, ?> map) {
      between(
          '{',
          '}',
          map.entrySet(),
          level,
          e -> {
            string(String.valueOf(e.getKey()));
            text.append(": ");
            write(e.getValue(), level + 1);
          });
    } else if (value instanceof List<?> list) {
      between('[', ']', list, level, item -> write(item, level + 1));
    } else if (value instanceof Double number) {
      // As Python reads them.
      text.append(
          number.isNaN()
              ? "NaN"
              : number.isInfinite() ? (number > 0 ? "Infinity" : "-Infinity") : number.toString());
    } else if (value == null || value instanceof Number || value instanceof Boolean) {
      text.append(value);
    } else {
      string(value.toString());
    }
  }

  private <T> void between(
      char open,
      char close,
      java.util.Collection<T> items,
      int level,
      java.util.function.Consumer<T> write) {
    String separator = level < OPEN_LEVELS ? "\n" + "  ".repeat(level + 1) : "";
    text.append(open);
    boolean first = true;
    for (T item : items) {
      text.append(first ? "" : level < OPEN_LEVELS ? "," : ", ").append(separator);
      write.accept(item);
      first = false;
    }
    if (!first && level < OPEN_LEVELS) {
      text.append('\n').append("  ".repeat(level));
    }
    text.append(close);
  }

  private void string(String value) {
    text.append('"');
    for (char c : value.toCharArray()) {
      if (c == '"' || c == '\\') {
        text.append('\\').append(c);
      } else if (c >= ' ' && c < 0x7f) {
        text.append(c);
      } else {
        text.append(String.format(Locale.ROOT, "\\u%04x", (int) c));
      }
    }
    text.append('"');
  }
}
