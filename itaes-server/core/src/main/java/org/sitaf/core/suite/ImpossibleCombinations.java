package org.sitaf.core.suite;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.sitaf.core.combine.CoveringArray;
import org.sitaf.core.combine.CoveringArray.TupleReport;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.value.TestValue;

/** Combinations of values that were asked for and that no allowed case can hold: told, not lost. */
final class ImpossibleCombinations {
  private static final int EXAMPLES = 3;

  private final TestModel model;
  private final List<String> examples = new ArrayList<>();
  private long count;

  ImpossibleCombinations(TestModel model) {
    this.model = model;
  }

  /**
   * Notes what one array could not hold.
   *
   * @param held the parameter that is held at its only value; -1 where none is
   */
  void add(TupleReport tuples, List<List<TestValue>> candidates, int held) {
    count += tuples.impossible();
    for (CoveringArray.Tuple tuple : tuples.examples()) {
      if (examples.size() < EXAMPLES) {
        String values = describe(tuple.parameters(), tuple.values(), candidates);
        examples.add(held < 0 ? values : value(held, 0, candidates) + ", " + values);
      }
    }
  }

  /** No allowed case holds this value of a parameter. */
  void addValue(int parameter, List<List<TestValue>> candidates) {
    count++;
    if (examples.size() < EXAMPLES) {
      examples.add(value(parameter, 0, candidates));
    }
  }

  /** Says what was noted, if anything. */
  void tell(Diagnostics diagnostics) {
    if (count > 0) {
      diagnostics.warning(
          model.source(),
          0,
          "pre_condition_spec_list",
          count
              + (count == 1 ? " combination" : " combinations")
              + " of values that no allowed case can hold, such as "
              + String.join("; ", examples));
    }
  }

  private String describe(int[] parameters, int[] values, List<List<TestValue>> candidates) {
    return IntStream.range(0, parameters.length)
        .mapToObj(i -> value(parameters[i], values[i], candidates))
        .collect(Collectors.joining(", "));
  }

  private String value(int parameter, int index, List<List<TestValue>> candidates) {
    InputElement input = model.inputs().get(parameter);
    return input.name() + "=" + candidates.get(parameter).get(index).value().literal();
  }
}
