package org.sitaf.server.web;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.refusal.Refusal;
import org.springframework.data.domain.Sort;

/**
 * By what a list may be sorted. A request names a property, with a minus before it for the largest
 * first: {@code sort=-created}. Equals follow each other by their ids, so that pages neither
 * overlap nor leave out.
 */
public final class Sorting {
  /** What a list is sorted by when nothing is asked for. */
  public static final String NEWEST_FIRST = "-created";

  private final List<String> properties;

  private Sorting(List<String> properties) {
    this.properties = properties;
  }

  /** Of a list whose items have these properties. */
  public static Sorting by(String... properties) {
    return new Sorting(List.of(properties));
  }

  /**
   * The order that is asked for.
   *
   * @throws Refusal when the items have no such property
   */
  public Sort order(@Nullable String asked) {
    String wanted = asked == null ? NEWEST_FIRST : asked;
    boolean largestFirst = wanted.startsWith("-");
    String property = largestFirst ? wanted.substring(1) : wanted;
    if (!properties.contains(property)) {
      throw Refusal.malformed(
          "sort must be one of "
              + String.join(", ", properties)
              + ", with a minus before it for the largest first, not "
              + wanted
              + ".");
    }
    Sort sort = Sort.by(property);
    return (largestFirst ? sort.descending() : sort).and(Sort.by("id"));
  }
}
