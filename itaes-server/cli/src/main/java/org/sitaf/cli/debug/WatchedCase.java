package org.sitaf.cli.debug;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestCase;

/**
 * A case as its page shows it.
 *
 * @param activity name of the activity
 * @param inputs literals by name of the input, in the order of the model
 */
public record WatchedCase(String activity, String model, int no, Map<String, String> inputs) {
  public WatchedCase {
    Objects.requireNonNull(activity);
    Objects.requireNonNull(model);
    inputs = java.util.Collections.unmodifiableMap(new LinkedHashMap<>(inputs));
  }

  /** A case of a model. */
  public static WatchedCase of(String activity, TestModel model, TestCase watched) {
    Map<String, String> inputs = new LinkedHashMap<>();
    for (int i = 0; i < model.inputs().size(); i++) {
      inputs.put(model.inputs().get(i).name(), watched.values().get(i));
    }
    return new WatchedCase(activity, model.name(), watched.no(), inputs);
  }

  /** The case as JSON of the page. */
  Map<String, Object> document(boolean ended) {
    List<Map<String, String>> values = new ArrayList<>();
    inputs.forEach((name, literal) -> values.add(Map.of("name", name, "literal", literal)));
    return Map.of("activity", activity, "model", model, "no", no, "inputs", values, "ended", ended);
  }
}
