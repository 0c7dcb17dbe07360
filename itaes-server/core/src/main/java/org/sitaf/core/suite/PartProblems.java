package org.sitaf.core.suite;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.sitaf.core.combine.CombinationProblem;
import org.sitaf.core.combine.Constraint;
import org.sitaf.core.combine.Interaction;
import org.sitaf.core.model.MixedStrength;
import org.sitaf.core.model.Strength;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.value.TestValue;

/** Converts parts of a suite to problems of the Test Data Combinator (TDC), and rows to values. */
final class PartProblems {
  private final TestModel model;
  private final Strength strength;
  private final ConditionConstraints constraints;
  private final RelatedInputs related;
  private final KeptRows kept;

  PartProblems(
      TestModel model,
      Strength strength,
      ConditionConstraints constraints,
      RelatedInputs related,
      KeptRows kept) {
    this.model = model;
    this.strength = strength;
    this.constraints = constraints;
    this.related = related;
    this.kept = kept;
  }

  /** The problem of a part. */
  CombinationProblem problem(CasePart part) {
    int[] levels = part.candidates().stream().mapToInt(List::size).toArray();
    List<Interaction> interactions = interactions(part);
    List<int[]> seeds = new ArrayList<>(kept.seeds(part));
    if ((seeds.isEmpty() && IntStream.of(levels).allMatch(l -> l == 1)) || interactions.isEmpty()) {
      // Nothing varies or no tuples are required: generate any one allowed case.
      seeds.add(IntStream.of(levels).map(l -> CombinationProblem.FREE).toArray());
    }
    List<Constraint> all =
        new ArrayList<>(constraints.constraints(part.candidates(), part.valid()));
    all.addAll(related.constraints(part.candidates()));
    return new CombinationProblem(levels, interactions, all, seeds);
  }

  /** The values of a row, with those that follow another input. */
  List<TestValue> row(int[] row, CasePart part) {
    return related.resolve(
        IntStream.range(0, row.length)
            .mapToObj(p -> part.candidates().get(p).get(row[p]))
            .toList());
  }

  /**
   * The interactions to cover. If a parameter is fixed to an invalid value, the strength among the
   * other parameters is one less.
   */
  private List<Interaction> interactions(CasePart part) {
    List<Interaction> all = new ArrayList<>();
    if (part.single()) {
      return all;
    }
    int held = part.held();
    int[] everything = IntStream.range(0, model.inputs().size()).toArray();
    add(all, strength, everything, held);
    for (MixedStrength mixed : model.mixedStrengths()) {
      int[] group =
          IntStream.range(0, model.inputs().size())
              .filter(i -> mixed.parameters().contains(model.inputs().get(i).name()))
              .toArray();
      if (held < 0 || IntStream.of(group).anyMatch(p -> p == held)) {
        add(all, mixed.strength(), group, held);
      }
    }
    return all;
  }

  private static void add(List<Interaction> all, Strength t, int[] parameters, int held) {
    int[] free = IntStream.of(parameters).filter(p -> p != held).toArray();
    int wanted = Math.min(t.t(), parameters.length) - (held < 0 ? 0 : 1);
    if (wanted > 0 && free.length > 0) {
      all.add(new Interaction(wanted, free));
    }
  }

  /**
   * The number of required tuples of a part. A fixed value without varying parameters is one tuple.
   *
   * @param counted number of tuples that the combinator counts
   */
  static long required(CasePart part, long counted) {
    if (part.single()) {
      return 0;
    }
    boolean alone =
        IntStream.range(0, part.candidates().size())
            .allMatch(p -> p == part.held() || part.candidates().get(p).size() == 1);
    return part.held() >= 0 && (alone || counted == 0) ? 1 : counted;
  }
}
