package org.sitaf.agent.toolchain.java;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jacoco.core.analysis.Analyzer;
import org.jacoco.core.analysis.CoverageBuilder;
import org.jacoco.core.analysis.ICounter;
import org.jacoco.core.analysis.ILine;
import org.jacoco.core.analysis.ISourceFileCoverage;
import org.sitaf.agent.spool.LeftFiles;
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
  private static final String CLASS = ".class";
  private static final int MOST_FILES = 20_000;
  private static final int MOST_BYTES = 32 << 20;

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
    ExecutionRecord record =
        new ExecutionRecord(name -> recorded().stream().anyMatch(p -> matches(p, name)));
    for (Path file : LeftFiles.in(data, path -> path.endsWith(DATA), MOST_FILES)) {
      record.add(LeftFiles.read(file, MOST_BYTES));
    }
    CoverageBuilder builder = new CoverageBuilder();
    Analyzer analyzer = new Analyzer(record.store(), builder);
    for (Path file : LeftFiles.in(classes, path -> path.toString().endsWith(CLASS), MOST_FILES)) {
      String path = classes.relativize(file).toString();
      String name = path.substring(0, path.length() - CLASS.length());
      if (recorded().stream().anyMatch(pattern -> matches(pattern, name))) {
        analyzer.analyzeClass(LeftFiles.read(file, MOST_BYTES), path);
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

  /** The name of a class is that of its file, without the suffix. */
  private static boolean matches(String pattern, String path) {
    String name = path.replace('/', '.');
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
