package org.sitaf.agent.toolchain.java;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.verdict.Coverage;

/**
 * Line coverage of a Java component.
 *
 * @param classes folder of the component's classes
 * @param folder folder of the component's sources in the activity, with a trailing slash
 * @param sources the files of that folder
 * @param scratch absolute folder for temporary files
 */
record JavaCoverage(
    CoverageTool tool,
    Path classes,
    String folder,
    FileTree sources,
    Path scratch,
    Sandbox sandbox) {
  private static final String DATA = "jacoco.exec";
  private static final String FILE = "file ";
  private static final Pattern LINE = Pattern.compile("(\\d{1,9}) ([01]) (\\d{1,9}) (\\d{1,9})");

  /** Empty if the component has no sources. */
  static Optional<JavaCoverage> of(Compilation compilation, CoverageTool tool) {
    String folder = compilation.application().activity().profile().component().sources();
    if (folder == null) {
      return Optional.empty();
    }
    FileTree inside = compilation.application().activity().files().below(folder);
    String prefix = folder.isEmpty() || folder.endsWith("/") ? folder : folder + "/";
    return Optional.of(
        new JavaCoverage(
            tool,
            compilation.output(),
            prefix,
            inside,
            compilation.scratch(),
            compilation.sandbox()));
  }

  /** The jar of JaCoCo's agent. */
  Path recorder() {
    return tool.recorder();
  }

  /** JVM options that record into a folder. */
  String flag(Path directory) {
    return "-javaagent:"
        + recorder()
        + "=destfile="
        + directory.resolve(DATA)
        + ",includes="
        + String.join(":", recordedClasses())
        + ",jmx=false,inclnolocationclasses=false";
  }

  /**
   * Patterns of the classes to record: the component's packages and its classes without a package.
   */
  private TreeSet<String> recordedClasses() {
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
   * Reads the recorded data; sources without data are omitted.
   *
   * @param data holds one folder per process
   */
  Coverage read(Path data) throws IOException, InterruptedException {
    Map<String, List<Coverage.Line>> found = new TreeMap<>();
    List<Coverage.Line> current = new ArrayList<>();
    for (String text : tool.read(classes, data, DATA, scratch, sandbox)) {
      Matcher line = LINE.matcher(text);
      if (text.startsWith(FILE)) {
        current = new ArrayList<>();
        String path = text.substring(FILE.length());
        if (sources.contains(path)) {
          found.put(path, current);
        }
      } else if (line.matches()) {
        current.add(
            new Coverage.Line(
                Integer.parseInt(line.group(1)),
                line.group(2).equals("1"),
                Integer.parseInt(line.group(3)),
                Integer.parseInt(line.group(4))));
      }
    }
    return new Coverage(
        found.entrySet().stream()
            .map(file -> new Coverage.File(folder + file.getKey(), file.getValue()))
            .toList());
  }
}
