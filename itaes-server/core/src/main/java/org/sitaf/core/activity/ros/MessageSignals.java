package org.sitaf.core.activity.ros;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.trajectory.TrajectoryConditions;

/**
 * The numbers in the messages of a node that trajectory conditions can use as signals: {@code
 * OUTPUT.member}, elements of arrays of numbers as {@code OUTPUT.member[0]}, and {@code
 * OUTPUT.count}.
 */
public final class MessageSignals {
  /** How many messages came since the call. */
  public static final String COUNT = ".count";

  private MessageSignals() {}

  /** The names of single values in the order of the outputs. */
  public static List<String> of(InterfaceDescription messages) {
    List<String> names = new ArrayList<>();
    add(messages, names, new TreeMap<>());
    return names;
  }

  /**
   * The names of arrays of numbers with their lengths; {@link TrajectoryConditions#ANY_LENGTH} if
   * each message gives the length.
   */
  public static Map<String, Integer> lists(InterfaceDescription messages) {
    Map<String, Integer> lists = new TreeMap<>();
    add(messages, new ArrayList<>(), lists);
    return lists;
  }

  private static void add(
      InterfaceDescription messages, List<String> names, Map<String, Integer> lists) {
    for (Method output : messages.methods()) {
      for (Parameter member : output.parameters()) {
        // The last parameter is the time of the message, which is no member.
        if (member != output.parameters().get(output.parameters().size() - 1)) {
          add(output.name() + "." + member.name(), member.type(), names, lists);
        }
      }
      names.add(output.name() + COUNT);
    }
  }

  private static void add(
      String name, DataType type, List<String> names, Map<String, Integer> lists) {
    if (type instanceof DataType.Struct struct) {
      struct.members().forEach(m -> add(name + "." + m.name(), m.type(), names, lists));
    } else if (type instanceof DataType.Sequence sequence && isSingle(sequence.element())) {
      lists.put(name, TrajectoryConditions.ANY_LENGTH);
    } else if (type instanceof DataType.FixedArray array && isSingle(array.element())) {
      lists.put(name, array.length());
    } else if (isSingle(type)) {
      names.add(name);
    }
  }

  private static boolean isSingle(DataType type) {
    return type instanceof DataType.Scalar scalar
        && (scalar.type().isNumeric() || scalar.type() == ScalarType.BOOLEAN);
  }
}
