package org.sitaf.cli.explain;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.explain.Explanation;
import org.sitaf.core.explain.Explanation.Boundary;
import org.sitaf.core.explain.Explanation.Cause;
import tools.jackson.databind.json.JsonMapper;

/** Writes explanations as JSON. */
final class ExplanationJson {
  private ExplanationJson() {}

  /**
   * Writes the explanations of all models. With several models each cause names its model.
   *
   * @param explanations by the name of the model
   */
  static void write(Map<String, Explanation> explanations, Path file) throws IOException {
    List<Map<String, @Nullable Object>> causes = new ArrayList<>();
    List<Integer> unexplained = new ArrayList<>();
    int executions = 0;
    for (Map.Entry<String, Explanation> each : explanations.entrySet()) {
      for (Cause cause : each.getValue().causes()) {
        Map<String, @Nullable Object> entry = new LinkedHashMap<>();
        if (explanations.size() > 1) {
          entry.put("model", each.getKey());
        }
        entry.put("parameters", cause.parameters());
        entry.put("relation", cause.relation());
        entry.put("verdict", cause.verdict().name());
        entry.put("message", cause.message());
        entry.put("cases", cause.cases());
        entry.put("simplest", cause.simplest());
        entry.put("boundary", boundary(cause.boundary()));
        entry.put("executions", cause.executions());
        if (!cause.steps().isEmpty()) {
          entry.put("steps", cause.steps());
        }
        causes.add(entry);
      }
      unexplained.addAll(each.getValue().unexplained());
      executions += each.getValue().executions();
    }
    Map<String, Object> document = new LinkedHashMap<>();
    document.put("causes", causes);
    document.put("executions", executions);
    document.put("unexplained", unexplained);
    Files.writeString(
        file,
        new JsonMapper().writerWithDefaultPrettyPrinter().writeValueAsString(document) + "\n");
  }

  private static @Nullable Map<String, String> boundary(@Nullable Boundary boundary) {
    if (boundary == null) {
      return null;
    }
    Map<String, String> entry = new LinkedHashMap<>();
    entry.put("parameter", boundary.parameter());
    entry.put("passes", boundary.passes());
    entry.put("fails", boundary.fails());
    return entry;
  }
}
