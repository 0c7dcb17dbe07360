package org.sitaf.agent.toolchain.cpp.inputs;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Parses the dependency files of compiler, assembler and linker. They contain file names chosen by
 * users, so any unexpected syntax is rejected.
 */
public final class DependencyFile {
  private DependencyFile() {}

  /**
   * The prerequisites of the only rule in a compiler's file.
   *
   * @param target target of the rule, without characters that need escaping
   * @return empty if the text is anything else
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
   * The files that a linker opened. Its first rule has one unescaped name per line; the other rules
   * are ignored.
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
