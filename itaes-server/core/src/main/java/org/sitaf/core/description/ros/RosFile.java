package org.sitaf.core.description.ros;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.BiConsumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.core.description.source.Findings;
import org.sitaf.core.description.source.Place;

/**
 * A {@code .msg}, {@code .srv} or {@code .action} file with its one, two or three sections of
 * fields, and its constants.
 */
record RosFile(
    RosName name, String path, List<List<Field>> sections, Map<String, Object> constants) {
  private static final Pattern CONSTANT = Pattern.compile("([A-Za-z]\\w*)\\s*=\\s*(.*)");
  private static final Pattern FIELD = Pattern.compile("(\\S+)(?:\\s+(.*))?");
  private static final int MAX_FIELDS = 5_000;

  RosFile {
    sections = sections.stream().map(List::copyOf).toList();
    constants = Map.copyOf(constants);
  }

  /**
   * A field.
   *
   * @param type as written, such as {@code geometry_msgs/Pose[<=5]}
   */
  record Field(String type, String name, int line) {}

  /** Reads a file. Problems are added to the findings. */
  static RosFile read(String text, String path, RosName name, Findings findings) {
    List<List<Field>> sections = new ArrayList<>();
    List<Field> section = new ArrayList<>();
    sections.add(section);
    Set<String> names = new HashSet<>();
    Map<String, Object> constants = new TreeMap<>();
    int number = 0;
    int fields = 0;
    for (String line : (Iterable<String>) text.lines()::iterator) {
      number++;
      String content = withoutComment(line).strip();
      if (content.equals("---")) {
        section = new ArrayList<>();
        sections.add(section);
        names.clear();
      } else if (!content.isEmpty()) {
        String owner = name.section(sections.size() - 1);
        Field field =
            field(
                content,
                new Place(path, number, ""),
                names,
                (constant, value) -> constants.put(owner + "." + constant, value),
                findings);
        if (field != null) {
          section.add(field);
          fields++;
        }
        if (fields > MAX_FIELDS) {
          findings.error(
              new Place(path, number, ""), "has more than " + MAX_FIELDS + " fields; split it");
          break;
        }
      }
    }
    int expected = name.kind().sections();
    if (sections.size() != expected) {
      findings.error(
          new Place(path, 0, ""),
          "a ."
              + name.kind().folder()
              + " file has "
              + (expected - 1)
              + " lines '---', not "
              + (sections.size() - 1));
      while (sections.size() < expected) {
        sections.add(List.of());
      }
    }
    return new RosFile(name, path, sections.subList(0, expected), constants);
  }

  private static @org.jspecify.annotations.Nullable Field field(
      String content,
      Place place,
      Set<String> names,
      BiConsumer<String, Object> constants,
      Findings findings) {
    String[] parts = content.split("\\s+", 2);
    String rest = parts.length < 2 ? "" : parts[1].strip();
    if (rest.isEmpty()) {
      findings.error(place, "a line must contain a type and a name, such as 'float64 x'");
      return null;
    }
    Matcher constant = CONSTANT.matcher(rest);
    boolean isConstant = constant.matches();
    Matcher named = FIELD.matcher(rest);
    String name =
        findings.identifier(
            isConstant ? constant.group(1) : named.matches() ? named.group(1) : rest, place);
    Place at = new Place(place.file(), place.line(), (isConstant ? "constant " : "field ") + name);
    if (!names.add(name)) {
      findings.error(at, "is defined twice");
      return null;
    }
    if (!isConstant) {
      return new Field(parts[0], name, place.line());
    }
    if (constant.group(2).isEmpty()) {
      findings.error(at, "has no value");
    } else {
      value(parts[0], constant.group(2).strip()).ifPresent(v -> constants.accept(name, v));
    }
    return null;
  }

  /** The value of a constant; empty if it is not one of its type. */
  private static Optional<Object> value(String type, String text) {
    try {
      return switch (type.replaceFirst("<=.*", "")) {
        case "bool" -> Optional.of(text.equalsIgnoreCase("true") || text.equals("1"));
        case "float32", "float64" -> Optional.of(Double.valueOf(text));
        case "string", "wstring" -> Optional.of(text.replaceFirst("^([\"'])(.*)\\1$", "$2"));
        default -> Optional.of(Long.decode(text));
      };
    } catch (NumberFormatException e) {
      return Optional.empty();
    }
  }

  /** A '#' in quotes does not begin a comment. */
  private static String withoutComment(String line) {
    char quote = 0;
    for (int i = 0; i < line.length(); i++) {
      char c = line.charAt(i);
      if (quote != 0) {
        if (c == '\\') {
          i++;
        } else if (c == quote) {
          quote = 0;
        }
      } else if (c == '#') {
        return line.substring(0, i);
      } else if (c == '"' || c == '\'') {
        quote = c;
      }
    }
    int comment = quote == 0 ? -1 : line.indexOf('#');
    return comment < 0 ? line : line.substring(0, comment);
  }
}
