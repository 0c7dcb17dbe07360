package org.sitaf.core.harness.java;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sitaf.core.harness.layout.CodeLine;
import org.sitaf.core.harness.layout.CodeLine.Group;
import org.sitaf.core.harness.layout.Prose;

/** Breaks long lines of Java sources as google-java-format does. */
final class JavaLayout {
  private static final int WIDTH = 100;

  /** Indentation of a continued statement, in columns. */
  private static final int CONTINUATION = 4;

  private final List<String> lines = new ArrayList<>();

  private JavaLayout() {}

  static String format(String source) {
    JavaLayout layout = new JavaLayout();
    List<String> comment = new ArrayList<>();
    for (String line : source.lines().map(String::stripTrailing).toList()) {
      String text = line.strip();
      if (!comment.isEmpty() || text.startsWith("/**")) {
        comment.add(line);
        if (text.endsWith("*/")) {
          layout.comment(comment);
          comment.clear();
        }
      } else if (text.startsWith("// ")) {
        String start = line.substring(0, line.indexOf('/')) + "// ";
        layout.lines.addAll(Prose.wrap(text.substring(3), start, start, WIDTH));
      } else {
        layout.statement(line.length() - line.stripLeading().length(), "", text);
      }
    }
    return String.join("\n", layout.lines) + "\n";
  }

  /** A documentation comment, with each paragraph or block tag on one line. */
  private void comment(List<String> comment) {
    String first = comment.get(0);
    String pad = first.substring(0, first.indexOf('/'));
    List<String> paragraphs =
        comment.stream()
            .map(line -> line.strip().replaceFirst("^/?\\*+/? ?", "").replaceFirst(" ?\\*/$", ""))
            .filter(line -> !line.isEmpty())
            .toList();
    String only = pad + "/** " + paragraphs.get(0) + " */";
    if (paragraphs.size() == 1 && only.length() <= WIDTH) {
      lines.add(only);
      return;
    }
    lines.add(pad + "/**");
    for (int i = 0; i < paragraphs.size(); i++) {
      String paragraph = paragraphs.get(i);
      boolean tag = paragraph.startsWith("@");
      if (i > 0 && !(tag && paragraphs.get(i - 1).startsWith("@"))) {
        lines.add(pad + " *");
      }
      String start = pad + " * ";
      lines.addAll(Prose.wrap(paragraph, start, tag ? start + "    " : start, WIDTH));
    }
    lines.add(pad + " */");
  }

  /**
   * A statement or declaration.
   *
   * @param end text that follows on the last line
   */
  private void statement(int indent, String end, String text) {
    String pad = " ".repeat(indent);
    CodeLine code = new CodeLine(text);
    Optional<Group> group = code.last();
    int clause = text.lastIndexOf(" throws ");
    if (indent + text.length() + end.length() <= WIDTH) {
      lines.add((pad + text + end).stripTrailing());
    } else if (code.isAssignment()) {
      lines.add(pad + code.left());
      statement(indent + CONTINUATION, end, code.right());
    } else if (clause > 0 && group.stream().allMatch(g -> g.close() < clause)) {
      statement(indent, "", text.substring(0, clause));
      lines.add(pad + " ".repeat(CONTINUATION) + text.substring(clause + 1) + end);
    } else if (group.isPresent()) {
      broken(indent, text, group.get(), end);
    } else {
      lines.add(pad + text + end);
    }
  }

  private void broken(int indent, String text, Group group, String end) {
    lines.add(" ".repeat(indent) + text.substring(0, group.open() + 1));
    String after = text.substring(group.close()) + end;
    int inner = indent + CONTINUATION;
    String together = String.join(", ", group.parts());
    if (inner + together.length() + after.length() <= WIDTH) {
      lines.add(" ".repeat(inner) + together + after);
      return;
    }
    for (int i = 0; i < group.parts().size(); i++) {
      boolean last = i == group.parts().size() - 1;
      statement(inner, last ? after : ",", group.parts().get(i));
    }
  }
}
