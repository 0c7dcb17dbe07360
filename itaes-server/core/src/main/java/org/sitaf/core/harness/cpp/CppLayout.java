package org.sitaf.core.harness.cpp;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.core.harness.layout.CodeLine;
import org.sitaf.core.harness.layout.CodeLine.Group;
import org.sitaf.core.harness.layout.Prose;

/** Breaks long lines of C++ sources as clang-format does in Google style with 100 columns. */
final class CppLayout {
  private static final int WIDTH = 100;

  /** Indentation of a continued statement, in columns. */
  private static final int CONTINUATION = 4;

  private static final Pattern COMMENT = Pattern.compile("( *///? )(.*)");

  private final List<String> lines = new ArrayList<>();

  private CppLayout() {}

  static String format(String source) {
    CppLayout layout = new CppLayout();
    source.lines().map(String::stripTrailing).forEach(layout::line);
    return String.join("\n", layout.lines) + "\n";
  }

  private void line(String line) {
    Matcher comment = COMMENT.matcher(line);
    if (comment.matches()) {
      String start = comment.group(1);
      lines.addAll(Prose.wrap(comment.group(2), start, start, WIDTH));
    } else if (line.length() <= WIDTH || line.startsWith("#")) {
      lines.add(line);
    } else {
      statement(line.length() - line.stripLeading().length(), new CodeLine(line.strip()));
    }
  }

  private void statement(int indent, CodeLine code) {
    String pad = " ".repeat(indent);
    int initialisers = initialisers(code.text());
    Optional<Group> list = code.last();
    if (indent + code.text().length() <= WIDTH || list.isEmpty()) {
      lines.add(pad + code.text());
    } else if (initialisers >= 0) {
      constructor(indent, code.text(), initialisers);
    } else if (isBody(code, list.get())) {
      body(indent, code.text(), list.get());
    } else if (code.isAssignment()
        && code.left().length() <= list.get().open()
        && (list.get().parts().size() == 1
            || indent + CONTINUATION + code.right().length() <= WIDTH)) {
      lines.add(pad + code.left());
      statement(indent + CONTINUATION, new CodeLine(code.right()));
    } else {
      list(indent, code.text(), list.get());
    }
  }

  /** The place of the bracket before a constructor's initialisers, or -1. */
  private static int initialisers(String text) {
    return text.endsWith("{}") || text.endsWith(" {") ? text.indexOf(") : ") : -1;
  }

  /** Whether the last group is the body of a function. */
  private static boolean isBody(CodeLine code, Group group) {
    String text = code.text();
    return text.charAt(group.open()) == '{'
        && group.close() == text.length() - 1
        && text.substring(0, group.close()).stripTrailing().endsWith(";");
  }

  private void body(int indent, String text, Group body) {
    statement(indent, new CodeLine(text.substring(0, body.open() + 1)));
    String inner = text.substring(body.open() + 1, body.close()).strip();
    statement(indent + 2, new CodeLine(inner));
    lines.add(" ".repeat(indent) + "}");
  }

  /**
   * A constructor with initialisers of members.
   *
   * @param colon the place of the bracket before the colon
   */
  private void constructor(int indent, String text, int colon) {
    String pad = " ".repeat(indent);
    statement(indent, new CodeLine(text.substring(0, colon + 1)));
    String all = text.substring(colon + 4);
    String start = pad + " ".repeat(CONTINUATION) + ": ";
    if (start.length() + all.length() <= WIDTH) {
      lines.add(start + all);
      return;
    }
    List<Group> groups = new CodeLine(all).groups();
    int from = 0;
    for (int i = 0; i < groups.size(); i++) {
      Group group = groups.get(i);
      boolean last = i == groups.size() - 1 || all.charAt(group.close() + 1) != ',';
      String part = last ? all.substring(from) : all.substring(from, group.close() + 2);
      lines.add((i == 0 ? start : pad + " ".repeat(CONTINUATION + 2)) + part.strip());
      if (last) {
        return;
      }
      from = group.close() + 2;
    }
  }

  /** Puts as many parts on a line as fit: after the bracket, or on the next line. */
  private void list(int indent, String text, Group group) {
    boolean spaced = text.charAt(group.open() + 1) == ' ';
    String head = " ".repeat(indent) + text.substring(0, group.open() + (spaced ? 2 : 1));
    String tail = (spaced ? " " : "") + text.substring(group.close());
    int widest = group.parts().stream().mapToInt(String::length).max().orElse(0);
    int column = head.length();
    if (column + widest + Math.max(1, tail.length()) > WIDTH) {
      lines.add(head.stripTrailing());
      column = indent + CONTINUATION;
      head = " ".repeat(column);
    }
    StringBuilder line = new StringBuilder(head);
    for (int i = 0; i < group.parts().size(); i++) {
      String part = group.parts().get(i) + (i == group.parts().size() - 1 ? tail : ",");
      if (i > 0 && line.length() + 1 + part.length() > WIDTH) {
        lines.add(line.toString());
        line = new StringBuilder(" ".repeat(column));
      } else if (i > 0) {
        line.append(' ');
      }
      line.append(part);
    }
    lines.add(line.toString());
  }
}
