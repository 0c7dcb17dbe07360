package org.sitaf.server.web;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.error.RequestException;
import org.springframework.data.domain.Sort;

/**
 * The properties by which a list can be sorted. A request names a property, with a leading minus
 * for descending order: {@code sort=-created}. Items with equal values are sorted by id, so that
 * pages do not overlap.
 */
public final class Sorting {
  /** The default order. */
  public static final String NEWEST_FIRST = "-created";

  private final List<String> properties;

  private Sorting(List<String> properties) {
    this.properties = properties;
  }

  public static Sorting by(String... properties) {
    return new Sorting(List.of(properties));
  }

  /**
   * Parses a request's {@code sort} parameter.
   *
   * @throws RequestException if the property is unknown
   */
  public Sort order(@Nullable String requested) {
    String order = requested == null ? NEWEST_FIRST : requested;
    boolean descending = order.startsWith("-");
    String property = descending ? order.substring(1) : order;
    if (!properties.contains(property)) {
      throw RequestException.malformed(
          "sort must be one of "
              + String.join(", ", properties)
              + ", with a leading minus for descending order, not "
              + order
              + ".");
    }
    Sort sort = Sort.by(property);
    return (descending ? sort.descending() : sort).and(Sort.by("id"));
  }
}
