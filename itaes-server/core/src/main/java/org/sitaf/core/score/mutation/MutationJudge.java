package org.sitaf.core.score.mutation;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sitaf.core.compare.RecordedValues;
import org.sitaf.core.score.SpecificationScore.Survivor;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

/** Compares the results of mutated components with that of the component as it is. */
public final class MutationJudge {
  private final Map<Integer, CaseResult> originals = new HashMap<>();
  private final List<Mutation> unchanged = new ArrayList<>();
  private final List<Survivor> survivors = new ArrayList<>();
  private int noticed;

  /** Begins with the result of the component as it is. */
  public MutationJudge(TestResult original) {
    original.cases().forEach(c -> originals.put(c.no(), c));
  }

  /** Whether a case notices a mutation: it passes without it, and did not pass with it. */
  public boolean notices(CaseResult mutated) {
    CaseResult original = originals.get(mutated.no());
    return original != null
        && original.verdict() == Verdict.PASS
        && (mutated.verdict() == Verdict.FAIL || mutated.verdict() == Verdict.ERROR);
  }

  /** Counts a mutation that a case noticed, whatever other cases would have shown. */
  public void addNoticed() {
    noticed++;
  }

  /** Counts a mutation by its result. */
  public void add(Mutation mutation, TestResult result) {
    if (result.cases().stream().anyMatch(this::notices) || result.isSuspect()) {
      noticed++;
      return;
    }
    Optional<CaseResult> changed =
        result.cases().stream()
            .filter(c -> originals.containsKey(c.no()) && c.verdict() != Verdict.DONT)
            .filter(c -> !RecordedValues.of(c).equals(RecordedValues.of(originals.get(c.no()))))
            // A case that passes without the mutation tells what its specification lacks.
            .min(Comparator.comparing(c -> originals.get(c.no()).verdict() != Verdict.PASS));
    if (changed.isEmpty()) {
      unchanged.add(mutation);
    } else {
      survivors.add(
          new Survivor(
              mutation.where() + ": " + mutation.change(),
              mutation.where(),
              suggestion(originals.get(changed.get().no()), changed.get())));
    }
  }

  private static String suggestion(CaseResult original, CaseResult mutated) {
    String no = "case " + original.no() + ": ";
    if (original.verdict() != Verdict.PASS) {
      return no + "does not pass without the change either";
    }
    for (int i = 0; i < Math.min(original.actual().size(), mutated.actual().size()); i++) {
      NamedValue before = original.actual().get(i);
      NamedValue now = mutated.actual().get(i);
      if (!before.equals(now)) {
        String name = before.output().isEmpty() ? "return" : before.output();
        return no
            + name
            + " is "
            + now.literal()
            + " instead of "
            + before.literal()
            + "; expect its value, or narrow its tolerance";
      }
    }
    if (!original.calls().equals(mutated.calls())) {
      return no + "the calls of required interfaces differ; expect them";
    }
    return no + "the values of its steps differ; expect them";
  }

  /** The score of all mutations so far. */
  public MutationScore score() {
    return new MutationScore(
        noticed + unchanged.size() + survivors.size(),
        noticed,
        unchanged.stream()
            .sorted(Comparator.comparing(Mutation::path).thenComparingInt(Mutation::start))
            .toList(),
        survivors);
  }
}
