package org.sitaf.agent.toolchain.cpp;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * The compiler of this machine.
 *
 * @param version such as {@code g++ 12.2.0}
 */
record Compiler(Path program, String version) {
  /**
   * How everything is compiled: with names and lines for what a crash says, without what a
   * component's warnings would drown.
   */
  static final List<String> OPTIONS =
      List.of("-std=c++17", "-O1", "-g1", "-fPIC", "-pthread", "-w");

  private static final Pattern LIBRARY_FOLDER = Pattern.compile("SEARCH_DIR\\(\"=?([^\"]+)\"\\)");

  private static final Pattern MISSING_FOLDER =
      Pattern.compile("(?m)^ignoring nonexistent directory \"([^\"]+)\"$");

  /**
   * What compilers of this machine say of themselves, which does not change while they are there.
   */
  private static final Map<List<String>, String> ANSWERS = new ConcurrentHashMap<>();

  /** Diagnostics in one line each, without colours. */
  List<String> plainDiagnostics() {
    return List.of(
        "-fdiagnostics-color=never",
        isClang() ? "-fno-caret-diagnostics" : "-fno-diagnostics-show-caret");
  }

  /**
   * Whether what it notes of coverage is what gcov reads: clang's has the form of an older gcov.
   */
  boolean isMeasuredByGcov() {
    return !isClang();
  }

  /** Whether it hands assembly to a program of its own, which notes itself what it opens. */
  boolean hasAssembler() {
    return !isClang();
  }

  private boolean isClang() {
    return version.startsWith("clang");
  }

  /**
   * Names the programs that compile, assemble and link, as they are installed now: a package that
   * is upgraded may keep its version.
   */
  String identity() throws IOException {
    StringBuilder identity = new StringBuilder(program + " " + version);
    List<Path> programs = new ArrayList<>(List.of(program));
    said()
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

  /** Where it looks for headers by default. */
  List<Path> headerFolders() throws IOException {
    List<Path> folders = new ArrayList<>();
    // One that is not there may come.
    Matcher missing = MISSING_FOLDER.matcher(said());
    while (missing.find()) {
      folders.add(Path.of(missing.group(1)));
    }
    said()
        .lines()
        .dropWhile(line -> !line.startsWith("#include <...>"))
        .skip(1)
        .takeWhile(line -> line.startsWith(" "))
        .forEach(line -> folders.add(Path.of(line.strip())));
    return folders;
  }

  /** Where its linker may look for libraries. */
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

  private String said() throws IOException {
    return answer(
        List.of(program.toString(), OPTIONS.get(0), "-v", "-E", "-x", "c++", "/dev/null"), true);
  }

  private String answer(List<String> question, boolean errors) throws IOException {
    List<String> known = new ArrayList<>(question);
    known.add(Files.getLastModifiedTime(program).toString());
    return ANSWERS.computeIfAbsent(
        known, k -> (errors ? Tools.askForErrors(question) : Tools.ask(question)).orElse(""));
  }

  /** The compiler that is named, or else the first of this machine; empty where there is none. */
  static Optional<Path> find(@Nullable String named) {
    return named == null || named.isBlank()
        ? Tools.find("g++", "clang++")
        : Tools.find(named.strip());
  }

  static Compiler of(Path program) {
    String name = program.getFileName().toString();
    String number =
        Tools.ask(List.of(program.toString(), "-dumpfullversion", "-dumpversion"))
            .or(() -> Tools.ask(List.of(program.toString(), "-dumpversion")))
            .orElse("of unknown version");
    return new Compiler(program, name + " " + number);
  }
}
