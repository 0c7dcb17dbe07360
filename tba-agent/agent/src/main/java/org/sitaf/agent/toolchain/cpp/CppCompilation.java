package org.sitaf.agent.toolchain.cpp;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.ToolResult;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.agent.toolchain.cpp.cmake.CmakeProject;
import org.sitaf.agent.toolchain.cpp.cmake.LinkedTarget;
import org.sitaf.agent.toolchain.cpp.inputs.InputCheck;
import org.sitaf.agent.toolchain.cpp.inputs.Inputs;
import org.sitaf.core.activity.ActivityProfile;

/** Compiles the translation units of a test application in parallel and links the program. */
final class CppCompilation {
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent.toolchain");

  private static final String NOT_LINKED = "the test application cannot be linked";

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

  /** Inputs of the linked objects; incomplete if the inputs of an object are uncertain. */
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
    this.libraries = CppLibraries.of(compilation, cmake().orElse(null));
    List<Path> folders = new ArrayList<>(List.of(runtime.include()));
    folders.addAll(libraries.headerFolders());
    folders.addAll(compiler.headerFolders());
    // Their content determines the name of the runtime's folder, which is part of each command.
    List<Path> known = List.of(runtime.include(), runtime.precompiled());
    this.check = sources.inputCheck(folders, known);
    List<Path> readable =
        new ArrayList<>(List.of(runtime.include(), runtime.precompiled(), runtime.library()));
    LinkedTarget target = libraries.cmake();
    if (target != null) {
      readable.add(target.folder());
    }
    this.tools = new ConfinedTools(compilation, readable);
    this.objects = compilation.scratch().resolve("objects");
  }

  /** Builds the component's CMake project, if it is one. */
  private Optional<LinkedTarget> cmake()
      throws CompilationException, IOException, InterruptedException {
    ActivityProfile profile = compilation.application().activity().profile();
    if (profile.component().cpp().cmake() == null) {
      return Optional.empty();
    }
    sources.setTimes();
    List<String> common = new ArrayList<>(Compiler.sanitizing(profile.sanitizers()));
    common.add("-ffile-prefix-map=" + compilation.sources() + "/=");
    List<String> ofCpp = new ArrayList<>(List.of("-pthread", Compiler.WITH_WARNINGS));
    ofCpp.addAll(common);
    ofCpp.addAll(compiler.plainDiagnostics());
    try {
      return Optional.of(new CmakeProject(compilation, compiler.program(), ofCpp, common).build());
    } catch (CmakeProject.BuildFailedException e) {
      output.read(e.errors());
      requireSuccess(
          String.valueOf(e.getMessage()),
          NOT_LINKED,
          "",
          List.of(new ToolResult(1, "", e.errors())));
      throw new IllegalStateException(e);
    }
  }

  void run() throws CompilationException, IOException, InterruptedException {
    Files.createDirectories(objects);
    if (coverageEnabled()) {
      Files.createDirectories(notes());
    }
    sources.setTimes();
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
    List<ToolResult> ends =
        Parallel.run(
            changed,
            unit -> {
              TranslationUnit.Compiled done = unit.compile(tools, files(unit));
              compiled.put(unit, done);
              return done.end();
            });
    for (ToolResult end : ends) {
      collectErrors(end);
    }
    // Computing digests of all inputs takes about as long as linking, so do both in parallel.
    FutureTask<Void> cacheTask =
        new FutureTask<>(
            () -> {
              for (TranslationUnit unit : changed) {
                addToCache(unit, compiled.get(unit));
              }
              cache.shrink();
              return null;
            });
    Thread thread = new Thread(cacheTask, "sitaf-object-cache");
    thread.setDaemon(true);
    thread.start();
    try {
      requireSuccess("the sources do not compile", CompilationException.MISFIT, "", ends);
      writeWarnings(all);
      link(all, cacheTask);
    } finally {
      await(cacheTask);
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
        coverageEnabled() && !source.ofHarness());
  }

  private boolean coverageEnabled() {
    return compilation.coverage() && compiler.isMeasuredByGcov();
  }

  private Path notes() {
    return compilation.output().resolve(CppApplication.NOTES);
  }

  /** The destinations of a unit's files, by kind. */
  private Map<String, Path> files(TranslationUnit unit) {
    Map<String, Path> files = new TreeMap<>();
    files.put(TranslationUnit.OBJECT, objects.resolve(unit.name() + TranslationUnit.OBJECT));
    if (!unit.source().ofHarness()) {
      files.put(TranslationUnit.WARNINGS, objects.resolve(unit.name() + TranslationUnit.WARNINGS));
    }
    if (unit.measured()) {
      files.put(TranslationUnit.NOTES, notes().resolve(unit.name() + TranslationUnit.NOTES));
    }
    return files;
  }

  private void restore(ObjectCache.Entry entry, TranslationUnit unit) throws IOException {
    for (Map.Entry<String, Path> file : files(unit).entrySet()) {
      Files.write(file.getValue(), entry.files().get(file.getKey()));
    }
    LOGGER.log(System.Logger.Level.DEBUG, "{0}: from cache", unit.source().path());
    inputs.add(entry.inputs());
  }

  private void addToCache(TranslationUnit unit, TranslationUnit.@Nullable Compiled compiled)
      throws IOException {
    if (compiled == null || compiled.end().code() != 0) {
      return;
    }
    Optional<Inputs> read =
        libraries.areInputsListed()
            ? unit.inputs(compiled.without(libraries::isBuilt), check)
            : Optional.empty();
    LOGGER.log(
        System.Logger.Level.DEBUG,
        read.isPresent() ? "{0}: compiled" : "{0}: compiled; its inputs are uncertain",
        unit.source().path());
    if (read.isPresent()) {
      if (libraries.compileFlags().stream().noneMatch(libraries::isBuilt)) {
        cache.keep(unit.key(), read.get(), files(unit));
      }
      inputs.add(read.get());
    }
  }

  /** Keeps the warnings with the program, for builds that take it from a cache. */
  private void writeWarnings(List<TranslationUnit> units) throws IOException {
    CompilerOutput printed = new CompilerOutput(sources::place);
    LinkedTarget target = libraries.cmake();
    if (target != null) {
      printed.readWarnings(target.warnings());
    }
    for (TranslationUnit unit : units) {
      Path file = files(unit).get(TranslationUnit.WARNINGS);
      if (file != null) {
        printed.readWarnings(Files.readString(file));
      }
    }
    Files.write(compilation.output().resolve(CppApplication.WARNINGS), printed.warnings());
  }

  private void link(List<TranslationUnit> units, FutureTask<Void> cacheTask)
      throws CompilationException, IOException, InterruptedException {
    Linking linking = new Linking(compilation, compiler, runtime, libraries, tools);
    List<Path> linked =
        units.stream().map(unit -> objects.resolve(unit.name() + TranslationUnit.OBJECT)).toList();
    ToolResult end = linking.link(linked, coverageEnabled());
    collectErrors(end);
    // An undefined reference is the component's, whichever object it is in.
    requireSuccess(NOT_LINKED, NOT_LINKED, "; linked " + libraries(), List.of(end));
    await(cacheTask);
    LinkedTarget target = libraries.cmake();
    Optional<Inputs> ofProject = target == null ? Optional.empty() : target.inputs();
    if (inputs.size() == units.size() && (target == null || ofProject.isPresent())) {
      List<Inputs> all = new ArrayList<>(inputs);
      ofProject.ifPresent(all::add);
      linking.note(all);
    }
  }

  /** What the program is linked with, to find the library that a missing symbol belongs to. */
  private String libraries() {
    ActivityProfile profile = compilation.application().activity().profile();
    List<String> given = new ArrayList<>(profile.component().cpp().packages());
    Stream.of(profile.component().packageName(), profile.component().library())
        .filter(Objects::nonNull)
        .forEach(given::add);
    given.addAll(profile.libraries());
    return given.isEmpty()
        ? "without any package or library; packages: [NAME] in component: links one that"
            + " pkg-config knows"
        : "with " + String.join(", ", given);
  }

  private static void await(FutureTask<Void> cacheTask) throws IOException, InterruptedException {
    try {
      cacheTask.get();
    } catch (ExecutionException e) {
      throw new IOException("the compiled objects cannot be cached: " + e.getCause(), e.getCause());
    }
  }

  private void collectErrors(ToolResult end) throws CompilationException {
    if (end.timedOut()) {
      throw new CompilationException(
          "the compilation did not finish within " + compilation.atMost().toSeconds() + " s",
          List.of());
    }
    if (end.code() != 0) {
      output.read(end.errors());
    }
  }

  /**
   * @param inGenerated what to report instead when all errors are in generated sources
   * @param hint follows the first error
   */
  private void requireSuccess(String what, String inGenerated, String hint, List<ToolResult> ends)
      throws CompilationException {
    if (ends.stream().allMatch(end -> end.code() == 0)) {
      return;
    }
    List<SourceDiagnostic> errors = output.errors();
    if (errors.isEmpty()) {
      String text =
          ends.stream()
              .filter(end -> end.code() != 0)
              .map(end -> end.errors().strip())
              .filter(message -> !message.isEmpty())
              .findFirst()
              .orElse("the compiler failed without a message");
      throw new CompilationException(what + ": " + text, List.of());
    }
    boolean allGenerated = errors.stream().allMatch(SourceDiagnostic::generated);
    String number = errors.size() == 1 ? "1 error" : errors.size() + " errors";
    throw new CompilationException(
        (allGenerated ? inGenerated : what) + ": " + number + "; " + errors.get(0) + hint, errors);
  }
}
