package org.sitaf.agent.toolchain.cpp.inputs;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What compiler, assembler and linker note of the files that they opened. The names in it may be a
 * user's, so whatever is not written as these tools write it is not understood.
 */
public final class DependencyFile {
  private DependencyFile() {}

  /**
   * The prerequisites of the one rule that a compiler writes, as it printed them.
   *
   * @param target of the rule, without characters that would be escaped
   * @return empty where the text is anything but that rule
   */
  public static Optional<List<String>> rule(String target, String text) {
    String head = target + ":";
    if (!text.startsWith(head) || !text.endsWith("\n")) {
      return Optional.empty();
    }
    List<String> names = new ArrayList<>();
    StringBuilder name = new StringBuilder();
    int end = text.length() - 1;
    for (int i = head.length(); i < end; i++) {
      char c = text.charAt(i);
      char next = text.charAt(i + 1);
      if (c == '\\' && next == '\n' || c == ' ') {
        if (!name.isEmpty()) {
          names.add(name.toString());
          name.setLength(0);
        }
        i += c == ' ' ? 0 : 1;
      } else if (c == '\\' && (next == ' ' || next == '#') || c == '$' && next == '$') {
        name.append(next);
        i++;
      } else if (c == '\\' || c == '$' || c < ' ' || c == 0x7f) {
        return Optional.empty();
      } else {
        name.append(c);
      }
    }
    if (!name.isEmpty()) {
      names.add(name.toString());
    }
    return Optional.of(names);
  }

  /**
   * What a linker opened: its first rule has one name a line, without any escape; the rules behind
   * it say nothing more.
   */
  public static Optional<List<String>> ofLinker(String text) {
    List<String> lines = text.lines().toList();
    if (lines.isEmpty() || !lines.get(0).endsWith(": \\")) {
      return Optional.empty();
    }
    List<String> names = new ArrayList<>();
    for (String line : lines.subList(1, lines.size())) {
      boolean more = line.endsWith(" \\");
      if (!line.startsWith("  ")) {
        return Optional.empty();
      }
      names.add(line.substring(2, line.length() - (more ? 2 : 0)));
      if (!more) {
        return Optional.of(names);
      }
    }
    return Optional.empty();
  }
}
