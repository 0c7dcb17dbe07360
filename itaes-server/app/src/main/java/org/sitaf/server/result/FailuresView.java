package org.sitaf.server.result;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.FailureGroup;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

/** What failed in a result, in groups, and since which build. */
@Schema(name = "ResultFailures")
record FailuresView(
    @Schema(
            description =
                "cases whose verdict is not PASS, by verdict and message, the largest group first"
                    + " and at most 20")
        List<Group> groups,
    @Schema(description = "number of groups that are not listed") int leftOut,
    @Schema(description = "number of the first case with FAIL or ERROR; absent if there is none")
        @Nullable Integer firstFailing,
    @Schema(
            description =
                "the result before, of the same activity and test model with all cases; absent if"
                    + " there is none")
        @Nullable Before before,
    @Schema(
            description =
                "the oldest of the results up to this one that all have a case with FAIL or ERROR;"
                    + " absent if nothing failed")
        @Nullable Since since) {
  private static final int MAX_GROUPS = 20;
  private static final int MAX_NUMBERS = 20;
  private static final int MAX_MESSAGE = 2000;

  @Schema(name = "FailureGroup")
  record Group(
      Verdict verdict,
      @Schema(description = "of the first case") String message,
      @Schema(
              description =
                  "whether the messages of all its cases are equal; otherwise numbers differ")
          boolean uniform,
      @Schema(description = "number of cases") int cases,
      @Schema(description = "numbers of the first cases, at most 20") List<Integer> numbers,
      @Schema(
              description =
                  "number of cases that passed in the result before; absent if there is none")
          @Nullable Integer newlyFailing) {}

  @Schema(name = "ResultBefore")
  record Before(
      String buildId,
      Instant received,
      @Nullable String commit,
      @Schema(description = "number of cases that passed then and fail now") int newlyFailing,
      @Schema(description = "number of cases that fail in both results") int stillFailing,
      @Schema(description = "number of cases that failed then and pass now") int fixed) {}

  @Schema(name = "FailingSince")
  record Since(
      String buildId,
      Instant received,
      @Nullable String commit,
      @Schema(description = "number of results, this one included") int results,
      @Schema(
              description =
                  "whether an older result passed; otherwise all results that were looked at fail")
          boolean passedBefore) {}

  /**
   * An earlier result of the same activity and model.
   *
   * @param failed whether a case has FAIL or ERROR
   */
  record Earlier(String buildId, Instant received, @Nullable String commit, boolean failed) {}

  /**
   * Describes what failed.
   *
   * @param self this result as a row of the history
   * @param earlier earlier results, newest first
   * @param before the result of the first of them; null if there is none
   */
  static FailuresView of(
      TestResult now, Earlier self, List<Earlier> earlier, @Nullable TestResult before) {
    Map<List<String>, Verdict> old = new HashMap<>();
    if (before != null) {
      before.cases().forEach(c -> old.put(c.values(), c.verdict()));
    }
    List<FailureGroup> groups =
        FailureGroup.of(now.cases()).stream()
            .sorted((a, b) -> Integer.compare(b.cases().size(), a.cases().size()))
            .toList();
    return new FailuresView(
        groups.stream()
            .limit(MAX_GROUPS)
            .map(group -> view(group, before == null ? null : old))
            .toList(),
        Math.max(0, groups.size() - MAX_GROUPS),
        now.cases().stream()
            .filter(c -> isFailure(c.verdict()))
            .map(CaseResult::no)
            .findFirst()
            .orElse(null),
        before == null ? null : before(now, earlier.get(0), old),
        self.failed() ? since(self, earlier) : null);
  }

  private static Group view(FailureGroup group, @Nullable Map<List<String>, Verdict> old) {
    String message = group.message();
    return new Group(
        group.verdict(),
        message.length() <= MAX_MESSAGE ? message : message.substring(0, MAX_MESSAGE) + "…",
        group.isUniform(),
        group.cases().size(),
        group.cases().stream().limit(MAX_NUMBERS).map(CaseResult::no).toList(),
        old == null
            ? null
            : (int)
                group.cases().stream().filter(c -> old.get(c.values()) == Verdict.PASS).count());
  }

  private static Before before(TestResult now, Earlier earlier, Map<List<String>, Verdict> old) {
    int newlyFailing = 0;
    int stillFailing = 0;
    int fixed = 0;
    for (CaseResult result : now.cases()) {
      Verdict then = old.get(result.values());
      if (then == null) {
        continue;
      }
      if (isFailure(result.verdict())) {
        if (isFailure(then)) {
          stillFailing++;
        } else if (then == Verdict.PASS) {
          newlyFailing++;
        }
      } else if (isFailure(then) && result.verdict() == Verdict.PASS) {
        fixed++;
      }
    }
    return new Before(
        earlier.buildId(), earlier.received(), earlier.commit(), newlyFailing, stillFailing, fixed);
  }

  private static Since since(Earlier self, List<Earlier> earlier) {
    Earlier first = self;
    int results = 1;
    for (Earlier result : earlier) {
      if (!result.failed()) {
        return new Since(first.buildId(), first.received(), first.commit(), results, true);
      }
      first = result;
      results++;
    }
    return new Since(first.buildId(), first.received(), first.commit(), results, false);
  }

  private static boolean isFailure(Verdict verdict) {
    return verdict == Verdict.FAIL || verdict == Verdict.ERROR;
  }
}
