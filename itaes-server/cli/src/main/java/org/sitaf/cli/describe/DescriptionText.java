package org.sitaf.cli.describe;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sitaf.core.description.CallType;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.source.ComponentDescription;
import org.sitaf.core.description.source.ComponentDescription.Execution;
import org.sitaf.core.description.source.ComponentDescription.Port;
import org.sitaf.core.description.source.ImportResult;

/** Formats a description as lines of text. Names are not escaped. */
public final class DescriptionText {
  private static final int MAX_COLUMN_WIDTH = 32;
  private static final int MAX_LITERALS = 12;

  private final ImportResult result;
  private final UnaryOperator<String> shownFile;
  private final List<String> lines = new ArrayList<>();

  private DescriptionText(ImportResult result, UnaryOperator<String> shownFile) {
    this.result = result;
    this.shownFile = shownFile;
  }

  /**
   * The lines of a description: components, interfaces, types, constants.
   *
   * @param shownFile maps a file to the name that the user knows
   */
  public static List<String> of(ImportResult result, UnaryOperator<String> shownFile) {
    DescriptionText text = new DescriptionText(result, shownFile);
    text.write();
    return List.copyOf(text.lines);
  }

  private void write() {
    result.components().forEach(this::write);
    Map<InterfaceDescription, Void> all = new LinkedHashMap<>();
    result.provided().forEach(i -> all.put(i, null));
    result.required().forEach(i -> all.put(i, null));
    all.keySet().forEach(this::write);
    writeTypes();
    writeConstants();
  }

  private void write(ComponentDescription component) {
    heading("component", component.name() + " " + component.version(), component.source());
    if (!component.description().isEmpty()) {
      lines.add("  " + component.description());
    }
    List<String[]> rows = new ArrayList<>();
    rows.add(new String[] {"execution", words(component.execution())});
    for (ComponentDescription.Property property : component.properties()) {
      String value =
          property.defaultValue().filter(v -> !v.isEmpty()).map(v -> " = " + v).orElse("");
      rows.add(
          new String[] {"property", property.name() + " : " + property.type().typeName() + value});
    }
    component.ports().forEach(port -> rows.add(row(port, component.source())));
    table(rows);
    lines.add("");
  }

  private static String words(Execution execution) {
    if (execution instanceof Execution.Periodic periodic) {
      return "periodic, every " + periodic.period() + " ms";
    }
    if (execution instanceof Execution.Unspecified unspecified) {
      return unspecified.text().isEmpty() ? "not stated" : unspecified.text();
    }
    return "passive";
  }

  private String[] row(Port port, String profile) {
    if (port instanceof Port.Service service) {
      String type =
          service.interfaceName().equals(service.name()) ? "" : " : " + service.interfaceName();
      String folder = profile.substring(0, profile.lastIndexOf('/') + 1);
      String file =
          service.file().isEmpty()
              ? "missing"
              : service.file().startsWith(folder)
                  ? service.file().substring(folder.length())
                  : shownFile.apply(service.file());
      return new String[] {
        service.provided() ? "provides" : "requires", service.name() + type + "  (" + file + ")"
      };
    }
    if (port instanceof Port.Data data) {
      return new String[] {
        data.output() ? "data out" : "data in", data.name() + " : " + data.type().typeName()
      };
    }
    Port.Event event = (Port.Event) port;
    return new String[] {
      event.output() ? "event out" : "event in", event.name() + " : " + event.type().typeName()
    };
  }

  private void write(InterfaceDescription description) {
    heading(
        "interface", description.name() + "  (" + usage(description) + ")", description.source());
    List<String[]> rows = new ArrayList<>();
    for (Method method : description.methods()) {
      rows.add(new String[] {method.returnType().typeName(), prototype(method)});
    }
    table(rows);
    String unknown =
        new TreeSet<>(
                types(description)
                    .filter(t -> t instanceof DataType.Unknown)
                    .map(DataType::typeName)
                    .toList())
            .stream().collect(Collectors.joining(", "));
    if (!unknown.isEmpty()) {
      lines.add("  unknown types: " + unknown);
    }
    lines.add("");
  }

  /** The components that provide and require the interface. */
  private String usage(InterfaceDescription description) {
    List<String> words = new ArrayList<>();
    for (boolean provided : new boolean[] {true, false}) {
      String components =
          result.components().stream()
              .filter(
                  c ->
                      c.ports().stream()
                          .anyMatch(
                              port ->
                                  port instanceof Port.Service service
                                      && service.provided() == provided
                                      && service.interfaceName().equals(description.name())
                                      && service.file().equals(description.source())))
              .map(ComponentDescription::name)
              .distinct()
              .collect(Collectors.joining(", "));
      if (!components.isEmpty()) {
        words.add((provided ? "provided by " : "required by ") + components);
      }
    }
    return words.isEmpty() ? "provided" : String.join("; ", words);
  }

  private static String prototype(Method method) {
    String parameters =
        method.parameters().stream()
            .map(DescriptionText::spelling)
            .collect(Collectors.joining(", ", "(", ")"));
    return method.name()
        + parameters
        + (method.callType() == CallType.NONBLOCKING ? "  nonblocking" : "")
        + (method.raises().isEmpty() ? "" : "  raises " + String.join(", ", method.raises()));
  }

  private static String spelling(Parameter parameter) {
    String direction =
        parameter.direction() == Direction.IN
            ? ""
            : parameter.direction().name().toLowerCase(Locale.ROOT) + " ";
    return direction + parameter.type().typeName() + " " + parameter.name();
  }

  private void writeTypes() {
    Map<String, DataType> named = new LinkedHashMap<>();
    Stream<DataType> used =
        Stream.of(result.provided(), result.required())
            .flatMap(Collection::stream)
            .flatMap(DescriptionText::types);
    Stream.concat(parts(Stream.concat(result.types().stream(), ports())).stream(), used)
        .filter(t -> t instanceof DataType.Struct || t instanceof DataType.Enumeration)
        .forEach(type -> named.putIfAbsent(type.typeName(), type));
    named.values().forEach(this::write);
  }

  private void write(DataType type) {
    if (type instanceof DataType.Struct struct) {
      lines.add("struct " + struct.name());
      table(
          struct.members().stream()
              .map(m -> new String[] {m.type().typeName(), m.name()})
              .toList());
    } else if (type instanceof DataType.Enumeration enumeration) {
      List<String> literals = enumeration.literals();
      int more = literals.size() - MAX_LITERALS;
      lines.add("enum " + enumeration.name());
      lines.add(
          "  "
              + literals.stream().limit(MAX_LITERALS).collect(Collectors.joining(", "))
              + (more > 0 ? " and " + more + " more" : ""));
    }
    lines.add("");
  }

  /** Under the names that expressions use. */
  private void writeConstants() {
    if (result.constants().isEmpty()) {
      return;
    }
    lines.add("constants");
    List<String[]> rows = new ArrayList<>();
    result
        .constants()
        .forEach(
            (name, value) ->
                rows.add(
                    new String[] {
                      name, value instanceof String text ? "= \"" + text + "\"" : "= " + value
                    }));
    table(rows);
    lines.add("");
  }

  private Stream<DataType> ports() {
    return result.components().stream()
        .flatMap(c -> c.ports().stream())
        .flatMap(
            port -> {
              if (port instanceof Port.Data data) {
                return Stream.of(data.type());
              }
              return port instanceof Port.Event event ? Stream.of(event.type()) : Stream.of();
            });
  }

  private static Stream<DataType> types(InterfaceDescription description) {
    return parts(
        description.methods().stream()
            .flatMap(
                m ->
                    Stream.concat(
                        Stream.of(m.returnType()), m.parameters().stream().map(Parameter::type))))
        .stream();
  }

  /** Types with all their parts, each name once. */
  private static Collection<DataType> parts(Stream<DataType> types) {
    Map<String, DataType> parts = new LinkedHashMap<>();
    Deque<DataType> open = new ArrayDeque<>(types.toList());
    while (!open.isEmpty()) {
      DataType type = open.poll();
      if (parts.putIfAbsent(type.typeName(), type) == null) {
        open.addAll(type.parts());
      }
    }
    return parts.values();
  }

  private void heading(String kind, String name, String file) {
    lines.add(kind + " " + name.strip() + "  " + shownFile.apply(file));
  }

  /** Two columns; the first is as wide as necessary up to a limit. */
  private void table(List<String[]> rows) {
    int width =
        rows.stream()
            .mapToInt(row -> row[0].length())
            .filter(length -> length <= MAX_COLUMN_WIDTH)
            .max()
            .orElse(0);
    for (String[] row : rows) {
      lines.add("  " + row[0] + " ".repeat(Math.max(0, width - row[0].length())) + "  " + row[1]);
    }
  }
}
