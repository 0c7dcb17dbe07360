package org.sitaf.core.flaky;

import java.util.List;
import java.util.Objects;
import java.util.stream.Collectors;
import org.sitaf.core.verdict.Verdict;

/**
 * A case that is not reproducible.
 *
 * @param verdicts of the runs in which it was executed, in their order; that of an earlier result
 *     is the first
 * @param reason why the cause is the cause, such as where the runs diverge
 */
public record FlakyCase(int no, FlakyCause cause, List<Verdict> verdicts, String reason) {
  public FlakyCase {
    Objects.requireNonNull(cause);
    verdicts = List.copyOf(verdicts);
    Objects.requireNonNull(reason);
  }

  /** Whether it failed in any run. */
  public boolean failed() {
    return verdicts.contains(Verdict.FAIL) || verdicts.contains(Verdict.ERROR);
  }

  /** The case in one line, with the history of its verdicts. */
  public String line() {
    return "case "
        + no
        + ": "
        + verdicts.stream().map(Verdict::name).collect(Collectors.joining(" "))
        + "; "
        + cause.words()
        + ": "
        + reason;
  }
}
