package org.sitaf.core.explain.report;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.explain.Explanation.Boundary;
import org.sitaf.core.explain.Explanation.Cause;
import org.sitaf.core.verdict.Verdict;

/** One plain sentence for each cause. */
public final class CauseText {
  private final UnaryOperator<String> shown;
  private final UnaryOperator<String> step;

  /**
   * Creates sentences.
   *
   * @param shown makes text of the user printable
   * @param step the same for a step of a sequence, which may be shortened
   */
  public CauseText(UnaryOperator<String> shown, UnaryOperator<String> step) {
    this.shown = shown;
    this.step = step;
  }

  /** Causes with the same boundary and the same other values, which are one sentence. */
  public static List<List<Cause>> merged(List<Cause> causes) {
    Map<Object, List<Cause>> groups = new LinkedHashMap<>();
    for (Cause cause : causes) {
      Boundary boundary = cause.boundary();
      Object key = cause;
      if (boundary != null) {
        Map<String, String> others = new LinkedHashMap<>(cause.parameters());
        others.remove(boundary.parameter());
        key = List.of(others, boundary);
      }
      groups.computeIfAbsent(key, k -> new ArrayList<>()).add(cause);
    }
    return List.copyOf(groups.values());
  }

  /** The cause as a sentence, such as: fails where `order` is XYZ, whatever the rest. */
  public String sentence(Cause cause) {
    String verb = cause.verdict() == Verdict.ERROR ? "ends with an error" : "fails";
    String relation = cause.relation();
    if (relation != null) {
      return verb + " where " + shown.apply(relation) + ", whatever the rest";
    }
    if (!cause.steps().isEmpty()) {
      return verb
          + " at the end of: "
          + cause.steps().stream().map(step).collect(Collectors.joining(", "));
    }
    if (cause.parameters().isEmpty()) {
      return verb + " in every case";
    }
    List<String> parts = new ArrayList<>();
    cause.parameters().forEach((name, value) -> parts.add(part(name, value, cause.boundary())));
    String joined =
        parts.size() == 1
            ? parts.get(0)
            : String.join(", ", parts.subList(0, parts.size() - 1))
                + " and "
                + parts.get(parts.size() - 1);
    return verb
        + " where "
        + joined
        + (cause.simplest().size() == cause.parameters().size() ? "" : ", whatever the rest");
  }

  private String part(String name, String value, @Nullable Boundary boundary) {
    if (boundary == null || !boundary.parameter().equals(name)) {
      return name(name) + " is " + (value.isEmpty() ? "empty" : shown.apply(value));
    }
    double passes = Double.parseDouble(boundary.passes());
    double fails = Double.parseDouble(boundary.fails());
    return name(name) + (fails > passes ? " is above " : " is below ") + boundary.passes();
  }

  /** Text of the user as one printable line. */
  String shown(String text) {
    return shown.apply(text);
  }

  /** The name of an input within a sentence. */
  public String name(String name) {
    return "`" + shown.apply(name) + "`";
  }
}
