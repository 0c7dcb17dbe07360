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

/**
 * Collects required combinations of values that the pre-conditions exclude, to report them as a
 * warning.
 */
final class ImpossibleCombinations {
  private static final int EXAMPLES = 3;

  private final TestModel model;
  private final List<String> examples = new ArrayList<>();
  private long count;

  ImpossibleCombinations(TestModel model) {
    this.model = model;
  }

  /**
   * Adds the impossible tuples of one covering array.
   *
   * @param held index of the parameter that is fixed to one value; -1 if there is none
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

  /** Adds a value that no allowed case contains. */
  void addValue(int parameter, List<List<TestValue>> candidates) {
    count++;
    if (examples.size() < EXAMPLES) {
      examples.add(value(parameter, 0, candidates));
    }
  }

  /** Reports the collected combinations, if there are any. */
  void report(Diagnostics diagnostics) {
    // Without conditions, only related values that no type can hold are missing; RelatedInputs
    // reports these.
    if (count > 0 && !model.preConditions().isEmpty()) {
      diagnostics.warning(
          model.source(),
          0,
          "pre_condition_spec_list",
          count
              + (count == 1 ? " combination" : " combinations")
              + " of values excluded by the pre-conditions"
              + (examples.isEmpty() ? "" : ", such as " + String.join("; ", examples)));
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
