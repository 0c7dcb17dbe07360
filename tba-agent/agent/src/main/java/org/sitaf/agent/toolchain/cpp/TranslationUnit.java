package org.sitaf.agent.toolchain.cpp;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.ToolResult;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.cpp.inputs.DependencyFile;
import org.sitaf.agent.toolchain.cpp.inputs.InputCheck;
import org.sitaf.agent.toolchain.cpp.inputs.Inputs;
import org.sitaf.core.activity.ActivityProfile;
import org.sitaf.core.activity.ActivityProfile.Sanitizer;
import org.sitaf.core.activity.CppBuild;
import org.sitaf.core.harness.TestApplication;

/**
 * A translation unit and its compiler command.
 *
 * @param name base name of its output files
 * @param command without the output options
 * @param measured whether it is instrumented for coverage
 * @param key digest of the command and the source, but not of included files
 * @param outputOptions options for the output files, including the dependency files
 * @param assemblerListsInputs whether the assembler writes a dependency file
 */
record TranslationUnit(
    CppSources.Unit source,
    String name,
    List<String> command,
    boolean measured,
    String key,
    List<String> outputOptions,
    boolean assemblerListsInputs) {
  static final String OBJECT = ".o";

  /** What the compiler printed. */
  static final String WARNINGS = ".warnings";

  /** Coverage notes. */
  static final String NOTES = ".gcno";

  private static final String INCLUDED = ".d";
  private static final String ASSEMBLED = ".as.d";
  private static final String RULE = "unit";

  TranslationUnit {
    command = List.copyOf(command);
    outputOptions = List.copyOf(outputOptions);
  }

  static TranslationUnit of(
      CppSources.Unit source,
      int number,
      Compiler compiler,
      CppRuntime.Built runtime,
      List<Path> folders,
      CppLibraries libraries,
      Compilation compilation,
      boolean measured)
      throws IOException {
    List<String> command = new ArrayList<>(List.of(compiler.program().toString()));
    ActivityProfile profile = compilation.application().activity().profile();
    CppBuild build = profile.component().cpp();
    int standard =
        libraries.standard(source.ofHarness() ? build.standardOfHarness() : build.standard());
    command.addAll(Compiler.options(standard));
    command.add(source.ofHarness() ? Compiler.WITHOUT_WARNINGS : Compiler.WITH_WARNINGS);
    Set<Sanitizer> sanitizers = profile.sanitizers();
    command.addAll(Compiler.sanitizing(sanitizers));
    command.addAll(compiler.plainDiagnostics());
    command.add("-ffile-prefix-map=" + compilation.sources() + "/=");
    if (measured) {
      command.add("--coverage");
    }
    if (source.ofHarness()) {
      if (sanitizers.isEmpty()
          && !compilation.debugging()
          && standard == CppBuild.DEFAULT_STANDARD) {
        // It is compiled with the default options, and used only if it is included first.
        command.addAll(List.of("-I", runtime.precompiled().toString()));
      }
      command.addAll(List.of("-include", CppRuntime.PRECOMPILED));
    }
    if (!source.ofHarness()) {
      command.addAll(build.flags());
    }
    if (compilation.debugging()) {
      command.addAll(Compiler.DEBUGGING);
    }
    build.defines().forEach(define -> command.add("-D" + define));
    for (Path folder : folders) {
      command.addAll(List.of("-I", folder.toString()));
    }
    command.addAll(List.of("-I", runtime.include().toString()));
    command.addAll(libraries.compileFlags());
    Digest digest = new Digest();
    // Object files do not depend on the location of the application.
    command.forEach(word -> digest.add(word.replace(compilation.sources().toString(), "")));
    digest.add(compiler.identity());
    digest.add(runtime.library().toString());
    digest.add(source.path());
    digest.add(measured ? Integer.toString(number) : "");
    digest.add(content(source, compilation));
    command.addAll(List.of("-c", source.file().toString()));
    String name = "unit" + number;
    List<String> outputOptions =
        new ArrayList<>(
            List.of("-ffile-prefix-map=@=.", "-MD", "-MT", RULE, "-MF", name + INCLUDED));
    if (compiler.hasAssembler()) {
      outputOptions.add("-Wa,--MD," + name + ASSEMBLED);
    }
    outputOptions.addAll(List.of("-o", name + OBJECT));
    return new TranslationUnit(
        source,
        name,
        command,
        measured,
        digest.hexadecimal(),
        outputOptions,
        compiler.hasAssembler());
  }

  private static byte[] content(CppSources.Unit source, Compilation compilation) {
    String path = source.path().substring(source.path().indexOf('/') + 1);
    TestApplication application = compilation.application();
    return (source.ofHarness() ? application.harness() : application.activity().files())
        .content(path)
        .orElseThrow();
  }

  /**
   * Result of the compilation of a unit.
   *
   * @param startMillis start time in milliseconds since 1970
   * @param included files that the compiler opened; null if unknown
   * @param assembled files that the assembler opened; null if unknown
   */
  record Compiled(
      ToolResult end,
      long startMillis,
      @Nullable List<String> included,
      @Nullable List<String> assembled) {
    /** Without files that are not inputs of their own, because SITAF knows how they are made. */
    Compiled without(Predicate<String> file) {
      return included == null
          ? this
          : new Compiled(
              end, startMillis, included.stream().filter(file.negate()).toList(), assembled);
    }
  }

  /**
   * Compiles the unit.
   *
   * @param files destinations of the output files, by kind
   */
  Compiled compile(ConfinedTools tools, Map<String, Path> files)
      throws IOException, InterruptedException {
    long startMillis = System.currentTimeMillis();
    ConfinedTools.Run run = tools.run(command, outputOptions);
    if (!run.succeeded()) {
      return new Compiled(run.end(), startMillis, null, null);
    }
    List<String> included = dependencies(run, INCLUDED, RULE);
    List<String> assembled =
        assemblerListsInputs ? dependencies(run, ASSEMBLED, name + OBJECT) : List.of();
    List<String> opened = assembled == null ? null : openedByAssembler(assembled, run.folder());
    for (Map.Entry<String, Path> file : files.entrySet()) {
      if (file.getKey().equals(WARNINGS)) {
        Files.writeString(file.getValue(), run.end().errors());
      } else {
        run.move(name + file.getKey(), file.getValue());
      }
    }
    return new Compiled(run.end(), startMillis, included, opened);
  }

  private @Nullable List<String> dependencies(ConfinedTools.Run run, String kind, String rule)
      throws IOException {
    return run.text(name + kind).flatMap(text -> DependencyFile.rule(rule, text)).orElse(null);
  }

  /**
   * Drops the compiler's temporary output and names that come from line directives or debug
   * information; null if the assembler opened a file of the working folder.
   */
  private static @Nullable List<String> openedByAssembler(List<String> noted, Path working) {
    List<String> opened = new ArrayList<>();
    for (String printed : noted) {
      boolean inFolder = !printed.startsWith("/") || printed.startsWith(working + "/");
      if (!inFolder) {
        opened.add(printed);
      } else if (Files.exists(working.resolve(printed), LinkOption.NOFOLLOW_LINKS)) {
        return null;
      }
    }
    return opened;
  }

  /**
   * The inputs of the result; empty if they are uncertain, so that the result must not be cached.
   */
  Optional<Inputs> inputs(Compiled compiled, InputCheck check) {
    List<String> included = compiled.included();
    List<String> assembled = compiled.assembled();
    return included == null || assembled == null
        ? Optional.empty()
        : check.of(included, assembled, assemblerListsInputs, compiled.startMillis());
  }
}
