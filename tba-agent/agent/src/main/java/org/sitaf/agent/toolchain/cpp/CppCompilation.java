package org.sitaf.agent.toolchain.cpp;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.ToolEnd;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.agent.toolchain.cpp.inputs.InputCheck;
import org.sitaf.agent.toolchain.cpp.inputs.Inputs;

/** One compilation of a test application: translation units side by side, then the program. */
final class CppCompilation {
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent.toolchain");

  private final Compilation compilation;
  private final Compiler compiler;
  private final CppRuntime.Built runtime;
  private final ObjectCache cache;
  private final CppSources sources;
  private final CppLibraries libraries;
  private final CompilerOutput output;
  private final InputCheck check;
  private final ConfinedTools tools;
  private final Path objects;

  /** What went into the objects that are linked; one fewer for each whose inputs are uncertain. */
  private final List<Inputs> inputs = new ArrayList<>();

  CppCompilation(
      Compilation compilation, Compiler compiler, CppRuntime.Built runtime, ObjectCache cache)
      throws CompilationException, IOException, InterruptedException {
    this.compilation = compilation;
    this.compiler = compiler;
    this.runtime = runtime;
    this.cache = cache;
    this.sources = new CppSources(compilation);
    this.output = new CompilerOutput(sources::place);
    this.libraries = CppLibraries.of(compilation);
    List<Path> folders = new ArrayList<>(List.of(runtime.include()));
    folders.addAll(libraries.headerFolders());
    folders.addAll(compiler.headerFolders());
    // Their files decide what the runtime's folder is called, and that is part of each command.
    List<Path> known = List.of(runtime.include(), runtime.precompiled());
    this.check = sources.inputCheck(folders, known);
    this.tools =
        new ConfinedTools(
            compilation, List.of(runtime.include(), runtime.precompiled(), runtime.library()));
    this.objects = compilation.scratch().resolve("objects");
  }

  void run() throws CompilationException, IOException, InterruptedException {
    Files.createDirectories(objects);
    if (measures()) {
      Files.createDirectories(notes());
    }
    sources.settleTimes();
    List<TranslationUnit> all = new ArrayList<>();
    List<TranslationUnit> changed = new ArrayList<>();
    for (CppSources.Unit source : sources.units()) {
      TranslationUnit unit = unit(source, all.size());
      all.add(unit);
      Optional<ObjectCache.Entry> kept = cache.find(unit.key(), check);
      if (kept.isPresent()) {
        restore(kept.get(), unit);
      } else {
        changed.add(unit);
      }
    }
    Map<TranslationUnit, TranslationUnit.Compiled> compiled = new ConcurrentHashMap<>();
    List<ToolEnd> ends =
        Parallel.run(
            changed,
            unit -> {
              TranslationUnit.Compiled done = unit.compile(tools, files(unit));
              compiled.put(unit, done);
              return done.end();
            });
    for (ToolEnd end : ends) {
      judge(end);
    }
    // Reading what was read takes about as long as linking.
    FutureTask<Void> keeping =
        new FutureTask<>(
            () -> {
              for (TranslationUnit unit : changed) {
                keep(unit, compiled.get(unit));
              }
              cache.shrink();
              return null;
            });
    Thread thread = new Thread(keeping, "sitaf-keep-objects");
    thread.setDaemon(true);
    thread.start();
    try {
      throwIfErrors("the sources do not compile", ends);
      link(all, keeping);
    } finally {
      await(keeping);
    }
  }

  private TranslationUnit unit(CppSources.Unit source, int number) throws IOException {
    return TranslationUnit.of(
        source,
        number,
        compiler,
        runtime,
        sources.includeFolders(),
        libraries,
        compilation,
        measures() && !source.ofHarness());
  }

  private boolean measures() {
    return compilation.coverage() && compiler.isMeasuredByGcov();
  }

  private Path notes() {
    return compilation.output().resolve(CppApplication.NOTES);
  }

  /** Where the files of a unit go, by kind. */
  private Map<String, Path> files(TranslationUnit unit) {
    Map<String, Path> files = new TreeMap<>();
    files.put(TranslationUnit.OBJECT, objects.resolve(unit.name() + TranslationUnit.OBJECT));
    if (unit.measured()) {
      files.put(TranslationUnit.NOTES, notes().resolve(unit.name() + TranslationUnit.NOTES));
    }
    return files;
  }

  private void restore(ObjectCache.Entry entry, TranslationUnit unit) throws IOException {
    for (Map.Entry<String, Path> file : files(unit).entrySet()) {
      Files.write(file.getValue(), entry.files().get(file.getKey()));
    }
    LOGGER.log(System.Logger.Level.DEBUG, "{0}: kept", unit.source().path());
    inputs.add(entry.inputs());
  }

  private void keep(TranslationUnit unit, TranslationUnit.@Nullable Compiled compiled)
      throws IOException {
    if (compiled == null || compiled.end().code() != 0) {
      return;
    }
    Optional<Inputs> read = unit.inputs(compiled, check);
    LOGGER.log(
        System.Logger.Level.DEBUG,
        read.isPresent() ? "{0}: compiled" : "{0}: compiled; what it reads is not certain",
        unit.source().path());
    if (read.isPresent()) {
      cache.keep(unit.key(), read.get(), files(unit));
      inputs.add(read.get());
    }
  }

  private void link(List<TranslationUnit> units, FutureTask<Void> keeping)
      throws CompilationException, IOException, InterruptedException {
    Linking linking = new Linking(compilation, compiler, runtime, libraries, tools);
    List<Path> linked =
        units.stream().map(unit -> objects.resolve(unit.name() + TranslationUnit.OBJECT)).toList();
    ToolEnd end = linking.link(linked, measures());
    judge(end);
    throwIfErrors("the test application cannot be linked", List.of(end));
    await(keeping);
    if (inputs.size() == units.size()) {
      linking.note(inputs);
    }
  }

  private static void await(FutureTask<Void> keeping) throws IOException, InterruptedException {
    try {
      keeping.get();
    } catch (ExecutionException e) {
      throw new IOException("what was compiled cannot be kept: " + e.getCause(), e.getCause());
    }
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
