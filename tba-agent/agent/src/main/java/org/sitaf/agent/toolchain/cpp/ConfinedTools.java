package org.sitaf.agent.toolchain.cpp;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sitaf.agent.sandbox.Confinement;
import org.sitaf.agent.sandbox.ProcessLimits;
import org.sitaf.agent.sandbox.ToolResult;
import org.sitaf.agent.toolchain.Compilation;

/**
 * Runs compiler and linker in the sandbox, each in its own writable folder, because the end of a
 * tool also ends other processes of its folder. The files that a tool leaves are not trusted.
 *
 * @param readable folders in addition to those of the compilation
 */
record ConfinedTools(Compilation compilation, List<Path> readable) {
  private static final long MAX_TEXT_BYTES = 8L << 20;

  ConfinedTools {
    readable = List.copyOf(readable);
  }

  /** A tool that has ended, with its working folder. */
  record Run(ToolResult end, Path folder) {
    boolean succeeded() {
      return end.code() == 0;
    }

    /** Moves an output file to its destination. */
    void move(String name, Path file) throws IOException {
      requireFile(name);
      Files.move(folder.resolve(name), file, StandardCopyOption.REPLACE_EXISTING);
    }

    /** The content of an output file; empty if it is implausibly large. */
    Optional<String> text(String name) throws IOException {
      if (requireFile(name).size() > MAX_TEXT_BYTES) {
        return Optional.empty();
      }
      return Optional.of(
          new String(Files.readAllBytes(folder.resolve(name)), StandardCharsets.UTF_8));
    }

    private BasicFileAttributes requireFile(String name) throws IOException {
      BasicFileAttributes attributes =
          Files.readAttributes(
              folder.resolve(name), BasicFileAttributes.class, LinkOption.NOFOLLOW_LINKS);
      if (!attributes.isRegularFile()) {
        throw new IOException("the compiler's output " + name + " is not a regular file");
      }
      return attributes;
    }
  }

  /**
   * Runs a tool until it ends.
   *
   * @param outputOptions options with names of output files, in which {@code @} stands for the
   *     folder
   */
  Run run(List<String> command, List<String> outputOptions)
      throws IOException, InterruptedException {
    Path working = Files.createTempDirectory(compilation.scratch(), "tool");
    List<String> whole = new ArrayList<>(command);
    outputOptions.forEach(word -> whole.add(word.replace("@", working.toString())));
    List<Path> all = new ArrayList<>(readable);
    all.addAll(
        List.of(
            compilation.sources(), compilation.output(), compilation.scratch().resolve("objects")));
    ToolResult end =
        compilation
            .sandbox()
            .run(
                Confinement.of(whole, working, working, ProcessLimits.TOOL)
                    // Defines __DATE__ and __TIME__, so that the same sources give the same
                    // program.
                    .withEnvironment(Map.of("SOURCE_DATE_EPOCH", Long.toString(CppSources.TIME)))
                    .reading(all),
                compilation.atMost());
    return new Run(end, working);
  }
}
