package org.sitaf.core.description.idl.preprocessor;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sitaf.core.description.idl.preprocessor.Condition.ConditionException;
import org.sitaf.core.description.idl.preprocessor.LogicalLines.Line;
import org.sitaf.core.description.idl.preprocessor.MacroExpansion.MacroException;
import org.sitaf.core.diagnostic.Diagnostics;

/** Preprocesses a file with all files that it includes. */
public final class Preprocessor {
  /** Maximum depth of includes, as in most compilers. */
  private static final int MAX_INCLUDES = 200;

  /** Maximum size of the text with everything included, in characters. */
  private static final int MAX_TEXT = 16 << 20;

  /** Maximum size of all files that are read, each as often as it is included, in characters. */
  private static final int MAX_READ = 64 << 20;

  /** Maximum number of tokens that macros expand to. */
  private static final int MAX_TOKENS = 4_000_000;

  /**
   * Macros that compilers of IDL define, so that a file shows its declarations instead of the C
   * code next to them: {@code __IDL__} is common, {@code __IDLC__} is Cyclone DDS's.
   */
  private static final List<String> PREDEFINED = List.of("__IDL__", "__IDLC__");

  /** Finds included files. */
  public interface Includes {
    /**
     * The path of an included file.
     *
     * @param from path of the including file
     * @param name as written, without quotes or brackets
     */
    Optional<String> find(String from, String name);

    /** The content of a file that was found. */
    String text(String path);
  }

  private final Includes includes;
  private final Diagnostics diagnostics;
  private final Map<String, Macro> macros = new HashMap<>();
  private final MacroExpansion expansion = new MacroExpansion(macros, MAX_TOKENS);
  private final PreprocessedText output;
  private int depth;
  private int unread = MAX_READ;
  private boolean stopped;

  private Preprocessor(String path, Includes includes, Diagnostics diagnostics) {
    this.includes = includes;
    this.diagnostics = diagnostics;
    this.output = new PreprocessedText(path);
    for (String name : PREDEFINED) {
      macros.put(name, new Macro(name, null, Lexeme.split("1")));
    }
  }

  /** Preprocesses a file. Problems are added to the diagnostics; the rest of the text is given. */
  public static PreprocessedText read(String path, Includes includes, Diagnostics diagnostics) {
    Preprocessor preprocessor = new Preprocessor(path, includes, diagnostics);
    preprocessor.include(path);
    return preprocessor.output;
  }

  /** Conditional sections of one file. */
  private static final class Sections {
    /**
     * @param line of its {@code #if}
     * @param done whether a branch was taken, or none can be
     */
    private record Section(int line, boolean active, boolean done, boolean last) {}

    private final Deque<Section> open = new ArrayDeque<>();

    boolean isActive() {
      return open.stream().allMatch(Section::active);
    }
  }

  private void include(String path) {
    Sections sections = new Sections();
    String content = includes.text(path);
    // An empty file counts, too.
    unread -= content.length() + 1_000;
    if (unread < 0) {
      diagnostics.error(
          path, 1, "", "files are included too often; is one without a guard against that?");
      stopped = true;
      return;
    }
    List<Line> lines = LogicalLines.of(content);
    for (int i = 0; i < lines.size() && !stopped; i++) {
      Line line = lines.get(i);
      String text = line.text().strip();
      try {
        if (text.startsWith("#")) {
          directive(text.substring(1), sections, path, line.number());
        } else if (sections.isActive()) {
          i = text(lines, i, path);
        }
      } catch (MacroException | ConditionException e) {
        diagnostics.error(path, line.number(), "", String.valueOf(e.getMessage()));
        stopped |= e instanceof MacroException;
      }
    }
    if (!sections.open.isEmpty() && !stopped) {
      diagnostics.error(
          path, sections.open.getLast().line(), "", "this section has no #endif; add it");
    }
  }

  /** Adds a line of text, with the following ones if a macro call continues there. */
  private int text(List<Line> lines, int from, String path) throws MacroException {
    int at = from;
    List<Lexeme> lexemes = new ArrayList<>(Lexeme.split(lines.get(at).text()));
    if (lexemes.stream().noneMatch(lexeme -> macros.containsKey(lexeme.text()))) {
      add(lines.get(at).text(), path, lines.get(at).number());
      return at;
    }
    while (expansion.isOpen(lexemes)
        && at + 1 < lines.size()
        && !lines.get(at + 1).text().strip().startsWith("#")) {
      at++;
      lexemes.add(Lexeme.BLANK);
      lexemes.addAll(Lexeme.split(lines.get(at).text()));
    }
    add(Lexeme.text(expansion.expand(lexemes)), path, lines.get(from).number());
    return at;
  }

  private void add(String text, String path, int line) throws MacroException {
    output.add(text, path, line);
    if (output.length() > MAX_TEXT) {
      throw new MacroException(
          "with all included files the text is longer than " + (MAX_TEXT >> 20) + " MiB; split it");
    }
  }

  private void directive(String text, Sections sections, String path, int line)
      throws MacroException, ConditionException {
    List<Lexeme> lexemes = Lexeme.splitTrimmed(text);
    if (lexemes.isEmpty()) {
      return;
    }
    String name = lexemes.get(0).text();
    List<Lexeme> rest = rest(lexemes);
    switch (name) {
      case "if", "ifdef", "ifndef" -> begin(name, rest, sections, line);
      case "elif", "else", "endif" -> change(name, rest, sections, path, line);
      default -> {
        if (sections.isActive()) {
          effective(name, rest, path, line);
        }
      }
    }
  }

  private static List<Lexeme> rest(List<Lexeme> lexemes) {
    int from = lexemes.size() > 1 && lexemes.get(1).isSpace() ? 2 : 1;
    return lexemes.subList(from, lexemes.size());
  }

  private void begin(String name, List<Lexeme> rest, Sections sections, int line)
      throws MacroException, ConditionException {
    boolean outer = sections.isActive();
    // If the condition has an error, the section is left out.
    sections.open.push(new Sections.Section(line, false, true, false));
    boolean holds = outer && holds(name, rest);
    sections.open.pop();
    sections.open.push(new Sections.Section(line, holds, holds || !outer, false));
  }

  private boolean holds(String name, List<Lexeme> rest) throws MacroException, ConditionException {
    if (name.equals("if")) {
      return Condition.isTrue(rest, macros::containsKey, expansion);
    }
    if (rest.isEmpty() || !rest.get(0).isName()) {
      throw new ConditionException("#" + name + " needs the name of a macro");
    }
    return macros.containsKey(rest.get(0).text()) == name.equals("ifdef");
  }

  private void change(String name, List<Lexeme> rest, Sections sections, String path, int line)
      throws MacroException, ConditionException {
    Sections.Section section = sections.open.poll();
    if (section == null) {
      diagnostics.error(path, line, "", "#" + name + " has no #if before it");
      return;
    }
    if (name.equals("endif")) {
      return;
    }
    if (section.last()) {
      diagnostics.error(path, line, "", "#" + name + " follows #else of line " + section.line());
    }
    boolean isElse = name.equals("else");
    sections.open.push(new Sections.Section(section.line(), false, true, isElse));
    boolean holds =
        !section.done() && (isElse || Condition.isTrue(rest, macros::containsKey, expansion));
    sections.open.pop();
    sections.open.push(
        new Sections.Section(section.line(), holds, section.done() || holds, isElse));
  }

  private void effective(String name, List<Lexeme> rest, String path, int line)
      throws MacroException {
    switch (name) {
      case "include" -> include(rest, path, line);
      case "define" ->
          Macro.read(rest)
              .ifPresentOrElse(
                  macro -> macros.put(macro.name(), macro),
                  () ->
                      diagnostics.error(
                          path,
                          line,
                          "",
                          "#define needs a name, and a list of parameters that is closed"));
      case "undef" -> rest.stream().limit(1).forEach(macro -> macros.remove(macro.text()));
      case "error" -> diagnostics.error(path, line, "", "#error " + Lexeme.text(rest).strip());
      case "warning" ->
          diagnostics.warning(path, line, "", "#warning " + Lexeme.text(rest).strip());
      case "pragma", "line", "ident" -> {
        // They change nothing in what is declared.
      }
      default ->
          diagnostics.error(path, line, "", "#" + name + " is not a directive of the preprocessor");
    }
  }

  private void include(List<Lexeme> rest, String path, int line) throws MacroException {
    String text = Lexeme.text(rest).strip();
    if (!text.startsWith("\"") && !text.startsWith("<")) {
      text = Lexeme.text(expansion.expand(rest)).strip();
    }
    int end = text.isEmpty() ? -1 : text.indexOf(text.startsWith("<") ? '>' : '"', 1);
    if (end < 0) {
      diagnostics.error(path, line, "", "#include needs a file: #include \"NAME.idl\"");
      return;
    }
    String name = text.substring(1, end);
    Optional<String> found = includes.find(path, name);
    if (found.isEmpty()) {
      diagnostics.warning(
          path,
          line,
          "",
          "the included file '"
              + name
              + "' was not found; add its folder with -I, or with idl_includes in activity.yaml");
      return;
    }
    if (depth >= MAX_INCLUDES) {
      throw new MacroException(
          "files are included deeper than " + MAX_INCLUDES + " levels; is one without a guard?");
    }
    depth++;
    include(found.get());
    depth--;
  }
}
