package org.sitaf.core.verdict;

import java.util.List;
import java.util.Objects;
import org.sitaf.core.suite.SecondRun;

/**
 * The second runs for one relation with their records.
 *
 * @param records at most one for each case
 * @param reasonOfRest why the other cases have no record; empty if all have one
 */
public record ExecutedSecondRun(SecondRun run, List<CaseRecord> records, String reasonOfRest) {
  public ExecutedSecondRun {
    Objects.requireNonNull(run);
    records = List.copyOf(records);
    Objects.requireNonNull(reasonOfRest);
  }
}
