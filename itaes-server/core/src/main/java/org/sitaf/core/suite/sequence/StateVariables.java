package org.sitaf.core.suite.sequence;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.sitaf.core.description.DataType;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.sequence.StateVariable;
import org.sitaf.core.suite.ResultLiteral;

/** Converts abstract states to variables of expressions and back. */
final class StateVariables {
  private final List<StateVariable> variables;

  StateVariables(List<StateVariable> variables) {
    this.variables = List.copyOf(variables);
  }

  AbstractState initial() {
    return new AbstractState(variables.stream().map(StateVariables::initial).toList());
  }

  /**
   * The literal that a result with the same value has, so that equal states are one.
   *
   * @throws IllegalArgumentException if the initial value is not one of the type
   */
  static String initial(StateVariable of) {
    String literal = of.initial().literal();
    DataType type = of.type();
    if (type instanceof DataType.Scalar || type instanceof DataType.Unknown) {
      return literal;
    }
    Object value = Variables.plain(literal, type);
    if (!fits(value, type)) {
      throw new IllegalArgumentException(
          "'"
              + literal
              + "' is not a value of "
              + type.typeName()
              + "; write a list such as [1, 2] or [], or a struct with all members such as {x: 1.0}");
    }
    return ResultLiteral.of(value, type);
  }

  private static boolean fits(Object value, DataType type) {
    if (type instanceof DataType.FixedArray array) {
      return value instanceof List<?> elements && elements.size() == array.length();
    }
    if (type instanceof DataType.Struct struct) {
      Set<String> names =
          struct.members().stream().map(DataType.Member::name).collect(Collectors.toSet());
      return value instanceof Map<?, ?> members && members.keySet().equals(names);
    }
    return !(type instanceof DataType.Sequence) || value instanceof List;
  }

  Variables variables(AbstractState state) {
    Variables named = new Variables();
    put(named, state);
    return named;
  }

  void put(Variables named, AbstractState state) {
    for (int i = 0; i < variables.size(); i++) {
      named.put(variables.get(i).name(), state.literals().get(i), variables.get(i).type());
    }
  }

  /**
   * The literal of a result for a variable.
   *
   * @throws IllegalArgumentException if it is not a value of the type
   */
  String literal(int variable, Object result) {
    StateVariable of = variables.get(variable);
    String literal = ResultLiteral.of(result, of.type());
    if (of.type() instanceof DataType.Enumeration enumeration
        && !enumeration.literals().contains(literal)) {
      throw new IllegalArgumentException(
          "'" + literal + "' is not a literal of " + enumeration.name());
    }
    return literal;
  }

  int index(String name) {
    return IntStream.range(0, variables.size())
        .filter(i -> variables.get(i).name().equals(name))
        .findFirst()
        .orElse(-1);
  }

  String text(AbstractState state) {
    return IntStream.range(0, variables.size())
        .mapToObj(i -> variables.get(i).name() + "=" + state.literals().get(i))
        .collect(Collectors.joining(", "));
  }
}
