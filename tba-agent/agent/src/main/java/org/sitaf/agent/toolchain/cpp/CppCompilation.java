package org.sitaf.agent.toolchain.cpp;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.sitaf.agent.sandbox.Confinement;
import org.sitaf.agent.sandbox.ProcessLimits;
import org.sitaf.agent.sandbox.ToolEnd;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.SourceDiagnostic;

/** One compilation of a test application: translation units side by side, then the program. */
final class CppCompilation {
  private final Compilation compilation;
  private final Compiler compiler;
  private final CppRuntime.Built runtime;
  private final ObjectCache cache;
  private final CppSources sources;
  private final CompilerOutput output;

  CppCompilation(
      Compilation compilation, Compiler compiler, CppRuntime.Built runtime, ObjectCache cache) {
    this.compilation = compilation;
    this.compiler = compiler;
    this.runtime = runtime;
    this.cache = cache;
    this.sources = new CppSources(compilation);
    this.output = new CompilerOutput(sources::place);
  }

  /**
   * A translation unit on its way.
   *
   * @param command without what it writes
   * @param number names its files
   */
  private record Work(List<String> command, int number, boolean measured, String digest) {
    String object() {
      return "unit" + number + ".o";
    }

    /** What gcov needs of the compilation. */
    String notes() {
      return "unit" + number + ".gcno";
    }
  }

  void run() throws CompilationException, IOException, InterruptedException {
    CppLibraries libraries = CppLibraries.of(compilation);
    Path objects = Files.createDirectories(compilation.scratch().resolve("objects"));
    Path notes = compilation.output().resolve(CppApplication.NOTES);
    if (measures()) {
      Files.createDirectories(notes);
    }
    List<String> link =
        new ArrayList<>(List.of(compiler.program().toString(), "-pthread", "-rdynamic"));
    if (measures()) {
      link.add("--coverage");
    }
    List<Work> works = new ArrayList<>();
    Digest common = new Digest();
    sources.addHeadersTo(common);
    String headers = common.hexadecimal();
    int count = 0;
    for (CppSources.Unit unit : sources.units()) {
      Work work = work(unit, count++, libraries, headers);
      boolean there = cache.fetch(work.digest(), ".o", objects.resolve(work.object()));
      if (there && work.measured()) {
        there = cache.fetch(work.digest(), ".gcno", notes.resolve(work.notes()));
      }
      if (!there) {
        works.add(work);
      }
      link.add(objects.resolve(work.object()).toString());
    }
    List<ToolEnd> ends = Parallel.run(works, work -> compile(work, objects, notes));
    for (int i = 0; i < works.size(); i++) {
      judge(ends.get(i));
      Work work = works.get(i);
      if (ends.get(i).code() == 0) {
        cache.keep(work.digest(), ".o", objects.resolve(work.object()));
        if (work.measured()) {
          cache.keep(work.digest(), ".gcno", notes.resolve(work.notes()));
        }
      }
    }
    throwIfErrors("the sources do not compile", ends);
    link.addAll(List.of("-L" + runtime.library(), "-lsitaf_runtime"));
    link.addAll(libraries.linkFlags());
    // What the component brings lies beside the program, wherever that is.
    Path brought = compilation.output().resolve(CppApplication.LIBRARIES);
    link.addAll(
        List.of(
            "-Wl,-rpath,$ORIGIN/" + CppApplication.LIBRARIES,
            "-Wl,-rpath-link," + runtime.library() + ":" + brought));
    String program = compilation.application().entryPoint();
    ToolEnd end = tool(link, program, Map.of(program, compilation.output().resolve(program)));
    judge(end);
    throwIfErrors("the test application cannot be linked", List.of(end));
  }

  private boolean measures() {
    return compilation.coverage() && compiler.isMeasuredByGcov();
  }

  private ToolEnd compile(Work work, Path objects, Path notes)
      throws IOException, InterruptedException {
    Map<String, Path> results = new HashMap<>();
    results.put(work.object(), objects.resolve(work.object()));
    if (work.measured()) {
      results.put(work.notes(), notes.resolve(work.notes()));
    }
    return tool(work.command(), work.object(), results);
  }

  private Work work(CppSources.Unit unit, int number, CppLibraries libraries, String headers) {
    List<String> command = new ArrayList<>(List.of(compiler.program().toString()));
    command.addAll(Compiler.OPTIONS);
    command.addAll(compiler.plainDiagnostics());
    command.add("-ffile-prefix-map=" + compilation.sources() + "/=");
    boolean measured = measures() && !unit.ofHarness();
    if (measured) {
      command.add("--coverage");
    }
    if (unit.ofHarness()) {
      // The precompiled header counts only where it is the first.
      command.addAll(List.of("-I", runtime.precompiled().toString()));
      command.addAll(List.of("-include", CppRuntime.PRECOMPILED));
    }
    for (Path folder : sources.includeFolders()) {
      command.addAll(List.of("-I", folder.toString()));
    }
    command.addAll(List.of("-I", runtime.include().toString()));
    command.addAll(libraries.compileFlags());
    Digest digest = new Digest();
    // Where the application lies does not matter to an object file.
    command.forEach(word -> digest.add(word.replace(compilation.sources().toString(), "")));
    digest.add(compiler.version());
    digest.add(runtime.library().toString());
    digest.add(headers);
    digest.add(unit.path());
    digest.add(measured ? Integer.toString(number) : "");
    digest.add(content(unit));
    command.addAll(List.of("-c", unit.file().toString()));
    return new Work(command, number, measured, digest.hexadecimal());
  }

  private byte[] content(CppSources.Unit unit) {
    return compilation.application().files().content(unit.path()).orElseThrow();
  }

  /**
   * Runs a tool in a folder of its own, since all that works in the folder ends with it, and only
   * that folder is the tool's to write.
   *
   * @param written what it writes, by {@code -o}
   * @param results files of that folder and where they go
   */
  private ToolEnd tool(List<String> command, String written, Map<String, Path> results)
      throws IOException, InterruptedException {
    Path working = Files.createTempDirectory(compilation.scratch(), "tool");
    List<String> whole = new ArrayList<>(command);
    whole.addAll(List.of("-o", working.resolve(written).toString()));
    ToolEnd end =
        compilation
            .sandbox()
            .run(
                Confinement.of(whole, working, working, ProcessLimits.TOOL)
                    .reading(
                        List.of(
                            compilation.sources(),
                            compilation.output(),
                            compilation.scratch().resolve("objects"),
                            runtime.include(),
                            runtime.precompiled(),
                            runtime.library())),
                compilation.atMost());
    if (end.code() == 0) {
      for (Map.Entry<String, Path> result : results.entrySet()) {
        Files.move(
            working.resolve(result.getKey()),
            result.getValue(),
            StandardCopyOption.REPLACE_EXISTING);
      }
    }
    return end;
  }

  private void judge(ToolEnd end) throws CompilationException {
    if (end.gaveUp()) {
      throw new CompilationException(
          "the compilation was given up after " + compilation.atMost().toSeconds() + " s",
          List.of());
    }
    if (end.code() != 0) {
      output.read(end.errors());
    }
  }

  private void throwIfErrors(String what, List<ToolEnd> ends) throws CompilationException {
    if (ends.stream().allMatch(end -> end.code() == 0)) {
      return;
    }
    List<SourceDiagnostic> errors = output.errors();
    if (errors.isEmpty()) {
      String said =
          ends.stream()
              .filter(end -> end.code() != 0)
              .map(end -> end.errors().strip())
              .filter(text -> !text.isEmpty())
              .findFirst()
              .orElse("the compiler ended without a word");
      throw new CompilationException(what + ": " + said, List.of());
    }
    boolean allGenerated = errors.stream().allMatch(SourceDiagnostic::generated);
    String number = errors.size() == 1 ? "1 error" : errors.size() + " errors";
    throw new CompilationException(
        (allGenerated ? "the component does not fit the generated test application" : what)
            + ": "
            + number
            + "; "
            + errors.get(0),
        errors);
  }
}
