package org.sitaf.core.harness.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.harness.plan.HarnessPlan.Call;
import org.sitaf.core.model.Value;

/**
 * Parses the {@code before} calls of a test profile, such as {@code Enable()} or {@code
 * SetGain(0.5, "left")}.
 */
final class BeforeCalls {
  private static final Pattern CALL =
      Pattern.compile("\\s*([^\\s(]+)\\s*\\((.*)\\)\\s*", Pattern.DOTALL);

  /** An argument: a string in double quotes, or any text without a comma. */
  private static final Pattern ARGUMENT =
      Pattern.compile("\\s*(?:\"((?:[^\"\\\\]|\\\\.)*+)\"|([^,\"]*+))\\s*(,|$)", Pattern.DOTALL);

  private final List<InterfaceDescription> provided;
  private final Diagnostics diagnostics;

  BeforeCalls(List<InterfaceDescription> provided, Diagnostics diagnostics) {
    this.provided = provided;
    this.diagnostics = diagnostics;
  }

  List<Call> plan(List<String> calls, String profile) {
    List<Call> planned = new ArrayList<>();
    for (String call : calls) {
      try {
        planned.add(plan(call));
      } catch (IllegalArgumentException e) {
        diagnostics.error(profile, 0, "component.before", "'" + call + "': " + e.getMessage());
      }
    }
    return planned;
  }

  private Call plan(String call) {
    Matcher parts = CALL.matcher(call);
    if (!parts.matches() || !Words.isWord(parts.group(1))) {
      throw new IllegalArgumentException("is not a call such as Enable() or SetGain(0.5)");
    }
    List<String> literals = literals(parts.group(2));
    List<Method> candidates =
        provided.stream()
            .flatMap(i -> i.methodsNamed(parts.group(1)).stream())
            .filter(m -> m.parameters().size() == literals.size())
            .toList();
    if (candidates.isEmpty()) {
      throw new IllegalArgumentException(
          "no provided interface has a method "
              + parts.group(1)
              + " with "
              + literals.size()
              + " parameters; known methods: "
              + provided.stream()
                  .flatMap(i -> i.methods().stream())
                  .map(Method::name)
                  .distinct()
                  .toList());
    }
    IllegalArgumentException lastProblem = new IllegalArgumentException("no method matches");
    for (Method candidate : candidates) {
      try {
        return new Call(candidate, arguments(candidate, literals));
      } catch (IllegalArgumentException e) {
        lastProblem = e;
      }
    }
    throw lastProblem;
  }

  private static List<Value> arguments(Method method, List<String> literals) {
    List<Value> arguments = new ArrayList<>();
    for (int i = 0; i < literals.size(); i++) {
      Parameter parameter = method.parameters().get(i);
      boolean single =
          parameter.type() instanceof DataType.Scalar
              || parameter.type() instanceof DataType.Enumeration;
      if (!single || parameter.direction() != Direction.IN) {
        throw new IllegalArgumentException(
            "parameter "
                + parameter.name()
                + " is of type "
                + parameter.type().typeName()
                + ", which is not supported here; call it in the concrete test driver, where the"
                + " component is created");
      }
      Value value = Value.parse(literals.get(i), parameter.type());
      if (parameter.type() instanceof DataType.Enumeration enumeration
          && !enumeration.literals().contains(value.literal())) {
        throw new IllegalArgumentException(
            "'"
                + value.literal()
                + "' is not a literal of "
                + enumeration.name()
                + "; known literals: "
                + enumeration.literals());
      }
      if (parameter.type().typeName().equals("char") && value.literal().length() != 1) {
        throw new IllegalArgumentException("'" + value.literal() + "' is not a single character");
      }
      arguments.add(value);
    }
    return arguments;
  }

  private static List<String> literals(String text) {
    List<String> literals = new ArrayList<>();
    if (text.isBlank()) {
      return literals;
    }
    Matcher argument = ARGUMENT.matcher(text);
    int at = 0;
    boolean more = true;
    while (more) {
      if (!argument.find(at) || argument.start() != at) {
        throw new IllegalArgumentException("has an invalid argument");
      }
      literals.add(
          argument.group(1) != null
              ? argument.group(1).replaceAll("\\\\(.)", "$1")
              : argument.group(2).strip());
      more = argument.group(3).equals(",");
      at = argument.end();
    }
    if (at != text.length()) {
      throw new IllegalArgumentException("has an invalid argument");
    }
    return literals;
  }
}
