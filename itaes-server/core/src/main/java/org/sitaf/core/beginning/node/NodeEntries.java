package org.sitaf.core.beginning.node;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.InvalidInputException;

/** Finds the programs and the classes of nodes in a package. */
final class NodeEntries {
  /** The end of {@code 'program = package.module:main'}, which may be split over lines. */
  private static final Pattern CONSOLE_SCRIPT =
      Pattern.compile("\\b([\\w.]{1,200})\\s{0,20}:\\s{0,20}(\\w{1,100})\\s{0,20}['\"]");

  /** Between strings that Python joins: {@code 'name = ' 'package.module:main'}. */
  private static final Pattern JOINED = Pattern.compile("'\\s{1,200}'|\"\\s{1,200}\"");

  private static final Pattern FUNCTION = Pattern.compile("([\\w.]{1,200}):(\\w{1,100})");

  private static final Pattern PYTHON_MAIN =
      Pattern.compile("^if\\s+__name__\\s*==\\s*['\"]__main__['\"]", Pattern.MULTILINE);
  private static final Pattern PYTHON_CLASS =
      Pattern.compile("^class\\s+(\\w{1,100})\\(([^)]{1,300})\\)\\s{0,20}:", Pattern.MULTILINE);
  private static final Pattern NODE = Pattern.compile("\\b(?:Lifecycle)?Node\\b");
  private static final Pattern CONSTRUCTOR =
      Pattern.compile("\\bdef\\s+__init__\\(([^)]{0,500})\\)");
  private static final Pattern UNINDENTED = Pattern.compile("^\\S", Pattern.MULTILINE);
  private static final Pattern CPP_MAIN = Pattern.compile("\\bint\\s+main\\s*\\(");
  private static final Pattern COMPONENT =
      Pattern.compile("\\bRCLCPP_COMPONENTS_REGISTER_NODE\\s*\\(\\s*(?:::)?([\\w:]{1,300})\\s*\\)");
  private static final Pattern CPP_SOURCE = Pattern.compile(".+\\.(cpp|cc|cxx|c\\+\\+|C)");

  private final NodePackage given;

  NodeEntries(NodePackage given) {
    this.given = given;
  }

  /**
   * The wanted entry, or the only one; a program is preferred to a class, because it says how the
   * node is spun.
   *
   * @throws InvalidInputException if there is none
   * @throws SeveralNodesException if there are several
   */
  NodeEntry choose(@Nullable String wanted) {
    List<NodeEntry> all = all();
    if (wanted != null) {
      return all.stream()
          .filter(entry -> entry.name().equals(wanted))
          .findFirst()
          .or(() -> function(wanted))
          .orElseThrow(
              () ->
                  InvalidInputException.of(
                      "class " + wanted, "is not in the package; it has " + shown(all)));
    }
    List<NodeEntry> mains = all.stream().filter(NodeEntry::isMain).toList();
    List<NodeEntry> first = mains.isEmpty() ? all : mains;
    if (first.isEmpty()) {
      throw InvalidInputException.of(
          given.name(),
          given.isCpp()
              ? "has neither a source with main nor a registered component"
              : "has neither a console script in setup.py, nor a script, nor a subclass of Node"
                  + " whose constructor takes nothing");
    }
    if (first.size() > 1) {
      throw new SeveralNodesException(given.name(), first.stream().map(NodeEntry::name).toList());
    }
    return first.get(0);
  }

  /** A function {@code module:function} that setup.py does not install. */
  private Optional<NodeEntry> function(String wanted) {
    Matcher parts = FUNCTION.matcher(wanted);
    if (given.isCpp() || !parts.matches()) {
      return Optional.empty();
    }
    String file = parts.group(1).replace('.', '/') + ".py";
    Pattern declared =
        Pattern.compile("^def\\s+" + Pattern.quote(parts.group(2)) + "\\s*\\(", Pattern.MULTILINE);
    return given.files().contains(file) && declared.matcher(given.text(file)).find()
        ? Optional.of(new NodeEntry(true, wanted, file))
        : Optional.empty();
  }

  private static String shown(List<NodeEntry> entries) {
    return entries.isEmpty()
        ? "no nodes"
        : String.join(", ", entries.stream().map(NodeEntry::name).toList());
  }

  private List<NodeEntry> all() {
    return (given.isCpp() ? cpp() : python()).stream().distinct().toList();
  }

  private List<NodeEntry> python() {
    List<NodeEntry> found = new ArrayList<>();
    given
        .files()
        .text("setup.py")
        .ifPresent(
            setup -> {
              Matcher script = CONSOLE_SCRIPT.matcher(JOINED.matcher(setup).replaceAll(""));
              while (script.find()) {
                String file = script.group(1).replace('.', '/') + ".py";
                if (given.files().contains(file)) {
                  found.add(new NodeEntry(true, script.group(1) + ":" + script.group(2), file));
                }
              }
            });
    boolean isInstalled = !found.isEmpty();
    for (String path : given.sources()) {
      String text = given.text(path);
      if (!text.contains("rclpy") || path.startsWith("test/") || path.startsWith("launch/")) {
        continue;
      }
      if (!isInstalled && PYTHON_MAIN.matcher(text).find()) {
        found.add(new NodeEntry(true, path, path));
      }
      Matcher node = PYTHON_CLASS.matcher(text);
      while (node.find()) {
        if (!NODE.matcher(node.group(2)).find() || !takesNothing(text, node.end())) {
          continue;
        }
        String module = path.substring(0, path.length() - ".py".length()).replace('/', '.');
        found.add(new NodeEntry(false, module + ":" + node.group(1), path));
      }
    }
    return found;
  }

  /** Whether the constructor of the class whose body begins at an index can be called as it is. */
  private static boolean takesNothing(String text, int body) {
    Matcher end = UNINDENTED.matcher(text);
    Matcher constructor =
        CONSTRUCTOR.matcher(text).region(body, end.find(body) ? end.start() : text.length());
    if (!constructor.find()) {
      return false;
    }
    List<String> parameters = Arrays.asList(constructor.group(1).split(",", 50));
    return parameters.stream()
        .skip(1)
        .map(String::strip)
        .allMatch(p -> p.isEmpty() || p.startsWith("*") || p.contains("="));
  }

  private List<NodeEntry> cpp() {
    List<NodeEntry> found = new ArrayList<>();
    for (String path : given.sources()) {
      String text = given.text(path);
      if (path.startsWith("test/") || !CPP_SOURCE.matcher(path).matches()) {
        continue;
      }
      if (CPP_MAIN.matcher(text).find()) {
        found.add(new NodeEntry(true, path, path));
      }
      Matcher component = COMPONENT.matcher(text);
      while (component.find()) {
        found.add(new NodeEntry(false, component.group(1), path));
      }
    }
    return found;
  }
}
