package org.sitaf.cli.score;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sitaf.core.score.SpecificationScore;
import org.sitaf.core.score.SpecificationScore.Count;
import org.sitaf.core.score.SpecificationScore.Survivor;
import tools.jackson.databind.json.JsonMapper;

/** Writes scores as JSON. */
final class ScoreJson {
  private ScoreJson() {}

  /**
   * Writes the sums of all models. With several models each survivor and output names its model.
   *
   * @param scores by the name of the model
   */
  static void write(Map<String, SpecificationScore> scores, Path file) throws IOException {
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
      for (Survivor survivor : score.survivors()) {
        Map<String, Object> entry = new LinkedHashMap<>();
        if (scores.size() > 1) {
          entry.put("model", each.getKey());
        }
        entry.put("fault", survivor.fault());
        entry.put("where", survivor.where());
        entry.put("suggestion", survivor.suggestion());
        survivors.add(entry);
      }
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
    Files.writeString(
        file,
        new JsonMapper().writerWithDefaultPrettyPrinter().writeValueAsString(document) + "\n");
  }
}
