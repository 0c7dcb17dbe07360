package org.sitaf.core.activity;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.document.YamlMapping;

/** Reads how a C++ component is compiled. Every word becomes one argument of the compiler. */
final class CppBuildReader {
  /** The keys of {@code component:} that it reads. */
  static final Set<String> ENTRIES =
      Set.of("packages", "includes", "defines", "standard", "flags", "cmake");

  private static final Set<String> STANDARDS = Set.of("14", "17", "20", "23");

  private static final Pattern DEFINE =
      Pattern.compile("[A-Za-z_][A-Za-z0-9_]{0,99}(=[^\\p{Cntrl}]{0,200})?");

  /**
   * Options that change code or warnings. None of them can name a file, a plug-in or another
   * program, as {@code -Wl,...}, {@code -B}, {@code -fplugin} and {@code -specs} can.
   */
  private static final List<Pattern> FLAGS =
      List.of(
          Pattern.compile("-O([0-3gs]|fast)"),
          Pattern.compile("-W(?!l$|a$|p$)[a-z][a-z0-9+-]{0,60}(=[0-9]{1,3})?"),
          Pattern.compile("-(pedantic|pedantic-errors|fopenmp|fpermissive)"),
          Pattern.compile(
              "-f(no-)?(fast-math|math-errno|finite-math-only|rounding-math|signaling-nans"
                  + "|trapping-math|signed-zeros|associative-math|reciprocal-math"
                  + "|unsafe-math-optimizations|strict-aliasing|wrapv|trapv|char8_t|unroll-loops"
                  + "|tree-vectorize|inline|stack-protector|stack-protector-strong"
                  + "|delete-null-pointer-checks|strict-overflow)"),
          Pattern.compile("-f(signed|unsigned)-char"),
          Pattern.compile("-ffp-contract=(on|off|fast)"),
          Pattern.compile("-m(sse[0-9.a-z]{0,5}|avx2?|fma|bmi2?|popcnt)"),
          Pattern.compile("-m(arch|tune)=[a-z0-9.-]{1,30}"));

  private static final Pattern TARGET =
      Pattern.compile("[A-Za-z0-9_][A-Za-z0-9_.+-]{0,99}(::[A-Za-z0-9_.+-]{1,100})*");

  private static final Pattern OPTION = Pattern.compile("[A-Za-z_][A-Za-z0-9_.-]{0,99}");

  private CppBuildReader() {}

  /** Reads the entries of a component; problems are added to its diagnostics. */
  static CppBuild read(YamlMapping entry, Language language) {
    List<String> present = ENTRIES.stream().filter(entry::has).sorted().toList();
    if (present.isEmpty()) {
      return CppBuild.DEFAULT;
    }
    if (language != Language.CPP) {
      present.forEach(
          name -> entry.problem(name, "is only allowed for components in C++; remove it"));
      return CppBuild.DEFAULT;
    }
    if (entry.has("cmake")) {
      List.of("defines", "flags").stream()
          .filter(entry::has)
          .forEach(
              name ->
                  entry.problem(
                      name,
                      "has no effect on a component that CMake builds; write it in"
                          + " CMakeLists.txt"));
    } else if (!entry.has("sources")) {
      List.of("standard", "flags").stream()
          .filter(entry::has)
          .forEach(
              name ->
                  entry.problem(
                      name,
                      "has no effect on a compiled library; give the sources of the component, or"
                          + " remove it"));
    }
    return new CppBuild(
        entry.texts("packages"),
        entry.texts("includes"),
        defines(entry),
        standard(entry),
        flags(entry),
        entry.mapping("cmake").map(CppBuildReader::cmake).orElse(null));
  }

  /** The folder of the CMake project of a component; empty if it has none. */
  static Optional<String> cmakeProject(YamlMapping entry) {
    return entry.mapping("cmake").map(cmake -> cmake.requiredText("project"));
  }

  private static CmakeTarget cmake(YamlMapping entry) {
    entry.allowOnly(Set.of("project", "target", "options"));
    String target = entry.requiredText("target");
    if (!target.isEmpty() && !TARGET.matcher(target).matches()) {
      entry.problem("target", "'" + target + "' is no name of a target of CMake");
    }
    Map<String, String> options = new TreeMap<>();
    entry
        .mapping("options")
        .ifPresent(
            all ->
                all.names()
                    .forEach(
                        name -> {
                          if (!OPTION.matcher(name).matches()) {
                            all.problem(name, "is no name of a variable of CMake");
                          }
                          all.text(name).ifPresent(value -> options.put(name, value));
                        }));
    return new CmakeTarget(target, options);
  }

  private static int standard(YamlMapping entry) {
    String standard = entry.text("standard").orElse(Integer.toString(CppBuild.DEFAULT_STANDARD));
    if (!STANDARDS.contains(standard)) {
      entry.problem("standard", "must be 14, 17, 20 or 23, not '" + standard + "'");
      return CppBuild.DEFAULT_STANDARD;
    }
    return Integer.parseInt(standard);
  }

  private static List<String> flags(YamlMapping entry) {
    List<String> flags = entry.texts("flags");
    for (String flag : flags) {
      if (FLAGS.stream().noneMatch(pattern -> pattern.matcher(flag).matches())) {
        entry.problem(
            "flags",
            "'"
                + flag
                + "' is not allowed; allowed are optimization (-O2), warnings (-Wextra), and"
                + " options of arithmetic and of the processor such as -ffast-math and -mavx2."
                + (flag.startsWith("-D") ? " Write macros in defines:" : "")
                + (flag.startsWith("-I") ? " Write folders in includes:" : "")
                + (flag.startsWith("-l") || flag.startsWith("-L")
                    ? " Write libraries in packages: or libraries:"
                    : "")
                + (flag.startsWith("-std") ? " Write standard: 20" : ""));
      }
    }
    return flags;
  }

  private static List<String> defines(YamlMapping entry) {
    List<String> defines = entry.texts("defines");
    defines.stream()
        .filter(text -> !DEFINE.matcher(text).matches())
        .forEach(
            text ->
                entry.problem("defines", "'" + text + "' is no macro such as NAME or NAME=VALUE"));
    return defines;
  }
}
