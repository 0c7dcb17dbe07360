package org.sitaf.core.activity.ros;

import java.util.ArrayList;
import java.util.List;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.ScalarType;

/**
 * The numbers in the messages of a node that trajectory conditions can use as signals: {@code
 * OUTPUT.member}, without elements of arrays, and {@code OUTPUT.count}.
 */
public final class MessageSignals {
  /** How many messages came since the call. */
  public static final String COUNT = ".count";

  private MessageSignals() {}

  /** The names in the order of the outputs. */
  public static List<String> of(InterfaceDescription messages) {
    List<String> names = new ArrayList<>();
    for (Method output : messages.methods()) {
      for (Parameter member : output.parameters()) {
        // The last parameter is the time of the message, which is no member.
        if (member != output.parameters().get(output.parameters().size() - 1)) {
          add(output.name() + "." + member.name(), member.type(), names);
        }
      }
      names.add(output.name() + COUNT);
    }
    return names;
  }

  private static void add(String name, DataType type, List<String> names) {
    if (type instanceof DataType.Struct struct) {
      struct.members().forEach(m -> add(name + "." + m.name(), m.type(), names));
    } else if (type instanceof DataType.Scalar scalar
        && (scalar.type().isNumeric() || scalar.type() == ScalarType.BOOLEAN)) {
      names.add(name);
    }
  }
}
