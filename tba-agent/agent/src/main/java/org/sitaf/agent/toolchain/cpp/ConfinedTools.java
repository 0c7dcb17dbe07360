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
import org.sitaf.agent.sandbox.ToolEnd;
import org.sitaf.agent.toolchain.Compilation;

/**
 * Runs compiler and linker, each in a folder of its own, since all that works in the folder ends
 * with it, and only that folder is the tool's to write. What is in it afterwards is not trusted.
 *
 * @param readable folders beyond those of the compilation
 */
record ConfinedTools(Compilation compilation, List<Path> readable) {
  private static final long MOST_NOTED_BYTES = 8L << 20;

  ConfinedTools {
    readable = List.copyOf(readable);
  }

  /** A tool that has ended, and the folder in which it worked. */
  record Run(ToolEnd end, Path folder) {
    boolean succeeded() {
      return end.code() == 0;
    }

    /** Moves a file to where it is used from now on. */
    void move(String name, Path file) throws IOException {
      requireFile(name);
      Files.move(folder.resolve(name), file, StandardCopyOption.REPLACE_EXISTING);
    }

    /** What the tool has noted in a file; empty where it is too much to be true. */
    Optional<String> text(String name) throws IOException {
      if (requireFile(name).size() > MOST_NOTED_BYTES) {
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
        throw new IOException("a compiler left something else than a file as " + name);
      }
      return attributes;
    }
  }

  /**
   * Runs a tool to its end.
   *
   * @param noting options that name files in the folder, in which it stands as {@code @}
   */
  Run run(List<String> command, List<String> noting) throws IOException, InterruptedException {
    Path working = Files.createTempDirectory(compilation.scratch(), "tool");
    List<String> whole = new ArrayList<>(command);
    noting.forEach(word -> whole.add(word.replace("@", working.toString())));
    List<Path> all = new ArrayList<>(readable);
    all.addAll(
        List.of(
            compilation.sources(), compilation.output(), compilation.scratch().resolve("objects")));
    ToolEnd end =
        compilation
            .sandbox()
            .run(
                Confinement.of(whole, working, working, ProcessLimits.TOOL)
                    // For __DATE__ and __TIME__: the same sources give the same program.
                    .withEnvironment(Map.of("SOURCE_DATE_EPOCH", Long.toString(CppSources.TIME)))
                    .reading(all),
                compilation.atMost());
    return new Run(end, working);
  }
}
