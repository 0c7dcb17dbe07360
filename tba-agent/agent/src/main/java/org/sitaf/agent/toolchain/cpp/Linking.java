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
import org.sitaf.agent.sandbox.ToolEnd;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.cpp.inputs.DependencyFile;
import org.sitaf.agent.toolchain.cpp.inputs.InputCheck;
import org.sitaf.agent.toolchain.cpp.inputs.Inputs;

/** Makes the program of objects and libraries, and notes what of this machine went into it. */
final class Linking {
  /** In the folder of what is compiled; without it, the program counts for one build alone. */
  private static final String INPUTS = "inputs";

  private static final String OPENED = "linked.d";

  private final Compilation compilation;
  private final Compiler compiler;
  private final CppRuntime.Built runtime;
  private final CppLibraries libraries;
  private final ConfinedTools tools;
  private long begunMillis;
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

  ToolEnd link(List<Path> objects, boolean measured) throws IOException, InterruptedException {
    List<String> command =
        new ArrayList<>(List.of(compiler.program().toString(), "-pthread", "-rdynamic"));
    if (measured) {
      command.add("--coverage");
    }
    objects.forEach(object -> command.add(object.toString()));
    command.addAll(List.of("-L" + runtime.library(), "-lsitaf_runtime"));
    command.addAll(libraries.linkFlags());
    // What the component brings lies next to the program, wherever that is.
    Path brought = compilation.output().resolve(CppApplication.LIBRARIES);
    command.addAll(
        List.of(
            "-Wl,-rpath,$ORIGIN/" + CppApplication.LIBRARIES,
            "-Wl,-rpath-link," + runtime.library() + ":" + brought));
    String program = compilation.application().entryPoint();
    begunMillis = System.currentTimeMillis();
    ConfinedTools.Run run =
        tools.run(command, List.of("-Wl,--dependency-file=" + OPENED, "-o", program));
    if (run.succeeded()) {
      opened = run.text(OPENED).flatMap(DependencyFile::ofLinker).orElse(null);
      run.move(program, compilation.output().resolve(program));
    }
    return run.end();
  }

  /** Notes what went into the program, where that is certain. */
  void note(List<Inputs> units) throws IOException {
    List<String> all = opened;
    if (all == null) {
      return;
    }
    // What is left out is of the application, or named by the toolchain.
    List<String> ofMachine =
        all.stream().filter(path -> givenFolders().noneMatch(path::startsWith)).toList();
    Optional<Inputs> inputs =
        InputCheck.ofLinker(ofMachine, compiler.libraryFolders(), begunMillis);
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

  private Stream<String> givenFolders() {
    return Stream.of(
            compilation.scratch().resolve("objects"),
            compilation.output().resolve(CppApplication.LIBRARIES),
            compilation.sources(),
            runtime.library())
        .map(folder -> folder + "/");
  }

  /** Whether a program in a folder is the one that would be made now. */
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
