package org.sitaf.server.build;

import jakarta.persistence.Embeddable;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.verdict.Summary;

/**
 * Numbers of cases of an accepted result by verdict.
 *
 * @param byError null for builds of earlier releases
 */
@Embeddable
public record CaseCounts(
    Integer total,
    Integer pass,
    Integer fail,
    Integer error,
    Integer dont,
    Integer unjudged,
    @Nullable Integer byError) {
  static CaseCounts of(Summary summary) {
    return new CaseCounts(
        summary.total(),
        summary.pass(),
        summary.fail(),
        summary.error(),
        summary.dont(),
        summary.unjudged(),
        summary.byError());
  }
}
