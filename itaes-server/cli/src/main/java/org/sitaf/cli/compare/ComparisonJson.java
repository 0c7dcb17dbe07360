package org.sitaf.cli.compare;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.compare.Comparison;
import org.sitaf.core.compare.Difference;
import org.sitaf.core.compare.DifferenceGroup;
import tools.jackson.databind.json.JsonMapper;

/** Writes a comparison as JSON (docs/compare.md). */
final class ComparisonJson {
  private ComparisonJson() {}

  static String write(Comparison comparison) {
    Map<String, Object> root = new LinkedHashMap<>();
    root.put("cases", comparison.cases().size());
    root.put("differences", entries(comparison.differences()));
    root.put("groups", comparison.groups().stream().map(ComparisonJson::group).toList());
    root.put("last_bits", entries(comparison.lastBits()));
    root.put("unstable", entries(comparison.unstable()));
    root.put("slower", entries(comparison.slower()));
    root.put(
        "not_comparable",
        comparison.notComparable().stream()
            .map(
                n -> {
                  Map<String, Object> entry = new LinkedHashMap<>();
                  entry.put("model", n.model());
                  entry.put("no", n.no());
                  entry.put("output", n.output());
                  entry.put("reason", n.reason());
                  return entry;
                })
            .toList());
    return new JsonMapper().writerWithDefaultPrettyPrinter().writeValueAsString(root) + "\n";
  }

  private static List<Map<String, @Nullable Object>> entries(List<Difference> differences) {
    return differences.stream().map(ComparisonJson::entry).toList();
  }

  private static Map<String, @Nullable Object> entry(Difference difference) {
    Map<String, @Nullable Object> entry = new LinkedHashMap<>();
    entry.put("model", difference.model());
    entry.put("no", difference.no());
    entry.put("valid", difference.valid());
    entry.put("class", difference.kind().id());
    entry.put("output", difference.output());
    entry.put("inputs", difference.inputs());
    entry.put("base", difference.base());
    entry.put("new", difference.now());
    entry.put("at_s", difference.at());
    Difference.Step step = difference.step();
    if (step != null) {
      entry.put("step", step.number());
      entry.put("call", step.call());
    }
    return entry;
  }

  private static Map<String, Object> group(DifferenceGroup group) {
    Map<String, Object> entry = new LinkedHashMap<>();
    entry.put("text", group.text());
    entry.put("class", group.kind().id());
    entry.put("output", group.output());
    entry.put(
        "cases",
        group.differences().stream().map(d -> Map.of("model", d.model(), "no", d.no())).toList());
    return entry;
  }
}
