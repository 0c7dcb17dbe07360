package org.sitaf.core.compare;

import java.util.Map;

/**
 * A case that both versions executed.
 *
 * @param inputs literals by name
 */
public record ComparedCase(String model, int no, Map<String, String> inputs) {
  public ComparedCase {
    inputs = Map.copyOf(inputs);
  }
}
