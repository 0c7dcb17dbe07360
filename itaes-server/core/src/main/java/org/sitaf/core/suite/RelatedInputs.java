package org.sitaf.core.suite;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.combine.Constraint;
import org.sitaf.core.combine.Interruption;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.value.RelatedValue;
import org.sitaf.core.value.TestData;
import org.sitaf.core.value.TestValue;

/**
 * Inputs whose values follow another input of the same case. They are combined by their offsets;
 * rows and conditions see the resolved values.
 */
final class RelatedInputs {
  private static final int EXAMPLES = 3;

  private final TestModel model;
  private final Map<String, Integer> indices = new HashMap<>();

  /** For each input, the inputs that its values follow, in ascending order. */
  private final List<TreeSet<Integer>> followed = new ArrayList<>();

  RelatedInputs(TestModel model, List<TestData> data) {
    this.model = model;
    for (int p = 0; p < model.inputs().size(); p++) {
      indices.put(model.inputs().get(p).name(), p);
    }
    for (TestData values : data) {
      TreeSet<Integer> direct = new TreeSet<>();
      for (TestValue value : values.values()) {
        if (value.relation() != null) {
          direct.add(indices.get(value.relation().to()));
        }
      }
      followed.add(direct);
    }
  }

  /** The given inputs and all inputs that they follow, in ascending order. */
  int[] withFollowed(int... inputs) {
    TreeSet<Integer> all = new TreeSet<>();
    for (int input : inputs) {
      add(input, all);
    }
    return all.stream().mapToInt(Integer::intValue).toArray();
  }

  private void add(int input, TreeSet<Integer> all) {
    if (all.add(input)) {
      followed.get(input).forEach(to -> add(to, all));
    }
  }

  /** The values of a row; those that follow another input are computed. */
  List<TestValue> resolve(List<TestValue> row) {
    if (row.stream().allMatch(value -> value.relation() == null)) {
      return row;
    }
    return IntStream.range(0, row.size())
        .mapToObj(
            p ->
                row.get(p).relation() == null
                    ? row.get(p)
                    : new TestValue(resolve(p, row::get).orElseThrow(), true))
        .toList();
  }

  /**
   * The value of an input in a case.
   *
   * @param values the case; asked for the input and those that it follows
   * @return empty if the type cannot hold the value
   */
  Optional<Value> resolve(int input, IntFunction<TestValue> values) {
    TestValue value = values.apply(input);
    if (value.relation() == null) {
      return Optional.of(value.value());
    }
    InputElement to = model.inputs().get(indices.get(value.relation().to()));
    return resolve(indices.get(to.name()), values)
        .flatMap(
            base -> {
              try {
                return Optional.of(RelatedValue.of(to, base, value.relation().offset()));
              } catch (IllegalArgumentException e) {
                return Optional.empty();
              }
            });
  }

  /** Constraints that exclude rows with a value that its type cannot hold. */
  List<Constraint> constraints(List<List<TestValue>> candidates) {
    List<Constraint> constraints = new ArrayList<>();
    for (int p = 0; p < candidates.size(); p++) {
      if (!followed.get(p).isEmpty()) {
        int input = p;
        int[] inputs = withFollowed(p);
        Constraint constraint =
            new Constraint(
                inputs, tuple -> resolve(input, at(inputs, tuple, candidates)).isPresent());
        if (excludesAny(constraint, candidates)) {
          constraints.add(constraint);
        }
      }
    }
    return constraints;
  }

  static IntFunction<TestValue> at(int[] inputs, int[] tuple, List<List<TestValue>> candidates) {
    return p -> {
      for (int i = 0; i < inputs.length; i++) {
        if (inputs[i] == p) {
          return candidates.get(p).get(tuple[i]);
        }
      }
      throw new IllegalArgumentException("no value for input " + p);
    };
  }

  /** Reports offsets that are skipped because the type cannot hold the result. */
  void report(List<TestData> data, Diagnostics diagnostics) {
    List<List<TestValue>> all = data.stream().map(TestData::values).toList();
    for (int p = 0; p < all.size(); p++) {
      if (followed.get(p).isEmpty()) {
        continue;
      }
      int[] inputs = withFollowed(p);
      long count = 0;
      List<String> examples = new ArrayList<>();
      int[] tuple = isSmall(inputs, all) ? new int[inputs.length] : null;
      while (tuple != null) {
        Interruption.check();
        IntFunction<TestValue> values = at(inputs, tuple, all);
        if (resolve(p, values).isEmpty()) {
          count++;
          if (examples.size() < EXAMPLES) {
            int to = indices.get(java.util.Objects.requireNonNull(values.apply(p).relation()).to());
            examples.add(
                values.apply(p).value().literal()
                    + " where "
                    + model.inputs().get(to).name()
                    + " is "
                    + resolve(to, values).map(Value::literal).orElse("skipped"));
          }
        }
        tuple = next(tuple, inputs, all);
      }
      if (count > 0) {
        InputElement input = model.inputs().get(p);
        diagnostics.warning(
            model.source(),
            input.line(),
            "test_element " + input.name(),
            count
                + (count == 1 ? " related value is" : " related values are")
                + " skipped, since "
                + input.realType()
                + " cannot represent the result: "
                + String.join("; ", examples));
      }
    }
  }

  private static boolean excludesAny(Constraint constraint, List<List<TestValue>> candidates) {
    int[] inputs = constraint.parameters();
    if (!isSmall(inputs, candidates)) {
      return true;
    }
    int[] tuple = new int[inputs.length];
    while (tuple != null) {
      Interruption.check();
      if (!constraint.allowed().test(tuple)) {
        return true;
      }
      tuple = next(tuple, inputs, candidates);
    }
    return false;
  }

  private static boolean isSmall(int[] inputs, List<List<TestValue>> candidates) {
    double tuples = 1;
    for (int p : inputs) {
      tuples *= candidates.get(p).size();
    }
    return tuples <= Constraint.MAX_TABLE;
  }

  private static int @Nullable [] next(
      int[] tuple, int[] inputs, List<List<TestValue>> candidates) {
    for (int i = tuple.length - 1; i >= 0; i--) {
      if (++tuple[i] < candidates.get(inputs[i]).size()) {
        return tuple;
      }
      tuple[i] = 0;
    }
    return null;
  }
}
