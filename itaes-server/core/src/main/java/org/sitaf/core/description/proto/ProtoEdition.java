package org.sitaf.core.description.proto;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Writes files with an edition as proto3, which the parser reads. What an edition decides, such as
 * the presence of fields and their encoding, does not change the types of an interface; what its
 * grammar adds has no counterpart and is removed. Lines stay where they are.
 *
 * @see <a href="https://protobuf.dev/reference/protobuf/edition-2024-spec/">Grammar</a>
 */
final class ProtoEdition {
  private static final Set<String> KNOWN = Set.of("2023", "2024");
  private static final Set<String> VISIBILITIES = Set.of("export", "local");
  private static final Set<String> WORDS_OF_RANGES = Set.of("to", "max");

  /** Comments, strings, words, white space, and other single characters. */
  private static final Pattern TOKEN =
      Pattern.compile(
          "//[^\\n]*+|/\\*[\\s\\S]*?\\*/|\"(?:\\\\.|[^\"\\\\\\n])*+\"|'(?:\\\\.|[^'\\\\\\n])*+'"
              + "|\\w++|\\s++|[\\s\\S]");

  private final List<String> tokens = new ArrayList<>();

  /** Indices of the tokens that are neither white space nor comments. */
  private final List<Integer> significant = new ArrayList<>();

  private ProtoEdition(String text) {
    Matcher token = TOKEN.matcher(text);
    while (token.find()) {
      String found = token.group();
      if (!found.isBlank() && !found.startsWith("//") && !found.startsWith("/*")) {
        significant.add(tokens.size());
      }
      tokens.add(found);
    }
  }

  /** The same text if it has no edition. */
  static String asProto3(String text) {
    return text.contains("edition") ? new ProtoEdition(text).written(text) : text;
  }

  private String written(String text) {
    if (!token(0).equals("edition") || !token(1).equals("=")) {
      return text;
    }
    String edition = token(2).replaceAll("^[\"']|[\"']$", "");
    if (!KNOWN.contains(edition)) {
      throw new IllegalStateException(
          "the edition " + edition + " is not supported; 2023 and 2024 are");
    }
    set(0, "syntax");
    set(2, "\"proto3\"");
    boolean begins = false;
    for (int i = 3; i < significant.size(); i++) {
      String word = token(i);
      if (begins && VISIBILITIES.contains(word) && isDeclaration(token(i + 1))) {
        set(i, "");
      } else if (begins && word.equals("import") && token(i + 1).equals("option")) {
        // It declares options, which no interface uses.
        i = remove(i);
      } else if (begins && word.equals("reserved")) {
        i = quoteNames(i + 1);
      }
      String last = token(i);
      begins = last.equals(";") || last.equals("{") || last.equals("}") || last.isEmpty();
    }
    return String.join("", tokens);
  }

  private static boolean isDeclaration(String word) {
    return word.equals("message") || word.equals("enum");
  }

  /** Removes a statement; returns the index of its end. */
  private int remove(int first) {
    int i = first;
    for (; i < significant.size() - 1 && !token(i).equals(";"); i++) {
      set(i, "");
    }
    set(i, "");
    return i;
  }

  /** Puts reserved names into quotes, as before editions; returns the index of the end. */
  private int quoteNames(int first) {
    int i = first;
    for (; i < significant.size() - 1 && !token(i).equals(";"); i++) {
      String word = token(i);
      if (word.matches("[A-Za-z_]\\w*") && !WORDS_OF_RANGES.contains(word)) {
        set(i, '"' + word + '"');
      }
    }
    return i;
  }

  /** The token at an index among the significant ones; empty beyond the last. */
  private String token(int index) {
    return index < significant.size() ? tokens.get(significant.get(index)) : "";
  }

  private void set(int index, String text) {
    if (index < significant.size()) {
      tokens.set(significant.get(index), text);
    }
  }
}
