package org.sitaf.agent.toolchain.cpp;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.Confinement;
import org.sitaf.agent.sandbox.ProcessLimits;
import org.sitaf.agent.sandbox.ToolResult;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.agent.toolchain.cpp.cmake.LinkedTarget;
import org.sitaf.core.activity.ActivityProfile;

/**
 * Libraries of a component: its own, external ones, system packages known to pkg-config, and what
 * its CMake project built.
 *
 * @param compileFlags options for every translation unit
 * @param linkFlags options after the object files
 * @param cmake null if the component is no CMake project
 */
record CppLibraries(
    List<String> compileFlags, List<String> linkFlags, @Nullable LinkedTarget cmake) {
  private static final Pattern PACKAGE =
      Pattern.compile("([A-Za-z0-9][A-Za-z0-9+._-]*)(?:==([A-Za-z0-9.+~:-]+))?");

  /** A file name; the library is not trusted. */
  private static final Pattern SONAME =
      Pattern.compile("\\(SONAME\\).*\\[([A-Za-z0-9_][A-Za-z0-9_.+-]{0,199})]");

  /**
   * Options with files that the compiler does not list among those that it opened: programs and
   * plugins that it runs, and files of options.
   */
  private static final Pattern UNLISTED =
      Pattern.compile(
          "@.*|--?(B|specs|wrapper|fplugin|fpass-plugin|fprofile-use|fauto-profile|fbranch-prob"
              + "|fsanitize-.*list|Wa,|Xassembler|Xclang|Xpreprocessor|Wp,|load|config|sysroot"
              + "|isysroot).*");

  CppLibraries {
    compileFlags = List.copyOf(compileFlags);
    linkFlags = List.copyOf(linkFlags);
  }

  /**
   * Checks the libraries and copies shared ones next to the program.
   *
   * @param cmake null if the component is no CMake project
   */
  static CppLibraries of(Compilation compilation, @Nullable LinkedTarget cmake)
      throws CompilationException, IOException, InterruptedException {
    ActivityProfile profile = compilation.application().activity().profile();
    List<SourceDiagnostic> problems = new ArrayList<>();
    List<String> compile = new ArrayList<>();
    List<String> link = new ArrayList<>();
    List<String> wanted = new ArrayList<>(profile.libraries());
    if (profile.component().library() != null) {
      wanted.add(0, profile.component().library());
    }
    for (String library : wanted) {
      String file = library.substring(library.lastIndexOf('/') + 1);
      Path path = compilation.activity().resolve(library);
      if (!file.matches(".+\\.(a|so(\\.[0-9]+)*)")) {
        problems.add(
            inProfile("library " + library + ": expected a .so or .a for a C++ component"));
      } else if (!compilation.application().activity().files().contains(library)) {
        problems.add(inProfile("library " + library + ": no such file in the activity"));
      } else if (file.endsWith(".a")) {
        link.add(path.toString());
      } else {
        Path copy = copyToOutput(compilation, path);
        // By name: with its path, a library without a SONAME would be needed in the folder of this
        // build, also by a later build that uses the same program.
        link.addAll(List.of("-L" + copy.getParent(), "-l:" + copy.getFileName()));
      }
    }
    if (cmake != null) {
      compile.addAll(cmake.compileFlags());
      link.addAll(cmake.linkFlags());
      for (Path library : cmake.sharedLibraries()) {
        copyToOutput(compilation, library);
      }
    }
    addPackages(profile, compile, link, problems);
    if (!problems.isEmpty()) {
      throw new CompilationException("the component's libraries cannot be used", problems);
    }
    return new CppLibraries(compile, link, cmake);
  }

  /** The C++ standard for sources that use the libraries, at least the given one. */
  int standard(int atLeast) {
    return cmake == null ? atLeast : Math.max(atLeast, cmake.standard());
  }

  /**
   * Whether an object that was compiled with the flags depends on nothing but them and the files
   * that the compiler lists.
   */
  boolean areInputsListed() {
    return compileFlags.stream().noneMatch(flag -> UNLISTED.matcher(flag).matches());
  }

  /** Whether a file is output of the component's CMake project. */
  boolean isBuilt(String path) {
    return cmake != null && path.startsWith(cmake.folder() + "/");
  }

  /** The current flags of the component's packages; empty if it has none. */
  static String packageFlags(ActivityProfile profile) {
    List<String> compile = new ArrayList<>();
    List<String> link = new ArrayList<>();
    List<SourceDiagnostic> problems = new ArrayList<>();
    addPackages(profile, compile, link, problems);
    return compile.isEmpty() && link.isEmpty() && problems.isEmpty()
        ? ""
        : compile + "\n" + link + "\n" + problems;
  }

  private static void addPackages(
      ActivityProfile profile,
      List<String> compile,
      List<String> link,
      List<SourceDiagnostic> problems) {
    ActivityProfile.Component component = profile.component();
    if (component.packageName() != null) {
      addPackage("package: ", component.packageName(), compile, link, problems);
    }
    for (String wanted : component.cpp().packages()) {
      addPackage("packages: ", wanted, compile, link, problems);
    }
  }

  /**
   * @param entry of the activity, with a colon
   */
  private static void addPackage(
      String entry,
      String wanted,
      List<String> compile,
      List<String> link,
      List<SourceDiagnostic> problems) {
    Matcher parts = PACKAGE.matcher(wanted);
    if (!parts.matches()) {
      problems.add(
          inProfile(entry + "'" + wanted + "' is not a name such as orocos-kdl or eigen3==3.4.0"));
      return;
    }
    Optional<String> known =
        List.of(parts.group(1), parts.group(1).replace('-', '_'), parts.group(1).replace('_', '-'))
            .stream()
            .filter(PkgConfig::exists)
            .findFirst();
    if (known.isEmpty()) {
      problems.add(
          inProfile(
              entry
                  + "pkg-config on this machine does not know "
                  + parts.group(1)
                  + "; install the Debian package that holds "
                  + parts.group(1)
                  + ".pc (often lib"
                  + parts.group(1)
                  + "-dev)"));
      return;
    }
    String version = PkgConfig.version(known.get()).orElse("");
    if (parts.group(2) != null && !parts.group(2).equals(version)) {
      problems.add(
          inProfile(
              entry + known.get() + " is here in version " + version + ", not " + parts.group(2)));
      return;
    }
    compile.addAll(flags("--cflags", known.get()));
    link.addAll(flags("--libs", known.get()));
  }

  /** Header folders in the flags. */
  List<Path> headerFolders() {
    List<Path> folders = new ArrayList<>();
    for (int i = 0; i < compileFlags.size(); i++) {
      String word = compileFlags.get(i);
      for (String option : List.of("-isystem", "-idirafter", "-I")) {
        if (word.equals(option) && i + 1 < compileFlags.size()) {
          folders.add(Path.of(compileFlags.get(i + 1)));
        } else if (word.startsWith(option) && word.length() > option.length()) {
          folders.add(Path.of(word.substring(option.length())));
        }
      }
    }
    return folders;
  }

  private static List<String> flags(String which, String library) {
    return PkgConfig.flags(which, List.of(library)).orElse(List.of());
  }

  /** Copies a shared library next to the program, under its file name and its SONAME. */
  private static Path copyToOutput(Compilation compilation, Path library)
      throws IOException, InterruptedException {
    Path folder = Files.createDirectories(compilation.output().resolve(CppApplication.LIBRARIES));
    Path copy = folder.resolve(library.getFileName());
    Files.copy(library, copy, StandardCopyOption.REPLACE_EXISTING);
    Path working = Files.createTempDirectory(compilation.scratch(), "tool");
    ToolResult end =
        compilation
            .sandbox()
            .run(
                Confinement.of(
                        List.of("readelf", "-dW", library.toString()),
                        working,
                        working,
                        ProcessLimits.TOOL)
                    .reading(List.of(library)),
                compilation.atMost());
    Optional<String> soname = soname(end.output());
    if (soname.isPresent() && !soname.get().equals(library.getFileName().toString())) {
      Files.copy(library, folder.resolve(soname.get()), StandardCopyOption.REPLACE_EXISTING);
    }
    return copy;
  }

  /** The SONAME in what readelf printed, if it is a plain file name. */
  static Optional<String> soname(String printed) {
    Matcher soname = SONAME.matcher(printed);
    return soname.find() ? Optional.of(soname.group(1)) : Optional.empty();
  }

  private static SourceDiagnostic inProfile(String message) {
    return SourceDiagnostic.ofFile("activity/activity.yaml", message);
  }
}
