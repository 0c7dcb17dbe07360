package org.sitaf.cli.score;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.score.SpecificationScore;
import org.sitaf.core.score.SpecificationScore.Count;
import org.sitaf.core.score.SpecificationScore.Survivor;
import org.sitaf.core.score.mutation.MutationScore;
import tools.jackson.databind.json.JsonMapper;

/** Writes scores as JSON. */
final class ScoreJson {
  private ScoreJson() {}

  /**
   * Writes the sums of all models. With several models each survivor and output names its model.
   *
   * @param scores by the name of the model
   * @param mutations scores by mutations of the sources; empty if there are none
   */
  static void write(
      Map<String, SpecificationScore> scores, Map<String, MutationScore> mutations, Path file)
      throws IOException {
    int injected = 0;
    int noticed = 0;
    int equivalent = 0;
    List<Map<String, Object>> survivors = new ArrayList<>();
    Map<String, Object> byOutput = new LinkedHashMap<>();
    for (Map.Entry<String, SpecificationScore> each : scores.entrySet()) {
      SpecificationScore score = each.getValue();
      injected += score.injected();
      noticed += score.noticed();
      equivalent += score.equivalent();
      score
          .survivors()
          .forEach(s -> survivors.add(entry(scores.size() > 1 ? each.getKey() : null, s)));
      for (Map.Entry<String, Count> output : score.byOutput().entrySet()) {
        Map<String, Object> entry = new LinkedHashMap<>();
        entry.put("changed", output.getValue().changed());
        entry.put("noticed", output.getValue().noticed());
        byOutput.put(
            scores.size() > 1 ? each.getKey() + "." + output.getKey() : output.getKey(), entry);
      }
    }
    Map<String, Object> document = new LinkedHashMap<>();
    document.put("injected", injected);
    document.put("noticed", noticed);
    document.put("equivalent", equivalent);
    document.put("survivors", survivors);
    document.put("by_output", byOutput);
    if (!mutations.isEmpty()) {
      document.put("mutations", document(mutations));
    }
    Files.writeString(
        file,
        new JsonMapper().writerWithDefaultPrettyPrinter().writeValueAsString(document) + "\n");
  }

  private static Map<String, Object> document(Map<String, MutationScore> mutations) {
    int made = 0;
    int noticed = 0;
    List<Map<String, Object>> survivors = new ArrayList<>();
    List<String> unchanged = new ArrayList<>();
    for (Map.Entry<String, MutationScore> each : mutations.entrySet()) {
      String model = mutations.size() > 1 ? each.getKey() : null;
      made += each.getValue().made();
      noticed += each.getValue().noticed();
      each.getValue().survivors().forEach(s -> survivors.add(entry(model, s)));
      each.getValue().unchanged().forEach(m -> unchanged.add(m.where() + ": " + m.change()));
    }
    Map<String, Object> document = new LinkedHashMap<>();
    document.put("made", made);
    document.put("noticed", noticed);
    document.put("equivalent", unchanged.size());
    document.put("survivors", survivors);
    document.put("without_effect", unchanged);
    return document;
  }

  private static Map<String, Object> entry(@Nullable String model, Survivor survivor) {
    Map<String, Object> entry = new LinkedHashMap<>();
    if (model != null) {
      entry.put("model", model);
    }
    entry.put("fault", survivor.fault());
    entry.put("where", survivor.where());
    entry.put("suggestion", survivor.suggestion());
    return entry;
  }
}
