import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A model of the includes without a compiler: a preprocessor for the few directives that the
 * generated sources use. A unit whose trace is the same gives the same object file.
 */
final class IncludeModel {
  private static final Pattern INCLUDE = Pattern.compile("#include (?:\"(.+)\"|<(.+)>|(\\w+))");
  private static final Pattern QUESTION = Pattern.compile("#if __has_include\\(\"(.+)\"\\)");
  private static final Pattern MACRO = Pattern.compile("#define (\\w+) \"(.+)\"");
  private static final Pattern BLOB = Pattern.compile(".*\\.incbin \\\\\"(.+)\\\\\".*");

  private final Map<String, byte[]> layout;
  private final List<String> folders;
  private final StringBuilder trace = new StringBuilder();
  private final Map<String, String> macros = new HashMap<>();
  private final List<String> once = new ArrayList<>();

  private IncludeModel(Project project) {
    this.layout = project.layout();
    this.folders = project.includeFolders();
  }

  /** The inputs of each C++ translation unit, by its path in the layout. */
  static Map<String, String> traces(Project project) {
    Map<String, String> traces = new TreeMap<>();
    for (String path : project.layout().keySet()) {
      boolean ofComponent =
          List.of("sources", "adapter").stream()
              .filter(project.component::containsKey)
              .anyMatch(entry -> path.startsWith("activity/" + project.component.get(entry)));
      if (path.matches(".*\\.(cpp|cc)") && (ofComponent || path.startsWith("harness/"))) {
        IncludeModel model = new IncludeModel(project);
        model.trace.append(path).append(project.includeFolders()).append('\n');
        model.read(path, 0);
        traces.put(path, model.trace.toString());
      }
    }
    return traces;
  }

  private void read(String path, int depth) {
    byte[] content = layout.get(path);
    trace.append(path).append(' ').append(Arrays.hashCode(content)).append(' ').append(content.length);
    trace.append('\n');
    String text = new String(content, StandardCharsets.UTF_8);
    if (once.contains(path)) {
      return;
    }
    if (text.startsWith("#pragma once")) {
      once.add(path);
    }
    boolean active = true;
    for (String line : text.split("\n")) {
      Matcher question = QUESTION.matcher(line);
      Matcher include = INCLUDE.matcher(line);
      Matcher macro = MACRO.matcher(line);
      Matcher blob = BLOB.matcher(line);
      if (question.matches()) {
        active = find(question.group(1), path, true) != null;
        trace.append(line).append(active).append('\n');
      } else if (line.equals("#else")) {
        active = !active;
      } else if (line.equals("#endif")) {
        active = true;
      } else if (active && macro.matches()) {
        macros.put(macro.group(1), macro.group(2));
      } else if (active && include.matches()) {
        String name =
            include.group(3) != null
                ? macros.get(include.group(3))
                : include.group(1) != null ? include.group(1) : include.group(2);
        String found = find(name, path, include.group(2) == null);
        if (found != null && depth < 20) {
          read(found, depth + 1);
        } else {
          trace.append("system ").append(name).append('\n');
        }
      } else if (active && blob.matches()) {
        String found = find(blob.group(1), path, false);
        trace.append(found).append(Arrays.hashCode(layout.get(found))).append('\n');
      }
    }
  }

  private String find(String name, String asking, boolean quoted) {
    List<String> places = new ArrayList<>(folders);
    if (quoted) {
      places.add(0, asking.substring(0, asking.lastIndexOf('/')));
    }
    for (String place : places) {
      Deque<String> parts = new ArrayDeque<>();
      for (String part : (place + "/" + name).split("/")) {
        if (part.equals("..")) {
          parts.pollLast();
        } else {
          parts.addLast(part);
        }
      }
      String path = String.join("/", parts);
      if (layout.containsKey(path)) {
        return path;
      }
    }
    return null;
  }
}
