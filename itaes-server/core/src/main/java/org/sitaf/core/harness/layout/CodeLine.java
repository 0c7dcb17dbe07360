package org.sitaf.core.harness.layout;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;

/**
 * A statement or declaration on one line, with its outermost brackets. Brackets in string and
 * character literals do not count. Angle brackets enclose type arguments where they follow a name.
 */
public final class CodeLine {
  private final String text;
  private final List<Group> groups = new ArrayList<>();

  /** The place of the first assignment outside of brackets, or -1. */
  private final int assignment;

  /** Text in outermost brackets: the places of both brackets, and the parts between commas. */
  public record Group(int open, int close, List<String> parts, boolean commaAtEnd) {
    public Group {
      parts = List.copyOf(parts);
    }
  }

  /** Reads a line without indentation. */
  public CodeLine(String text) {
    this.text = text;
    this.assignment = read();
  }

  private int read() {
    int assigned = -1;
    Deque<Character> open = new ArrayDeque<>();
    int start = 0;
    List<Integer> commas = new ArrayList<>();
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      switch (c) {
        case '"', '\'' -> i = endOfLiteral(i);
        case '(', '[', '{', '<' -> {
          if (c != '<' || opensTypeArguments(i)) {
            if (open.isEmpty()) {
              start = i;
              commas.clear();
            }
            open.push(c);
          }
        }
        case ')', ']', '}', '>' -> {
          if (!open.isEmpty() && open.peek() == opening(c) && !isArrow(i)) {
            open.pop();
            if (open.isEmpty() && c != '>') {
              groups.add(group(start, i, commas));
            }
          }
        }
        case ',' -> {
          if (open.size() == 1) {
            commas.add(i);
          }
        }
        case '=' -> {
          if (open.isEmpty() && assigned < 0 && text.startsWith(" = ", i - 1)) {
            assigned = i;
          }
        }
        default -> {}
      }
    }
    return assigned;
  }

  private int endOfLiteral(int start) {
    char quote = text.charAt(start);
    int i = start + 1;
    while (i < text.length() && text.charAt(i) != quote) {
      i += text.charAt(i) == '\\' ? 2 : 1;
    }
    return i;
  }

  private boolean opensTypeArguments(int at) {
    return at > 0
        && Character.isJavaIdentifierPart(text.charAt(at - 1))
        && at + 1 < text.length()
        && text.charAt(at + 1) != ' '
        && text.charAt(at + 1) != '=';
  }

  private boolean isArrow(int at) {
    return text.charAt(at) == '>' && at > 0 && text.charAt(at - 1) == '-';
  }

  private static char opening(char closing) {
    return switch (closing) {
      case ')' -> '(';
      case ']' -> '[';
      case '}' -> '{';
      default -> '<';
    };
  }

  private Group group(int open, int close, List<Integer> commas) {
    List<String> parts = new ArrayList<>();
    int from = open + 1;
    for (int comma : commas) {
      parts.add(text.substring(from, comma).strip());
      from = comma + 1;
    }
    String last = text.substring(from, close).strip();
    if (!last.isEmpty()) {
      parts.add(last);
    }
    return new Group(open, close, parts, last.isEmpty() && !commas.isEmpty());
  }

  /** The line. */
  public String text() {
    return text;
  }

  /** The outermost groups in brackets, from left to right. */
  public List<Group> groups() {
    return List.copyOf(groups);
  }

  /** The first group that is not empty. */
  public Optional<Group> first() {
    return groups.stream().filter(g -> !g.parts().isEmpty()).findFirst();
  }

  /** The last group that is not empty. */
  public Optional<Group> last() {
    return groups.stream().filter(g -> !g.parts().isEmpty()).reduce((a, b) -> b);
  }

  /** Whether a value is assigned outside of brackets. */
  public boolean isAssignment() {
    return assignment >= 0;
  }

  /** An assignment up to and including the equals sign. */
  public String left() {
    return text.substring(0, assignment + 1);
  }

  /** The value of an assignment, with the end of the statement. */
  public String right() {
    return text.substring(assignment + 2);
  }
}
