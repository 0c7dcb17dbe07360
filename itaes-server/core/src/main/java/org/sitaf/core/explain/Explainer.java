package org.sitaf.core.explain;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.explain.Explanation.Boundary;
import org.sitaf.core.explain.Explanation.Cause;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Verdict;

/** Explains the failures of a suite: relations first, then the smallest tuples of values. */
public final class Explainer {
  private static final int MAX_RELATIONS = 4;

  /** How often a cause is searched again that its simplest case refutes. */
  private static final int MAX_REFUTATIONS = 5;

  /** How often a cause is confirmed again if some failures are not reproducible. */
  private static final int FURTHER_CONFIRMATIONS = 4;

  /** The same if several cases fail now and then. */
  private static final int MORE_CONFIRMATIONS = 8;

  /** So many tuples of the parameters of a relation say that it is not the whole cause. */
  private static final int MAX_OTHER_CAUSES = 1;

  private static final long SEED = 1;

  private final TestModel model;
  private final SuiteValues values;
  private final FurtherCases further;
  private final History history;
  private final List<TestCase> executed = new ArrayList<>();
  private final Map<Integer, CaseResult> results = new HashMap<>();
  private final @Nullable Set<Integer> targets;

  /**
   * An explainer.
   *
   * @param results of the cases of the suite; cases that were not executed are ignored
   * @param world of the activity; null if it has none
   * @param cases numbers of the failed cases to explain; null for all
   * @param budget maximum number of further executions
   */
  public Explainer(
      TestModel model,
      TestSuite suite,
      List<CaseResult> results,
      @Nullable WorldDescription world,
      @Nullable Set<Integer> cases,
      CaseExecution execution,
      int budget) {
    this.model = model;
    this.values = new SuiteValues(model, suite, world);
    this.further = new FurtherCases(values, execution, budget);
    results.forEach(r -> this.results.put(r.no(), r));
    List<Combinations.Row> rows = new ArrayList<>();
    Set<Integer> chosen = new HashSet<>();
    for (TestCase testCase : suite.cases()) {
      CaseResult result = this.results.get(testCase.no());
      if (result == null || result.verdict() == Verdict.DONT) {
        continue;
      }
      if (cases != null && cases.contains(testCase.no())) {
        chosen.add(rows.size());
      }
      rows.add(new Combinations.Row(values.levels(testCase), FurtherCases.outcome(result)));
      executed.add(testCase);
      further.remember(result);
    }
    this.targets = cases == null ? null : chosen;
    int strength = suite.generation().strength().isAll() ? 3 : suite.generation().strength().t();
    this.history =
        new History(
            new Combinations(values.counts(), rows, values::isAllowed, values::isInvalid, strength),
            row ->
                FurtherCases.outcome(
                    further
                        .execute(values.values(row))
                        .orElseThrow(() -> new IllegalStateException("a case is not allowed"))),
            budget);
  }

  /**
   * Searches the causes.
   *
   * @throws InterruptedException if the search is cancelled
   * @throws IllegalStateException if a further case could not be executed
   */
  public Explanation explain() throws InterruptedException {
    if (failed().isEmpty()) {
      return new Explanation(List.of(), 0, List.of());
    }
    Searched searched = search();
    Map<RelationSearch.Relation, Integer> relations = searched.relations();
    TupleSearch search = searched.tuples();
    Map<Tuple, List<Value>> simplest = simplest(search, relations.keySet());
    confirmAgain(search);
    BoundarySearch boundaries = new BoundarySearch(values, history, further);

    List<Cause> causes = new ArrayList<>();
    for (Map.Entry<RelationSearch.Relation, Integer> relation : relations.entrySet()) {
      int before = further.executions();
      Predicate<int[]> holds = relation.getKey().holds();
      List<Value> row =
          simplestOf(
              holds,
              0,
              null,
              v ->
                  search.causes().stream().noneMatch(t -> has(v, t))
                      && relations.keySet().stream()
                          .noneMatch(r -> r != relation.getKey() && has(v, r)));
      int needed = relation.getValue() + further.executions() - before;
      causes.add(cause(Map.of(), relation.getKey().text(), holds, row, null, needed));
    }
    for (Tuple tuple : search.causes()) {
      int before = further.executions();
      List<Value> row = simplest.getOrDefault(tuple, List.of());
      @Nullable Boundary boundary = boundaries.of(tuple, row).orElse(null);
      int needed = search.executionsOf(tuple) + further.executions() - before;
      Map<String, String> parameters = new LinkedHashMap<>();
      int[] levels = tuple.values();
      for (int i = 0; i < levels.length; i++) {
        if (levels[i] != Tuple.ANY) {
          parameters.put(model.inputs().get(i).name(), values.levelsOf(i).get(levels[i]).literal());
        }
      }
      causes.add(cause(parameters, null, tuple::isIn, row, boundary, needed));
    }
    TreeSet<Integer> unexplained = new TreeSet<>();
    for (int i : failed()) {
      if (!search.isExplained(history.combinations().executed().get(i).values())) {
        unexplained.add(executed.get(i).no());
      }
    }
    List<Cause> found = causes.stream().filter(c -> targets == null || explainsTarget(c)).toList();
    return new Explanation(found, further.executions(), List.copyOf(unexplained));
  }

  private boolean explainsTarget(Cause cause) {
    return failed().stream().anyMatch(i -> cause.cases().contains(executed.get(i).no()));
  }

  /** The indices of the failed cases to explain. */
  private List<Integer> failed() {
    List<Combinations.Row> rows = history.combinations().executed();
    return IntStream.range(0, rows.size())
        .filter(i -> rows.get(i).outcome().failed() && (targets == null || targets.contains(i)))
        .boxed()
        .toList();
  }

  private record Searched(Map<RelationSearch.Relation, Integer> relations, TupleSearch tuples) {}

  private Searched search() throws InterruptedException {
    Set<String> rejected = new HashSet<>();
    while (true) {
      history.explainNothing();
      Map<RelationSearch.Relation, Integer> relations = relations(rejected);
      TupleSearch tuples = new TupleSearch(history, targets, SEED);
      tuples.search();
      Set<String> partial = partial(relations.keySet(), tuples);
      if (partial.isEmpty() || history.isExhausted()) {
        return new Searched(relations, tuples);
      }
      rejected.addAll(partial);
    }
  }

  /**
   * The relations next to which several tuples of the same parameters fail: two thresholds, for
   * example, also look like a sum above some value. The tuples tell the cause.
   */
  private static Set<String> partial(Set<RelationSearch.Relation> relations, TupleSearch search) {
    Set<String> partial = new HashSet<>();
    for (RelationSearch.Relation relation : relations) {
      long mask = relation.parameters().stream().mapToLong(p -> 1L << p).sum();
      long others =
          search.causes().stream()
              .filter(t -> Long.bitCount(t.mask()) > 1 && (t.mask() & ~mask) == 0)
              .count();
      if (others > MAX_OTHER_CAUSES) {
        partial.add(relation.text());
      }
    }
    return partial;
  }

  private Map<RelationSearch.Relation, Integer> relations(Set<String> rejected)
      throws InterruptedException {
    List<List<Double>> numbers = new ArrayList<>();
    List<List<String>> literals = new ArrayList<>();
    for (int i = 0; i < model.inputs().size(); i++) {
      numbers.add(values.levelsOf(i).stream().map(SuiteValues::number).toList());
      literals.add(values.levelsOf(i).stream().map(Value::literal).toList());
    }
    RelationSearch search =
        new RelationSearch(
            history,
            model.inputs().stream().map(InputElement::name).toList(),
            numbers,
            literals,
            rejected,
            SEED);
    Map<RelationSearch.Relation, Integer> found = new LinkedHashMap<>();
    while (found.size() < MAX_RELATIONS) {
      Optional<RelationSearch.Confirmed> relation = search.search();
      if (relation.isEmpty()) {
        break;
      }
      found.put(relation.get().relation(), relation.get().executions());
      history.explain(relation.get().relation().holds());
    }
    return found;
  }

  /**
   * The simplest case of each cause. A cause whose simplest case passes is no cause; it is searched
   * again.
   */
  private Map<Tuple, List<Value>> simplest(
      TupleSearch search, Set<RelationSearch.Relation> relations) throws InterruptedException {
    Map<Tuple, List<Value>> simplest = new HashMap<>();
    for (int refuted = 0; refuted <= MAX_REFUTATIONS; refuted++) {
      for (Tuple tuple : search.causes()) {
        if (!simplest.containsKey(tuple)) {
          int before = further.executions();
          List<Value> row =
              simplestOf(
                  tuple::isIn,
                  tuple.mask(),
                  tuple,
                  v ->
                      search.causes().stream().noneMatch(t -> !t.equals(tuple) && has(v, t))
                          && relations.stream().noneMatch(r -> has(v, r)));
          search.needed(tuple, further.executions() - before);
          if (!history.isRefuted(tuple)) {
            simplest.put(tuple, row);
          }
        }
      }
      if (search.causes().stream().noneMatch(history::isRefuted)) {
        break;
      }
      search.search();
    }
    return simplest;
  }

  /**
   * Executes a case of each cause again if equal cases had different verdicts: failures by chance
   * confirm any tuple now and then.
   */
  private void confirmAgain(TupleSearch search) throws InterruptedException {
    for (Tuple tuple : List.copyOf(search.causes())) {
      if (history.failing().stream().noneMatch(f -> history.isFlaky(f.values()))) {
        return;
      }
      int before = history.executions();
      int[] row =
          history.failing().stream()
              .map(Combinations.Row::values)
              .filter(tuple::isIn)
              .findFirst()
              .orElseThrow();
      int times = history.flakyRows() > 1 ? MORE_CONFIRMATIONS : FURTHER_CONFIRMATIONS;
      for (int i = 0; i < times && !history.isExhausted(); i++) {
        if (!history.execute(row).failed()) {
          break;
        }
      }
      search.needed(tuple, history.executions() - before);
    }
    search.removeRefuted();
  }

  /**
   * The simplest failing case that fulfils a condition.
   *
   * @param kept the parameters that keep their values
   * @param tuple the cause; null for a relation
   * @param alone whether a case has no other cause, whose verdict and message it might show; only
   *     such a case is taken if one of them fails
   */
  private List<Value> simplestOf(
      Predicate<int[]> condition, long kept, @Nullable Tuple tuple, Predicate<List<Value>> alone)
      throws InterruptedException {
    List<int[]> rows =
        history.failing().stream()
            .map(Combinations.Row::values)
            .filter(condition)
            .sorted(Comparator.comparingDouble(this::complexity))
            .toList();
    Optional<int[]> own = rows.stream().filter(r -> alone.test(values.values(r))).findFirst();
    int[] start = own.orElse(rows.get(0));
    Predicate<List<Value>> taken =
        row -> values.isAllowed(row) && (own.isEmpty() || alone.test(row));
    long fixed = tuple == null ? fixedOf(start, condition) : kept;
    for (boolean ofSuite : new boolean[] {false, true}) {
      List<Value> row = simplified(values.values(start), fixed, ofSuite, taken);
      if (further.failed(row).isPresent()) {
        return row;
      }
      int[] levels = values.levelsOf(row);
      if (further.isExhausted()) {
        break;
      }
      boolean fails =
          levels == null
              ? further.execute(row).map(r -> FurtherCases.outcome(r).failed()).orElse(false)
              : history.execute(levels).failed();
      if (fails) {
        return row;
      }
    }
    return values.values(start);
  }

  /** The parameters of a relation: those whose change can break it. */
  private long fixedOf(int[] row, Predicate<int[]> holds) {
    long fixed = 0;
    for (int i = 0; i < row.length; i++) {
      for (int level = 0; level < values.levelsOf(i).size(); level++) {
        int[] changed = row.clone();
        changed[i] = level;
        if (!holds.test(changed)) {
          fixed |= 1L << i;
        }
      }
    }
    return fixed;
  }

  private double complexity(int[] row) {
    double sum = 0;
    for (int i = 0; i < row.length; i++) {
      Value value = values.levelsOf(i).get(row[i]);
      double number = SuiteValues.number(value);
      sum +=
          (values.isValid(i, value) ? 0 : 1e9)
              + (Double.isFinite(number) ? Math.min(1e6, Math.abs(number)) : 0)
              + value.literal().length();
    }
    return sum;
  }

  /** Whether a case has the values of a tuple. */
  private boolean has(List<Value> row, Tuple tuple) {
    int[] levels = tuple.values();
    return IntStream.range(0, levels.length)
        .allMatch(
            i -> levels[i] == Tuple.ANY || values.levelsOf(i).get(levels[i]).equals(row.get(i)));
  }

  /** Whether a case fulfils a relation; values that the suite does not have fulfil none. */
  private boolean has(List<Value> row, RelationSearch.Relation relation) {
    int[] levels = new int[row.size()];
    for (int i : relation.parameters()) {
      levels[i] = values.levelsOf(i).indexOf(row.get(i));
      if (levels[i] < 0) {
        return false;
      }
    }
    return relation.holds().test(levels);
  }

  /** The case with the other inputs at their simplest values, as far as a condition allows. */
  private List<Value> simplified(
      List<Value> row, long fixed, boolean ofSuite, Predicate<List<Value>> allowed) {
    List<Value> simple = new ArrayList<>(row);
    for (int i = 0; i < simple.size(); i++) {
      if ((fixed >>> i & 1) == 0) {
        int at = i;
        values.simplest(i, ofSuite).ifPresent(v -> simple.set(at, v));
      }
    }
    if (allowed.test(simple)) {
      return simple;
    }
    List<Value> current = new ArrayList<>(row);
    for (int i = 0; i < current.size(); i++) {
      if ((fixed >>> i & 1) == 0) {
        Value before = current.get(i);
        int at = i;
        values.simplest(i, ofSuite).ifPresent(v -> current.set(at, v));
        if (!allowed.test(current)) {
          current.set(i, before);
        }
      }
    }
    return current;
  }

  private Cause cause(
      Map<String, String> parameters,
      @Nullable String relation,
      Predicate<int[]> condition,
      List<Value> simplest,
      @Nullable Boundary boundary,
      int executions) {
    List<Integer> numbers = new ArrayList<>();
    List<Combinations.Row> rows = history.combinations().executed();
    for (int i = 0; i < rows.size(); i++) {
      if (rows.get(i).outcome().failed() && condition.test(rows.get(i).values())) {
        numbers.add(executed.get(i).no());
      }
    }
    CaseResult result =
        further
            .failed(simplest)
            .orElseGet(() -> numbers.isEmpty() ? null : results.get(numbers.get(0)));
    return new Cause(
        parameters,
        relation,
        result == null ? Verdict.FAIL : result.verdict(),
        result == null ? "" : result.message(),
        numbers,
        values.named(simplest),
        boundary,
        executions);
  }
}
