package org.sitaf.core.activity;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.MemberPath;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.description.source.ComponentDescription.Port;

/**
 * The output data ports that trajectory conditions can use as signals: numbers, booleans and
 * enumerations, also as members of structs and as elements of arrays of a fixed length.
 */
public final class PortSignals {
  /** Longest array whose elements are signals. */
  private static final int MAX_ELEMENTS = 10_000;

  private static final Pattern NAME = Pattern.compile("[A-Za-z_]\\w*");

  private PortSignals() {}

  /** The names of single values in the order of the ports. */
  public static List<String> of(Collection<Port.Data> ports) {
    List<String> names = new ArrayList<>();
    ports.forEach(port -> add(port, names, new TreeMap<>()));
    return names;
  }

  /** The names of arrays with their lengths. */
  public static Map<String, Integer> lists(Collection<Port.Data> ports) {
    Map<String, Integer> lists = new TreeMap<>();
    ports.forEach(port -> add(port, new ArrayList<>(), lists));
    return lists;
  }

  /** The type of a signal; empty if no port has it. */
  public static Optional<DataType> type(Collection<Port.Data> ports, String signal) {
    return ports.stream()
        .filter(port -> port.name().equals(MemberPath.root(signal)))
        .findFirst()
        .flatMap(port -> MemberPath.resolve(port.type(), signal))
        .filter(PortSignals::isSingle);
  }

  private static void add(Port.Data port, List<String> names, Map<String, Integer> lists) {
    if (NAME.matcher(port.name()).matches()) {
      add(port.name(), port.type(), names, lists);
    }
  }

  private static void add(
      String name, DataType type, List<String> names, Map<String, Integer> lists) {
    if (type instanceof DataType.Struct struct) {
      struct.members().forEach(m -> add(name + "." + m.name(), m.type(), names, lists));
    } else if (type instanceof DataType.FixedArray array
        && isSingle(array.element())
        && array.length() > 0
        && array.length() <= MAX_ELEMENTS) {
      lists.put(name, array.length());
    } else if (isSingle(type)) {
      names.add(name);
    }
  }

  private static boolean isSingle(DataType type) {
    return type instanceof DataType.Enumeration
        || type instanceof DataType.Scalar scalar
            && (scalar.type().isNumeric() || scalar.type() == ScalarType.BOOLEAN);
  }
}
