package org.sitaf.core.description;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * The path of a test element in a parameter: the whole parameter {@code pose}, a member {@code
 * pose.x} or an element {@code path[0]}.
 */
public final class MemberPath {
  private static final int MAX_NAMED = 12;
  private static final Pattern STEP = Pattern.compile("\\.([A-Za-z_]\\w*)|\\[(\\d{1,6})]");

  private MemberPath() {}

  /** One step of a path. */
  public sealed interface Step {
    /** Selects a member of a struct. */
    record Member(String name) implements Step {}

    /**
     * Selects an element of a sequence or an array.
     *
     * @param index from 0
     */
    record Element(int index) implements Step {}
  }

  /** The name of the parameter at the beginning of a path. */
  public static String root(String name) {
    return name.split("[.\\[]", 2)[0];
  }

  /**
   * The steps after the parameter's name; empty for the whole parameter.
   *
   * @throws IllegalArgumentException if the name is not a valid path
   */
  public static List<Step> steps(String name) {
    List<Step> steps = new ArrayList<>();
    Matcher step = STEP.matcher(name);
    int at = root(name).length();
    while (at < name.length()) {
      if (!step.find(at) || step.start() != at) {
        throw new IllegalArgumentException(
            "'" + name + "' is not a path such as pose, pose.x or path[0]");
      }
      steps.add(
          step.group(1) != null
              ? new Step.Member(step.group(1))
              : new Step.Element(Integer.parseInt(step.group(2))));
      at = step.end();
    }
    return steps;
  }

  /**
   * Resolves the type at a path.
   *
   * @param root type of the parameter
   * @return empty if there is no such member or element; {@link DataType.Unknown} if a type on the
   *     path is unknown
   */
  public static Optional<DataType> resolve(DataType root, String name) {
    DataType type = root;
    int at = root(name).length();
    Matcher step = STEP.matcher(name);
    while (at < name.length()) {
      if (!step.find(at) || step.start() != at) {
        return Optional.empty();
      }
      if (type instanceof DataType.Unknown) {
        return Optional.of(type);
      }
      Optional<DataType> next =
          step.group(1) != null
              ? member(type, step.group(1))
              : element(type, Integer.parseInt(step.group(2)));
      if (next.isEmpty()) {
        return Optional.empty();
      }
      type = next.get();
      at = step.end();
    }
    return Optional.of(type);
  }

  /**
   * Says which member or element there is not.
   *
   * @param root type of the parameter
   * @param name a name for which {@link #resolve} finds nothing
   */
  public static String missing(DataType root, String name) {
    DataType type = root;
    Matcher step = STEP.matcher(name);
    for (int at = root(name).length(); step.find(at) && step.start() == at; at = step.end()) {
      String member = step.group(1);
      Optional<DataType> next =
          member != null ? member(type, member) : element(type, Integer.parseInt(step.group(2)));
      if (next.isPresent()) {
        type = next.get();
        continue;
      }
      if (member != null && type instanceof DataType.Struct struct) {
        return type.typeName()
            + " has no member '"
            + member
            + "'; it has "
            + struct.members().stream()
                .map(DataType.Member::name)
                .limit(MAX_NAMED)
                .collect(Collectors.joining(", "))
            + (struct.members().size() > MAX_NAMED ? ", ..." : "");
      }
      break;
    }
    return root.typeName() + " has no such member or element";
  }

  private static Optional<DataType> member(DataType type, String name) {
    return type instanceof DataType.Struct struct
        ? struct.members().stream()
            .filter(m -> m.name().equals(name))
            .map(DataType.Member::type)
            .findFirst()
        : Optional.empty();
  }

  private static Optional<DataType> element(DataType type, int index) {
    if (type instanceof DataType.Sequence sequence) {
      return sequence.bound() == 0 || index < sequence.bound()
          ? Optional.of(sequence.element())
          : Optional.empty();
    }
    return type instanceof DataType.FixedArray array && index < array.length()
        ? Optional.of(array.element())
        : Optional.empty();
  }
}
