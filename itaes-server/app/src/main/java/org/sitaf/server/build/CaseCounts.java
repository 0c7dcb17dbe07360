package org.sitaf.server.build;

import jakarta.persistence.Embeddable;
import org.sitaf.core.verdict.Summary;

/** Numbers of cases of an accepted result by verdict. */
@Embeddable
public record CaseCounts(
    Integer total, Integer pass, Integer fail, Integer error, Integer dont, Integer unjudged) {
  static CaseCounts of(Summary summary) {
    return new CaseCounts(
        summary.total(),
        summary.pass(),
        summary.fail(),
        summary.error(),
        summary.dont(),
        summary.unjudged());
  }
}
