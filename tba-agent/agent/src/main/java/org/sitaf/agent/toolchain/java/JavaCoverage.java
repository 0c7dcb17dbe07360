package org.sitaf.agent.toolchain.java;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.jacoco.core.analysis.Analyzer;
import org.jacoco.core.analysis.CoverageBuilder;
import org.jacoco.core.analysis.ICounter;
import org.jacoco.core.analysis.ILine;
import org.jacoco.core.analysis.ISourceFileCoverage;
import org.jacoco.core.tools.ExecFileLoader;
import org.sitaf.core.activity.ActivityProfile.Component;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.verdict.Coverage;

/**
 * Which lines of a Java component are reached, by JaCoCo.
 *
 * @param recorder JaCoCo's agent, a jar
 * @param classes where the component's classes are
 * @param folder of the component's sources within the activity, with a slash at its end
 * @param sources what is in that folder
 */
record JavaCoverage(Path recorder, Path classes, String folder, FileTree sources) {
  private static final String DATA = "jacoco.exec";

  /** Empty where the component has no sources. */
  static Optional<JavaCoverage> of(TestApplication application, Path recorder, Path classes) {
    Component component = application.activity().profile().component();
    String folder = component.sources();
    if (folder == null) {
      return Optional.empty();
    }
    FileTree inside = application.activity().files().below(folder);
    String prefix = folder.isEmpty() || folder.endsWith("/") ? folder : folder + "/";
    return Optional.of(new JavaCoverage(recorder, classes, prefix, inside));
  }

  /** What the JVM is started with, to record into a folder. */
  String flag(Path directory) {
    return "-javaagent:"
        + recorder
        + "=destfile="
        + directory.resolve(DATA)
        + ",includes="
        + String.join(":", recorded())
        + ",jmx=false,inclnolocationclasses=false";
  }

  /** The component's packages, and its classes that are in none. */
  private TreeSet<String> recorded() {
    TreeSet<String> patterns = new TreeSet<>();
    for (String path : sources.paths()) {
      if (path.endsWith(".java")) {
        int slash = path.lastIndexOf('/');
        if (slash >= 0) {
          patterns.add(path.substring(0, slash).replace('/', '.') + ".*");
        } else {
          String name = path.substring(0, path.length() - ".java".length());
          patterns.add(name);
          patterns.add(name + "$*");
        }
      }
    }
    return patterns;
  }

  /**
   * Reads what processes have recorded.
   *
   * @param data holds a folder a process
   */
  Coverage read(Path data) throws IOException {
    ExecFileLoader loader = new ExecFileLoader();
    try (Stream<Path> files = Files.walk(data)) {
      for (Path file : files.filter(path -> path.endsWith(DATA)).sorted().toList()) {
        try {
          loader.load(file.toFile());
        } catch (IOException e) {
          // A process that was killed may leave half a record behind; what others saw still counts.
        }
      }
    }
    CoverageBuilder builder = new CoverageBuilder();
    Analyzer analyzer = new Analyzer(loader.getExecutionDataStore(), builder);
    try (Stream<Path> files = Files.walk(classes)) {
      for (Path file : files.filter(path -> path.toString().endsWith(".class")).sorted().toList()) {
        String path = classes.relativize(file).toString();
        if (recorded().stream().anyMatch(pattern -> matches(pattern, path))) {
          analyzer.analyzeClass(Files.readAllBytes(file), path);
        }
      }
    }
    TreeMap<String, Coverage.File> found = new TreeMap<>();
    for (ISourceFileCoverage source : builder.getSourceFiles()) {
      String path =
          source.getPackageName().isEmpty()
              ? source.getName()
              : source.getPackageName() + "/" + source.getName();
      if (sources.contains(path) && source.containsCode()) {
        found.put(path, new Coverage.File(folder + path, lines(source)));
      }
    }
    return new Coverage(List.copyOf(found.values()));
  }

  private static boolean matches(String pattern, String classFile) {
    String name = classFile.substring(0, classFile.length() - ".class".length()).replace('/', '.');
    return pattern.endsWith("*")
        ? name.startsWith(pattern.substring(0, pattern.length() - 1))
        : name.equals(pattern);
  }

  private static List<Coverage.Line> lines(ISourceFileCoverage source) {
    List<Coverage.Line> lines = new ArrayList<>();
    for (int number = source.getFirstLine(); number <= source.getLastLine(); number++) {
      ILine line = source.getLine(number);
      if (line.getStatus() != ICounter.EMPTY) {
        lines.add(
            new Coverage.Line(
                number,
                line.getInstructionCounter().getCoveredCount() > 0,
                line.getBranchCounter().getTotalCount(),
                line.getBranchCounter().getCoveredCount()));
      }
    }
    return lines;
  }
}
