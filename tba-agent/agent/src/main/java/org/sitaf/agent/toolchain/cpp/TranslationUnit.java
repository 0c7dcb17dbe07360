package org.sitaf.agent.toolchain.cpp;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.ToolEnd;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.cpp.inputs.DependencyFile;
import org.sitaf.agent.toolchain.cpp.inputs.InputCheck;
import org.sitaf.agent.toolchain.cpp.inputs.Inputs;
import org.sitaf.core.harness.TestApplication;

/**
 * A translation unit and how it is compiled.
 *
 * @param name of its files
 * @param command without what it writes
 * @param measured whether it is to record which lines are reached
 * @param key stands for the command and the source itself, but not for what that includes
 * @param noting options that let compiler and assembler note what they open
 * @param assemblyNoted whether the assembler does
 */
record TranslationUnit(
    CppSources.Unit source,
    String name,
    List<String> command,
    boolean measured,
    String key,
    List<String> noting,
    boolean assemblyNoted) {
  static final String OBJECT = ".o";

  /** What gcov needs of the compilation. */
  static final String NOTES = ".gcno";

  private static final String INCLUDED = ".d";
  private static final String ASSEMBLED = ".as.d";
  private static final String RULE = "unit";

  TranslationUnit {
    command = List.copyOf(command);
    noting = List.copyOf(noting);
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
    command.addAll(Compiler.OPTIONS);
    command.addAll(compiler.plainDiagnostics());
    command.add("-ffile-prefix-map=" + compilation.sources() + "/=");
    if (measured) {
      command.add("--coverage");
    }
    if (source.ofHarness()) {
      // The precompiled header counts only where it is the first.
      command.addAll(List.of("-I", runtime.precompiled().toString()));
      command.addAll(List.of("-include", CppRuntime.PRECOMPILED));
    }
    for (Path folder : folders) {
      command.addAll(List.of("-I", folder.toString()));
    }
    command.addAll(List.of("-I", runtime.include().toString()));
    command.addAll(libraries.compileFlags());
    Digest digest = new Digest();
    // Where the application lies does not matter to an object file.
    command.forEach(word -> digest.add(word.replace(compilation.sources().toString(), "")));
    digest.add(compiler.identity());
    digest.add(runtime.library().toString());
    digest.add(source.path());
    digest.add(measured ? Integer.toString(number) : "");
    digest.add(content(source, compilation));
    command.addAll(List.of("-c", source.file().toString()));
    String name = "unit" + number;
    List<String> noting =
        new ArrayList<>(
            List.of("-ffile-prefix-map=@=.", "-MD", "-MT", RULE, "-MF", name + INCLUDED));
    if (compiler.hasAssembler()) {
      noting.add("-Wa,--MD," + name + ASSEMBLED);
    }
    noting.addAll(List.of("-o", name + OBJECT));
    return new TranslationUnit(
        source, name, command, measured, digest.hexadecimal(), noting, compiler.hasAssembler());
  }

  private static byte[] content(CppSources.Unit source, Compilation compilation) {
    String path = source.path().substring(source.path().indexOf('/') + 1);
    TestApplication application = compilation.application();
    return (source.ofHarness() ? application.harness() : application.activity().files())
        .content(path)
        .orElseThrow();
  }

  /**
   * How the compilation of a unit went.
   *
   * @param begunMillis when it was started, in milliseconds since 1970
   * @param included what the compiler noted; null where it is not understood
   * @param assembled what the assembler noted; null where it is not understood
   */
  record Compiled(
      ToolEnd end,
      long begunMillis,
      @Nullable List<String> included,
      @Nullable List<String> assembled) {}

  /**
   * Compiles it.
   *
   * @param files where what is compiled goes, by kind
   */
  Compiled compile(ConfinedTools tools, Map<String, Path> files)
      throws IOException, InterruptedException {
    long begunMillis = System.currentTimeMillis();
    ConfinedTools.Run run = tools.run(command, noting);
    if (!run.succeeded()) {
      return new Compiled(run.end(), begunMillis, null, null);
    }
    List<String> included = noted(run, INCLUDED, RULE);
    List<String> assembled = assemblyNoted ? noted(run, ASSEMBLED, name + OBJECT) : List.of();
    List<String> opened = assembled == null ? null : openedByAssembler(assembled, run.folder());
    for (Map.Entry<String, Path> file : files.entrySet()) {
      run.move(name + file.getKey(), file.getValue());
    }
    return new Compiled(run.end(), begunMillis, included, opened);
  }

  private @Nullable List<String> noted(ConfinedTools.Run run, String kind, String rule)
      throws IOException {
    return run.text(name + kind).flatMap(text -> DependencyFile.rule(rule, text)).orElse(null);
  }

  /**
   * Leaves out what the compiler hands to the assembler, and names that line directives and debug
   * information invent; null where something of the working folder was opened.
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

  /** What went into it; empty where that is not certain, so that it must not be kept. */
  Optional<Inputs> inputs(Compiled compiled, InputCheck check) {
    List<String> included = compiled.included();
    List<String> assembled = compiled.assembled();
    return included == null || assembled == null
        ? Optional.empty()
        : check.of(included, assembled, assemblyNoted, compiled.begunMillis());
  }
}
