package org.sitaf.core.activity;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.UnaryOperator;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.model.sequence.StateVariable;

/** Resolves the types of the abstract state: named types are found in all interfaces. */
final class SequenceTypes {
  private final Map<String, DataType> named = new LinkedHashMap<>();
  private final Set<DataType> seen = new HashSet<>();

  SequenceTypes(List<InterfaceDescription> provided, List<InterfaceDescription> required) {
    provided.forEach(this::add);
    required.forEach(this::add);
  }

  private void add(InterfaceDescription description) {
    for (Method method : description.methods()) {
      add(method.returnType());
      method.parameters().forEach(p -> add(p.type()));
    }
  }

  private void add(DataType type) {
    if (!seen.add(type)) {
      return;
    }
    if (type instanceof DataType.Enumeration || type instanceof DataType.Struct) {
      String name = type.typeName();
      named.putIfAbsent(name, type);
      String dotted = name.replace("::", ".").replace('/', '.');
      named.putIfAbsent(dotted, type);
      named.putIfAbsent(dotted.substring(dotted.lastIndexOf('.') + 1), type);
    }
    type.parts().forEach(this::add);
  }

  /**
   * The model with resolved types of its states, and of the inputs and outputs of its calls.
   *
   * @param ofCall resolves the test model of a call
   */
  TestModel resolve(TestModel model, SequenceSpec sequence, UnaryOperator<TestModel> ofCall) {
    List<StateVariable> states = sequence.states().stream().map(this::resolve).toList();
    return model.withSequence(
        sequence.with(
            states,
            sequence.calls().stream()
                .map(c -> c.withModel(ofCall.apply(withTypes(c.model(), states))))
                .toList()));
  }

  private StateVariable resolve(StateVariable state) {
    return state.withType(resolve(state.type()));
  }

  private DataType resolve(DataType type) {
    if (type instanceof DataType.Unknown unknown) {
      return named.getOrDefault(unknown.name(), unknown);
    }
    if (type instanceof DataType.Sequence list) {
      return new DataType.Sequence(resolve(list.element()), list.bound());
    }
    if (type instanceof DataType.FixedArray array) {
      return new DataType.FixedArray(resolve(array.element()), array.length());
    }
    return type;
  }

  private static TestModel withTypes(TestModel call, List<StateVariable> states) {
    Map<String, DataType> surroundings = new LinkedHashMap<>(call.surroundings());
    states.forEach(s -> surroundings.replace(s.name(), s.type()));
    return call.withSurroundings(surroundings);
  }
}
