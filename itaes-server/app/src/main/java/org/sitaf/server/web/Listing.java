package org.sitaf.server.web;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import java.util.function.Function;
import org.sitaf.server.refusal.Refusal;
import org.springframework.data.domain.Page;
import org.springframework.data.domain.PageRequest;
import org.springframework.data.domain.Sort;

/**
 * A page of a list.
 *
 * @param page from 0
 * @param size at most {@value #MAX_SIZE}
 * @param total of all pages together
 */
public record Listing<T>(
    List<T> items,
    @Schema(description = "from 0") int page,
    @Schema(description = "at most 500") int size,
    @Schema(description = "of all pages together") long total) {
  /** Largest page that is answered. */
  public static final int MAX_SIZE = 500;

  public Listing {
    items = List.copyOf(items);
  }

  /** A page of what the database holds. */
  public static <E, T> Listing<T> of(Page<E> found, Function<E, T> view) {
    return new Listing<>(
        found.map(view).getContent(), found.getNumber(), found.getSize(), found.getTotalElements());
  }

  /** A page of a list in memory. */
  public static <E, T> Listing<T> of(List<E> all, PageRequest page, Function<E, T> view) {
    return new Listing<>(
        all.stream().skip(page.getOffset()).limit(page.getPageSize()).map(view).toList(),
        page.getPageNumber(),
        page.getPageSize(),
        all.size());
  }

  /**
   * Which page is asked for.
   *
   * @throws Refusal when there can be no such page
   */
  public static PageRequest request(int page, int size, Sort sort) {
    if (page < 0 || size < 1 || size > MAX_SIZE) {
      throw Refusal.malformed(
          "page must be 0 or more and size 1 to "
              + MAX_SIZE
              + ", not "
              + page
              + " and "
              + size
              + ".");
    }
    if ((long) page * size > Integer.MAX_VALUE) {
      throw Refusal.malformed("page " + page + " lies beyond what a list can hold.");
    }
    return PageRequest.of(page, size, sort);
  }
}
