package org.sitaf.core.explain;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.description.WorldDescription.WorldParameter;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.suite.GivenCases;
import org.sitaf.core.suite.InputValidity;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.value.TestValue;

/** The values of a suite as numbers of levels, and which further cases may be executed. */
final class SuiteValues {
  private static final int MAX_REMEMBERED = 100_000;

  private final TestModel model;
  private final @Nullable WorldDescription world;
  private final InputValidity validity;
  private final GivenCases given;
  private final List<List<Value>> levels = new ArrayList<>();
  private final List<Map<String, Integer>> indices = new ArrayList<>();
  private final List<BitSet> invalidLevels = new ArrayList<>();
  private final int maxInvalid;
  private final int nextNo;
  private final Map<List<Integer>, Boolean> allowed = new HashMap<>();

  SuiteValues(TestModel model, TestSuite suite, @Nullable WorldDescription world) {
    this.model = model;
    this.world = world;
    this.validity = new InputValidity(model, suite.generation().seed());
    this.given = new GivenCases(model);
    for (int i = 0; i < model.inputs().size(); i++) {
      InputElement input = model.inputs().get(i);
      Set<String> literals = new LinkedHashSet<>();
      for (TestCase testCase : suite.cases()) {
        literals.add(testCase.values().get(i));
      }
      List<Value> values = new ArrayList<>(literals.stream().map(input::value).toList());
      values.sort(Comparator.comparingDouble(SuiteValues::number));
      levels.add(values);
      Map<String, Integer> index = new HashMap<>();
      for (int v = 0; v < values.size(); v++) {
        index.put(values.get(v).literal(), v);
      }
      indices.add(index);
      BitSet invalid = new BitSet(values.size());
      for (int v = 0; v < values.size(); v++) {
        invalid.set(v, !isValid(i, values.get(v)));
      }
      invalidLevels.add(invalid);
    }
    int most = 0;
    int highest = 0;
    for (TestCase testCase : suite.cases()) {
      highest = Math.max(highest, testCase.no());
      if (!testCase.valid()) {
        most = Math.max(most, invalid(row(values(testCase))));
      }
    }
    this.maxInvalid = most;
    this.nextNo = highest + 1;
  }

  /** The value as a number; NaN if it is none. */
  static double number(Value value) {
    return value instanceof Value.Whole whole
        ? whole.number().doubleValue()
        : value instanceof Value.Real real ? real.number() : Double.NaN;
  }

  List<Value> values(TestCase testCase) {
    return IntStream.range(0, model.inputs().size())
        .mapToObj(i -> model.inputs().get(i).value(testCase.values().get(i)))
        .toList();
  }

  List<Value> values(int[] row) {
    return IntStream.range(0, row.length).mapToObj(i -> levels.get(i).get(row[i])).toList();
  }

  /** The levels of a case of the suite. */
  int[] levels(TestCase testCase) {
    List<Value> values = values(testCase);
    return IntStream.range(0, values.size())
        .map(i -> indices.get(i).get(values.get(i).literal()))
        .toArray();
  }

  /** The levels of a case; null if it has a value that the suite does not have. */
  int @Nullable [] levelsOf(List<Value> values) {
    int[] row = new int[values.size()];
    for (int i = 0; i < row.length; i++) {
      Integer level = indices.get(i).get(values.get(i).literal());
      if (level == null) {
        return null;
      }
      row[i] = level;
    }
    return row;
  }

  List<Value> levelsOf(int input) {
    return levels.get(input);
  }

  int[] counts() {
    return levels.stream().mapToInt(List::size).toArray();
  }

  boolean isAllowed(int[] row) {
    if (allowed.size() > MAX_REMEMBERED) {
      allowed.clear();
    }
    return allowed.computeIfAbsent(
        Arrays.stream(row).boxed().toList(), r -> isAllowed(values(row)));
  }

  boolean isAllowed(List<Value> values) {
    List<TestValue> row = row(values);
    return invalid(row) <= maxInvalid && given.allows(row);
  }

  /** A case beyond the suite; empty if it may not be executed. */
  Optional<TestCase> testCase(List<Value> values) {
    List<TestValue> row = row(values);
    return invalid(row) <= maxInvalid ? given.ofRow(nextNo, row) : Optional.empty();
  }

  private static int invalid(List<TestValue> row) {
    return (int) row.stream().filter(v -> !v.valid()).count();
  }

  private List<TestValue> row(List<Value> values) {
    return IntStream.range(0, values.size())
        .mapToObj(i -> new TestValue(values.get(i), isValid(i, values.get(i))))
        .toList();
  }

  /** Whether a value of the suite is invalid. */
  boolean isInvalid(int input, int level) {
    return invalidLevels.get(input).get(level);
  }

  boolean isValid(int input, Value value) {
    return validity.isValid(input, value.literal());
  }

  /** The literals of a case by the names of the inputs. */
  Map<String, String> named(List<Value> values) {
    Map<String, String> named = new LinkedHashMap<>();
    for (int i = 0; i < values.size(); i++) {
      named.put(model.inputs().get(i).name(), values.get(i).literal());
    }
    return named;
  }

  /**
   * The simplest valid value of an input: the default of the world, 0, 1, or the simplest of the
   * suite.
   *
   * @param ofSuite whether only values of the suite are considered
   */
  Optional<Value> simplest(int input, boolean ofSuite) {
    InputElement element = model.inputs().get(input);
    List<Value> candidates = new ArrayList<>();
    if (!ofSuite && element.kind() != InputKind.TDTS && isNumber(element)) {
      WorldParameter parameter =
          world == null ? null : world.parameter(element.name()).orElse(null);
      boolean isScale = element.name().startsWith("fault.") && element.name().endsWith(".scale");
      if (element.kind() == InputKind.TDSD && parameter != null) {
        add(element, Double.toString(parameter.defaultValue()), candidates);
      }
      add(element, isScale ? "1" : "0", candidates);
      add(element, "1", candidates);
    }
    levels.get(input).stream()
        .sorted(
            Comparator.comparing((Value v) -> Value.isErrorOrDelay(v.literal()))
                .thenComparingDouble(v -> Double.isNaN(number(v)) ? 0 : Math.abs(number(v)))
                .thenComparingInt(v -> v.literal().length())
                .thenComparing(Value::literal))
        .forEach(candidates::add);
    return candidates.stream().filter(v -> isValid(input, v)).findFirst();
  }

  private static void add(InputElement element, String literal, List<Value> candidates) {
    try {
      candidates.add(element.value(literal));
    } catch (IllegalArgumentException e) {
      // The type cannot hold it.
    }
  }

  /** Whether an input is a number. */
  static boolean isNumber(InputElement element) {
    return element.type() instanceof DataType.Scalar scalar && scalar.type().isNumeric();
  }

  /** Whether a value is a finite number. */
  static boolean isFinite(Value value) {
    return value instanceof Value.Whole whole
        ? whole.number().abs().compareTo(BigInteger.valueOf(Long.MAX_VALUE / 4)) < 0
        : Double.isFinite(number(value));
  }

  InputElement input(int index) {
    return model.inputs().get(index);
  }
}
