package org.sitaf.agent.toolchain.cpp;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.ActivityProfile.Sanitizer;

/**
 * The compiler of this machine.
 *
 * @param version such as {@code g++ 12.2.0}
 */
record Compiler(Path program, String version) {
  /** Options of all compilations: line numbers for stack traces of crashes. */
  static final List<String> OPTIONS = List.of("-std=c++17", "-O1", "-g1", "-fPIC", "-pthread");

  /** The options for sources of another C++ standard. */
  static List<String> options(int standard) {
    List<String> options = new ArrayList<>(OPTIONS);
    options.set(0, "-std=c++" + standard);
    return options;
  }

  /** For a debugger; the last option of its kind counts, so these follow all others. */
  static final List<String> DEBUGGING = List.of("-O0", "-g");

  /** For generated sources and the runtime, whose warnings nobody can act on. */
  static final String WITHOUT_WARNINGS = "-w";

  /** For the user's sources. */
  static final String WITH_WARNINGS = "-Wall";

  private static final Pattern LIBRARY_FOLDER = Pattern.compile("SEARCH_DIR\\(\"=?([^\"]+)\"\\)");

  private static final Pattern MISSING_FOLDER =
      Pattern.compile("(?m)^ignoring nonexistent directory \"([^\"]+)\"$");

  /** Output of compilers about themselves, which does not change while they are installed. */
  private static final Map<List<String>, String> ANSWERS = new ConcurrentHashMap<>();

  /** Options of compilation and linking with sanitizers; an error ends the process. */
  static List<String> sanitizing(Set<Sanitizer> sanitizers) {
    if (sanitizers.isEmpty()) {
      return List.of();
    }
    String names = sanitizers.stream().map(Sanitizer::id).collect(Collectors.joining(","));
    return List.of("-fsanitize=" + names, "-fno-sanitize-recover=all", "-fno-omit-frame-pointer");
  }

  /** Options for diagnostics of one line without colors. */
  List<String> plainDiagnostics() {
    return List.of(
        "-fdiagnostics-color=never",
        isClang() ? "-fno-caret-diagnostics" : "-fno-diagnostics-show-caret");
  }

  /** Whether gcov can read its coverage notes; clang writes those of an older gcov. */
  boolean isMeasuredByGcov() {
    return !isClang();
  }

  /** Whether it runs a separate assembler, which can list its inputs. */
  boolean hasAssembler() {
    return !isClang();
  }

  private boolean isClang() {
    return version.startsWith("clang");
  }

  /**
   * The programs that compile, assemble and link, with size and modification time, because an
   * upgraded package may keep its version.
   */
  String identity() throws IOException {
    StringBuilder identity = new StringBuilder(program + " " + version);
    List<Path> programs = new ArrayList<>(List.of(program));
    searchPaths()
        .lines()
        .map(line -> line.strip().split(" ", 2)[0].replace("\"", ""))
        .filter(word -> word.startsWith("/") && !word.contains("//"))
        .map(Path::of)
        .filter(Files::isExecutable)
        .filter(Files::isRegularFile)
        .forEach(
            compiler -> {
              programs.add(compiler);
              programs.add(compiler.resolveSibling("collect2"));
            });
    Tools.find("as").ifPresent(programs::add);
    Tools.find("ld").ifPresent(programs::add);
    for (Path each : programs) {
      if (Files.exists(each)) {
        identity.append('\n').append(each.toRealPath()).append(' ').append(Files.size(each));
        identity.append(' ').append(Files.getLastModifiedTime(each));
      }
    }
    return identity.toString();
  }

  /** The default search path for headers. */
  List<Path> headerFolders() throws IOException {
    List<Path> folders = new ArrayList<>();
    // A missing folder may be created later.
    Matcher missing = MISSING_FOLDER.matcher(searchPaths());
    while (missing.find()) {
      folders.add(Path.of(missing.group(1)));
    }
    searchPaths()
        .lines()
        .dropWhile(line -> !line.startsWith("#include <...>"))
        .skip(1)
        .takeWhile(line -> line.startsWith(" "))
        .forEach(line -> folders.add(Path.of(line.strip())));
    return folders;
  }

  /** The default search path of the linker. */
  List<String> libraryFolders() throws IOException {
    List<String> folders = new ArrayList<>();
    Matcher ofLinker = LIBRARY_FOLDER.matcher(answer(List.of("ld", "--verbose"), false));
    while (ofLinker.find()) {
      folders.add(ofLinker.group(1));
    }
    answer(List.of(program.toString(), "-print-search-dirs"), false)
        .lines()
        .filter(line -> line.startsWith("libraries: ="))
        .flatMap(line -> Pattern.compile(":").splitAsStream(line.substring(12)))
        .forEach(folders::add);
    return folders;
  }

  private String searchPaths() throws IOException {
    return answer(
        List.of(program.toString(), OPTIONS.get(0), "-v", "-E", "-x", "c++", "/dev/null"), true);
  }

  private String answer(List<String> question, boolean errors) throws IOException {
    List<String> known = new ArrayList<>(question);
    known.add(Files.getLastModifiedTime(program).toString());
    return ANSWERS.computeIfAbsent(
        known, k -> (errors ? Tools.errorsOf(question) : Tools.outputOf(question)).orElse(""));
  }

  /** The named compiler, or the first one of this machine; empty if there is none. */
  static Optional<Path> find(@Nullable String named) {
    return named == null || named.isBlank()
        ? Tools.find("g++", "clang++")
        : Tools.find(named.strip());
  }

  static Compiler of(Path program) {
    String name = program.getFileName().toString();
    String number =
        Tools.outputOf(List.of(program.toString(), "-dumpfullversion", "-dumpversion"))
            .or(() -> Tools.outputOf(List.of(program.toString(), "-dumpversion")))
            .orElse("of unknown version");
    return new Compiler(program, name + " " + number);
  }
}
