package org.sitaf.agent.toolchain.java.confined;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.jacoco.core.analysis.Analyzer;
import org.jacoco.core.analysis.CoverageBuilder;
import org.jacoco.core.analysis.ICounter;
import org.jacoco.core.analysis.ILine;
import org.jacoco.core.analysis.ISourceFileCoverage;
import org.jacoco.core.tools.ExecFileLoader;

/**
 * Prints JaCoCo's line coverage: a line {@code file PATH} per source, followed by a line {@code
 * NUMBER REACHED BRANCHES REACHED_BRANCHES} for each of its lines with code.
 *
 * <p>Arguments: the folder of classes and the folder of records.
 */
public final class CoverageMain {
  private static final long MAX_BYTES = 64L << 20;

  private CoverageMain() {}

  /** See the class. */
  public static void main(String[] arguments) throws IOException {
    ExecFileLoader loader = new ExecFileLoader();
    for (Path file : list(Path.of(arguments[1]))) {
      if (isReadable(file)) {
        try {
          loader.load(file.toFile());
        } catch (IOException | RuntimeException e) {
          // A killed process may leave an incomplete record; other records still count.
        }
      }
    }
    CoverageBuilder builder = new CoverageBuilder();
    Analyzer analyzer = new Analyzer(loader.getExecutionDataStore(), builder);
    List<Path> classes;
    try (Stream<Path> files = Files.walk(Path.of(arguments[0]))) {
      classes = files.filter(path -> path.toString().endsWith(".class")).sorted().toList();
    }
    for (Path file : classes) {
      if (isReadable(file)) {
        try {
          analyzer.analyzeClass(Files.readAllBytes(file), file.toString());
        } catch (IOException | RuntimeException e) {
          // The component's own file, which only has the extension of a class.
        }
      }
    }
    try (PrintStream output = new PrintStream(System.out, false, StandardCharsets.UTF_8)) {
      builder.getSourceFiles().forEach(source -> print(source, output));
    }
  }

  private static void print(ISourceFileCoverage source, PrintStream output) {
    if (!source.containsCode()) {
      return;
    }
    String folder = source.getPackageName().isEmpty() ? "" : source.getPackageName() + "/";
    output.print("file " + folder + source.getName() + "\n");
    for (int number = source.getFirstLine(); number <= source.getLastLine(); number++) {
      ILine line = source.getLine(number);
      if (line.getStatus() != ICounter.EMPTY) {
        output.print(
            number
                + " "
                + (line.getInstructionCounter().getCoveredCount() > 0 ? 1 : 0)
                + " "
                + line.getBranchCounter().getTotalCount()
                + " "
                + line.getBranchCounter().getCoveredCount()
                + "\n");
      }
    }
  }

  private static List<Path> list(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.sorted().toList();
    }
  }

  private static boolean isReadable(Path file) throws IOException {
    return Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS) && Files.size(file) <= MAX_BYTES;
  }
}
