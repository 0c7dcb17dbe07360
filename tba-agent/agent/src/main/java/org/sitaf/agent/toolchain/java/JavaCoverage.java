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
 * Which lines of a Java component are reached.
 *
 * @param classes where the component's classes are
 * @param folder of the component's sources within the activity, with a slash at its end
 * @param sources what is in that folder
 * @param scratch a folder for what nobody needs afterwards, absolute
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

  /** Empty where the component has no sources. */
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

  /** JaCoCo's agent, a jar. */
  Path recorder() {
    return tool.recorder();
  }

  /** What the JVM is started with, to record into a folder. */
  String flag(Path directory) {
    return "-javaagent:"
        + recorder()
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
   * Reads what processes have recorded. What is not said of a source of the component is left out.
   *
   * @param data holds a folder a process
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
