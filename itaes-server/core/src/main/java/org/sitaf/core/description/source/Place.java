package org.sitaf.core.description.source;

import java.util.Objects;

/**
 * Where something stands.
 *
 * @param line from 1; 0 where it is unknown
 * @param element such as {@code method Get/param index}
 */
public record Place(String file, int line, String element) {
  public Place {
    Objects.requireNonNull(file);
    Objects.requireNonNull(element);
  }
}
