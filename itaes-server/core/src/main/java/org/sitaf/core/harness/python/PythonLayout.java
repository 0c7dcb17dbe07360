package org.sitaf.core.harness.python;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.core.harness.layout.CodeLine;
import org.sitaf.core.harness.layout.CodeLine.Group;
import org.sitaf.core.harness.layout.Prose;

/** Breaks long lines of Python sources as {@code ruff format} does. */
final class PythonLayout {
  private static final int WIDTH = 88;
  private static final int INDENT = 4;
  private static final String QUOTES = "\"\"\"";

  private static final Pattern COMMENT = Pattern.compile("( *# )(.*)");
  private static final Pattern IMPORT = Pattern.compile("(from \\S+ import )(.*)");

  private final List<String> lines = new ArrayList<>();

  private PythonLayout() {}

  static String format(String source) {
    PythonLayout layout = new PythonLayout();
    List<String> docstring = new ArrayList<>();
    for (String line : source.lines().map(String::stripTrailing).toList()) {
      String text = line.strip();
      if (!docstring.isEmpty() || text.startsWith(QUOTES)) {
        docstring.add(line);
        boolean ends = text.length() > QUOTES.length() || docstring.size() > 1;
        if (ends && text.endsWith(QUOTES)) {
          layout.docstring(docstring);
          docstring.clear();
        }
      } else {
        layout.line(line);
      }
    }
    return String.join("\n", layout.lines) + "\n";
  }

  /** A docstring, with each paragraph on one line. */
  private void docstring(List<String> docstring) {
    String first = docstring.get(0);
    String pad = first.substring(0, first.indexOf(QUOTES));
    List<String> wrapped = new ArrayList<>();
    for (String line : docstring) {
      String paragraph = line.strip().replace(QUOTES, "");
      if (!paragraph.isEmpty()) {
        boolean summary = wrapped.isEmpty();
        if (!summary) {
          wrapped.add("");
        }
        String start = summary ? pad + QUOTES : pad;
        // The summary leaves room for the closing quotes.
        int width = summary ? WIDTH - QUOTES.length() : WIDTH;
        wrapped.addAll(Prose.wrap(paragraph, start, pad, width));
      }
    }
    if (wrapped.size() == 1) {
      lines.add(wrapped.get(0) + QUOTES);
    } else {
      lines.addAll(wrapped);
      lines.add(pad + QUOTES);
    }
  }

  private void line(String line) {
    Matcher comment = COMMENT.matcher(line);
    Matcher imported = IMPORT.matcher(line);
    if (comment.matches()) {
      String start = comment.group(1);
      lines.addAll(Prose.wrap(comment.group(2), start, start, WIDTH));
    } else if (imported.matches() && line.length() > WIDTH) {
      statement(0, imported.group(1) + "(" + imported.group(2) + ",)", "");
    } else {
      statement(line.length() - line.stripLeading().length(), line.strip(), "");
    }
  }

  /**
   * A statement, or an entry of a list in brackets.
   *
   * @param end text that follows on the last line
   */
  private void statement(int indent, String text, String end) {
    String pad = " ".repeat(indent);
    Optional<Group> list = text.startsWith("def ") ? new CodeLine(text).first() : listOf(text);
    if (indent + text.length() + end.length() <= WIDTH || list.isEmpty()) {
      lines.add((pad + text + end).stripTrailing());
      return;
    }
    Group group = list.get();
    lines.add(pad + text.substring(0, group.open() + 1));
    String together = String.join(", ", group.parts());
    if (!group.commaAtEnd() && indent + INDENT + together.length() <= WIDTH) {
      lines.add(pad + " ".repeat(INDENT) + together);
    } else {
      boolean one = group.parts().size() == 1 && !group.commaAtEnd();
      group.parts().forEach(part -> statement(indent + INDENT, part, one ? "" : ","));
    }
    lines.add(pad + text.substring(group.close()) + end);
  }

  private static Optional<Group> listOf(String text) {
    return new CodeLine(text).last();
  }
}
