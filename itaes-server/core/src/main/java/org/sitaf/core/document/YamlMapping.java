package org.sitaf.core.document;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.NearestName;
import org.yaml.snakeyaml.nodes.MappingNode;
import org.yaml.snakeyaml.nodes.Node;
import org.yaml.snakeyaml.nodes.NodeTuple;
import org.yaml.snakeyaml.nodes.ScalarNode;
import org.yaml.snakeyaml.nodes.SequenceNode;
import org.yaml.snakeyaml.nodes.Tag;

/**
 * A mapping of a YAML document. An entry of the wrong kind is reported and then treated as absent.
 */
public final class YamlMapping {
  private final Map<String, Node> entries = new LinkedHashMap<>();
  private final int line;
  private final String file;
  private final String path;
  private final Diagnostics diagnostics;

  YamlMapping(MappingNode node, String file, String path, Diagnostics diagnostics) {
    this.line = node.getStartMark().getLine() + 1;
    this.file = file;
    this.path = path;
    this.diagnostics = diagnostics;
    for (NodeTuple tuple : node.getValue()) {
      if (!(tuple.getKeyNode() instanceof ScalarNode key)) {
        problem(tuple.getKeyNode(), path, "a name must be plain text");
      } else if (entries.putIfAbsent(key.getValue(), tuple.getValueNode()) != null) {
        problem(key, pathOf(key.getValue()), "is defined twice; remove one");
      }
    }
  }

  /** Names of all entries in document order. */
  public List<String> names() {
    return List.copyOf(entries.keySet());
  }

  /** Whether an entry exists and is not null. */
  public boolean has(String name) {
    return find(name).isPresent();
  }

  /** Line of an entry, or of the mapping if the entry does not exist; from 1. */
  public int line(String name) {
    Node node = entries.get(name);
    return node == null ? line : node.getStartMark().getLine() + 1;
  }

  /** Reports entries whose name is not in {@code known}. */
  public void allowOnly(Set<String> known) {
    for (String name : entries.keySet()) {
      if (!known.contains(name)) {
        diagnostics.error(
            file,
            line(name),
            pathOf(name),
            "unknown entry"
                + NearestName.hint(name, known)
                + " Known entries: "
                + String.join(", ", new java.util.TreeSet<>(known)));
      }
    }
  }

  /** The text of an entry. */
  public Optional<String> text(String name) {
    return find(name).flatMap(node -> textOf(node, pathOf(name)));
  }

  /** The text of a required entry. A missing entry is reported and read as the empty text. */
  public String requiredText(String name) {
    Optional<String> text = text(name);
    if (text.isEmpty() && find(name).isEmpty()) {
      diagnostics.error(file, line, pathOf(name), "is missing");
    }
    return text.orElse("");
  }

  /** The entry as a finite number. */
  public Optional<Double> number(String name) {
    return text(name)
        .flatMap(
            text -> {
              try {
                double number = Double.parseDouble(text);
                if (!Double.isNaN(number) && !Double.isInfinite(number)) {
                  return Optional.of(number);
                }
              } catch (NumberFormatException e) {
                // Reported below.
              }
              diagnostics.error(
                  file, line(name), pathOf(name), "'" + text + "' is not a finite number");
              return Optional.empty();
            });
  }

  /** The entry as {@code true} or {@code false}. */
  public Optional<Boolean> booleanValue(String name) {
    return text(name)
        .flatMap(
            text ->
                switch (text) {
                  case "true" -> Optional.of(true);
                  case "false" -> Optional.of(false);
                  default -> {
                    diagnostics.error(
                        file, line(name), pathOf(name), "'" + text + "' is not true or false");
                    yield Optional.empty();
                  }
                });
  }

  /** The entry as a list of texts; empty if there is no such entry. */
  public List<String> texts(String name) {
    List<String> texts = new ArrayList<>();
    find(name)
        .ifPresent(
            node -> {
              if (node instanceof SequenceNode sequence) {
                for (Node item : sequence.getValue()) {
                  textOf(item, pathOf(name)).ifPresent(texts::add);
                }
              } else {
                problem(node, pathOf(name), "must be a list, such as [a, b]");
              }
            });
    return List.copyOf(texts);
  }

  /**
   * An item of a list.
   *
   * @param text null if the item is a mapping
   * @param mapping null if the item is plain text
   * @param line from 1
   */
  public record Item(@Nullable String text, @Nullable YamlMapping mapping, int line) {}

  /** The texts and mappings of a list; an entry that is no list is its only item. */
  public List<Item> items(String name) {
    List<Item> items = new ArrayList<>();
    find(name)
        .ifPresent(
            node -> {
              List<Node> nodes =
                  node instanceof SequenceNode sequence ? sequence.getValue() : List.of(node);
              for (Node item : nodes) {
                int at = item.getStartMark().getLine() + 1;
                if (item instanceof MappingNode nested) {
                  var mapping = new YamlMapping(nested, file, pathOf(name), diagnostics);
                  items.add(new Item(null, mapping, at));
                } else {
                  textOf(item, pathOf(name)).ifPresent(text -> items.add(new Item(text, null, at)));
                }
              }
            });
    return List.copyOf(items);
  }

  /**
   * The entry as data: a Boolean, Long, Double or String by the rules of YAML, a List, or a Map
   * with texts as keys.
   */
  public Optional<Object> data(String name) {
    return find(name).map(YamlMapping::data);
  }

  private static Object data(Node node) {
    if (node instanceof SequenceNode sequence) {
      return sequence.getValue().stream().map(YamlMapping::data).toList();
    }
    if (node instanceof MappingNode mapping) {
      Map<String, Object> members = new LinkedHashMap<>();
      for (NodeTuple tuple : mapping.getValue()) {
        if (tuple.getKeyNode() instanceof ScalarNode key) {
          members.put(key.getValue(), data(tuple.getValueNode()));
        }
      }
      return members;
    }
    String text = ((ScalarNode) node).getValue();
    Tag tag = node.getTag();
    if (tag.equals(Tag.BOOL)) {
      return Set.of("true", "yes", "on").contains(text.toLowerCase(Locale.ROOT));
    }
    try {
      if (tag.equals(Tag.INT)) {
        return Long.decode(text.replace("_", ""));
      }
      if (tag.equals(Tag.FLOAT)) {
        return real(text.replace("_", "").toLowerCase(Locale.ROOT));
      }
    } catch (NumberFormatException e) {
      // Such as 1:30, which YAML 1.1 counts in sixties; ROS reads it as text.
    }
    return text;
  }

  private static double real(String text) {
    return switch (text) {
      case ".inf", "+.inf" -> Double.POSITIVE_INFINITY;
      case "-.inf" -> Double.NEGATIVE_INFINITY;
      case ".nan" -> Double.NaN;
      default -> Double.parseDouble(text);
    };
  }

  /** The entry as a nested mapping. */
  public Optional<YamlMapping> mapping(String name) {
    return find(name)
        .flatMap(
            node -> {
              if (node instanceof MappingNode mapping) {
                return Optional.of(new YamlMapping(mapping, file, pathOf(name), diagnostics));
              }
              problem(node, pathOf(name), "must be a mapping of names to values");
              return Optional.empty();
            });
  }

  /** Reports a problem with an entry. */
  public void problem(String name, String message) {
    diagnostics.error(file, line(name), pathOf(name), message);
  }

  private void problem(Node node, String at, String message) {
    diagnostics.error(file, node.getStartMark().getLine() + 1, at, message);
  }

  private Optional<String> textOf(Node node, String at) {
    if (node instanceof ScalarNode scalar) {
      return Optional.of(scalar.getValue());
    }
    problem(node, at, "must be plain text");
    return Optional.empty();
  }

  private Optional<Node> find(String name) {
    @Nullable Node node = entries.get(name);
    return node == null || node.getTag().equals(Tag.NULL) ? Optional.empty() : Optional.of(node);
  }

  private String pathOf(String name) {
    return path.isEmpty() ? name : path + "." + name;
  }
}
