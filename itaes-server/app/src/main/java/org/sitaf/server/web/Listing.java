package org.sitaf.server.web;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import java.util.function.Function;
import org.sitaf.server.error.RequestException;
import org.springframework.data.domain.Page;
import org.springframework.data.domain.PageRequest;
import org.springframework.data.domain.Sort;

/**
 * A page of a list.
 *
 * @param page from 0
 * @param size at most {@value #MAX_SIZE}
 * @param total number of items on all pages
 */
public record Listing<T>(
    List<T> items,
    @Schema(description = "from 0") int page,
    @Schema(description = "at most 500") int size,
    @Schema(description = "number of items on all pages") long total) {
  /** Maximum number of items on a page. */
  public static final int MAX_SIZE = 500;

  public Listing {
    items = List.copyOf(items);
  }

  /** Converts a page of database rows. */
  public static <E, T> Listing<T> of(Page<E> rows, Function<E, T> view) {
    return new Listing<>(
        rows.map(view).getContent(), rows.getNumber(), rows.getSize(), rows.getTotalElements());
  }

  /** Returns a page of a list in memory. */
  public static <E, T> Listing<T> of(List<E> all, PageRequest page, Function<E, T> view) {
    return new Listing<>(
        all.stream().skip(page.getOffset()).limit(page.getPageSize()).map(view).toList(),
        page.getPageNumber(),
        page.getPageSize(),
        all.size());
  }

  /**
   * Validates the parameters of a page request.
   *
   * @throws RequestException if a parameter is out of range
   */
  public static PageRequest request(int page, int size, Sort sort) {
    if (page < 0 || size < 1 || size > MAX_SIZE) {
      throw RequestException.malformed(
          "page must be 0 or more and size 1 to "
              + MAX_SIZE
              + ", not "
              + page
              + " and "
              + size
              + ".");
    }
    if ((long) page * size > Integer.MAX_VALUE) {
      throw RequestException.malformed("page " + page + " is too large.");
    }
    return PageRequest.of(page, size, sort);
  }
}
