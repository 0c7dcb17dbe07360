package org.sitaf.agent.toolchain.cpp.inputs;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The names in the include directives of a source, in all branches, whether or not a file is found.
 * A comment that looks like a directive adds a name, which costs at most a compilation; no name is
 * missing.
 *
 * @param names in the order of the text
 * @param computed whether a directive gets its name from a macro or cannot be parsed
 * @param unknown whether the source may look for names that its text does not show and that need
 *     not exist
 * @param assembly whether the source may contain assembly, which can include files, too
 */
record AskedNames(List<Name> names, boolean computed, boolean unknown, boolean assembly) {
  private static final Pattern SPLICE = Pattern.compile("\\\\[ \\t]*\\r?\\n");
  private static final Pattern WORD =
      Pattern.compile(
          "(?<![A-Za-z0-9_])(__has_include|__has_include_next|__has_embed|include|include_next"
              + "|import|embed)(?![A-Za-z0-9_])");
  private static final Pattern LITERAL = Pattern.compile("[ \\t]*(?:<([^>\\n]+)>|\"([^\"\\n]+)\")");
  private static final Pattern ARGUMENT =
      Pattern.compile("[ \\t]*\\([ \\t]*(?:<([^>\\n]+)>|\"([^\"\\n]+)\")");
  private static final Pattern CALL = Pattern.compile("[ \\t]*\\(");
  private static final Pattern DEFINITION = Pattern.compile("[ \\t]*(#|%:)[ \\t]*define\\b");

  AskedNames {
    names = List.copyOf(names);
  }

  /**
   * A name as written.
   *
   * @param quoted whether the folder of the including file is searched first
   */
  record Name(String text, boolean quoted) {
    /** Its folder; empty if it has none. */
    String folder() {
      return text.substring(0, Math.max(0, text.lastIndexOf('/')));
    }
  }

  static AskedNames in(byte[] source) {
    String text = SPLICE.matcher(new String(source, StandardCharsets.ISO_8859_1)).replaceAll("");
    Set<Name> names = new LinkedHashSet<>();
    boolean computed = false;
    boolean unknown = false;
    Matcher word = WORD.matcher(text);
    while (word.find()) {
      boolean question = word.group().startsWith("__");
      Matcher literal =
          (question ? ARGUMENT : LITERAL).matcher(text).region(word.end(), text.length());
      if (question) {
        if (literal.lookingAt()) {
          unknown |= !add(names, literal);
        } else if (CALL.matcher(text).region(word.end(), text.length()).lookingAt()) {
          unknown = true;
        } else {
          // As a macro of another name; elsewhere one only asks whether the compiler has it.
          unknown |= DEFINITION.matcher(line(text, word.start())).lookingAt();
        }
      } else if (isDirective(text, word.start())) {
        computed |= !(literal.lookingAt() && add(names, literal));
      }
    }
    return new AskedNames(new ArrayList<>(names), computed, unknown, text.contains("asm"));
  }

  /** Adds a name; returns false if it is absolute or cannot be the name of a file. */
  private static boolean add(Set<Name> names, Matcher literal) {
    boolean quoted = literal.group(2) != null;
    byte[] name = literal.group(quoted ? 2 : 1).getBytes(StandardCharsets.ISO_8859_1);
    String text = new String(name, StandardCharsets.UTF_8);
    boolean usable = !text.startsWith("/") && text.chars().noneMatch(c -> c < ' ');
    if (usable) {
      names.add(new Name(text, quoted));
    }
    return usable;
  }

  private static boolean isDirective(String text, int at) {
    int before = at - 1;
    while (before >= 0 && (text.charAt(before) == ' ' || text.charAt(before) == '\t')) {
      before--;
    }
    String end = text.substring(Math.max(0, before - 1), before + 1);
    // A directive may follow a comment.
    return end.endsWith("#") || end.equals("%:") || end.equals("*/");
  }

  private static String line(String text, int at) {
    return text.substring(text.lastIndexOf('\n', at) + 1, at);
  }
}
