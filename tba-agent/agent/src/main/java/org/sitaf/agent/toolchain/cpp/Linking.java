package org.sitaf.agent.toolchain.cpp;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.ToolResult;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.cpp.inputs.DependencyFile;
import org.sitaf.agent.toolchain.cpp.inputs.InputCheck;
import org.sitaf.agent.toolchain.cpp.inputs.Inputs;

/** Links the program and records which files of this machine the linker read. */
final class Linking {
  /** File in the output folder; without it, the program is used for one build only. */
  private static final String INPUTS = "inputs";

  private static final String OPENED = "linked.d";

  /** Part of the toolchain's identity: programs that were linked otherwise are not used again. */
  static final String LIBRARIES_BY_NAME = "-l:NAME";

  /** An option of the compiler that also adds a library. */
  private static final String OPENMP = "-fopenmp";

  private final Compilation compilation;
  private final Compiler compiler;
  private final CppRuntime.Built runtime;
  private final CppLibraries libraries;
  private final ConfinedTools tools;
  private long startMillis;
  private @Nullable List<String> opened;

  Linking(
      Compilation compilation,
      Compiler compiler,
      CppRuntime.Built runtime,
      CppLibraries libraries,
      ConfinedTools tools) {
    this.compilation = compilation;
    this.compiler = compiler;
    this.runtime = runtime;
    this.libraries = libraries;
    this.tools = tools;
  }

  ToolResult link(List<Path> objects, boolean measured) throws IOException, InterruptedException {
    List<String> command =
        new ArrayList<>(List.of(compiler.program().toString(), "-pthread", "-rdynamic"));
    command.addAll(
        Compiler.sanitizing(compilation.application().activity().profile().sanitizers()));
    if (measured) {
      command.add("--coverage");
    }
    objects.forEach(object -> command.add(object.toString()));
    command.addAll(List.of("-L" + runtime.library(), "-lsitaf_runtime"));
    command.addAll(libraries.linkFlags());
    if (compilation.application().activity().profile().component().cpp().flags().contains(OPENMP)) {
      command.add(OPENMP);
    }
    // The component's libraries are next to the program, wherever it is moved.
    Path ownLibraries = compilation.output().resolve(CppApplication.LIBRARIES);
    command.addAll(
        List.of(
            "-Wl,-rpath,$ORIGIN/" + CppApplication.LIBRARIES,
            "-Wl,-rpath-link," + runtime.library() + ":" + ownLibraries));
    String program = compilation.application().entryPoint();
    startMillis = System.currentTimeMillis();
    ConfinedTools.Run run =
        tools.run(command, List.of("-Wl,--dependency-file=" + OPENED, "-o", program));
    if (run.succeeded()) {
      opened = run.text(OPENED).flatMap(DependencyFile::ofLinker).orElse(null);
      run.move(program, compilation.output().resolve(program));
    }
    return run.end();
  }

  /** Records the inputs of the program, if they are certain. */
  void note(List<Inputs> units) throws IOException {
    List<String> all = opened;
    if (all == null) {
      return;
    }
    // The other files belong to the application or are covered by the toolchain's identity.
    List<String> ofMachine =
        all.stream()
            .filter(path -> applicationFolders().noneMatch(path::startsWith))
            .filter(path -> !libraries.isBuilt(path))
            .toList();
    Optional<Inputs> inputs =
        InputCheck.ofLinker(ofMachine, compiler.libraryFolders(), startMillis);
    if (inputs.isEmpty()) {
      return;
    }
    Inputs whole = inputs.get();
    for (Inputs unit : units) {
      whole = whole.ofMachineWith(unit);
    }
    try (DataOutputStream out =
        new DataOutputStream(
            new java.io.BufferedOutputStream(
                Files.newOutputStream(compilation.output().resolve(INPUTS))))) {
      out.writeUTF(packageFlags(compilation));
      whole.write(out);
    }
  }

  private Stream<String> applicationFolders() {
    return Stream.of(
            compilation.scratch().resolve("objects"),
            compilation.output().resolve(CppApplication.LIBRARIES),
            compilation.sources(),
            runtime.library())
        .map(folder -> folder + "/");
  }

  /** Whether a program in a folder equals the result of linking now. */
  static boolean isCurrent(Compilation compilation, Path folder) throws IOException {
    try (DataInputStream in =
        new DataInputStream(
            new java.io.BufferedInputStream(Files.newInputStream(folder.resolve(INPUTS))))) {
      return in.readUTF().equals(packageFlags(compilation))
          && InputCheck.isCurrentOnMachine(Inputs.read(in));
    } catch (NoSuchFileException | java.io.EOFException e) {
      return false;
    }
  }

  private static String packageFlags(Compilation compilation) {
    return CppLibraries.packageFlags(compilation.application().activity().profile());
  }
}
