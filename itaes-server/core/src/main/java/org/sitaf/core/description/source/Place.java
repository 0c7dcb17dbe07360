package org.sitaf.core.description.source;

import java.util.Objects;

/**
 * A place in a file.
 *
 * @param line from 1; 0 if unknown
 * @param element the element at this place, such as {@code method Get/param index}
 */
public record Place(String file, int line, String element) {
  public Place {
    Objects.requireNonNull(file);
    Objects.requireNonNull(element);
  }
}
