package org.sitaf.core.score;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.score.fault.Condition;
import org.sitaf.core.suite.GivenCases;
import org.sitaf.core.suite.InputValidity;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.value.TestValue;
import org.sitaf.core.verdict.Literals;

/**
 * Cases beyond the suite, and the conditions under which faults occur. They show which faults a
 * suite misses because it never reaches them: without them such a fault would seem to have no
 * effect.
 */
public final class Probes {
  private static final int MAX_PAIRS = 30;
  private static final int MAX_CONDITIONS = 200;
  private static final int ATTEMPTS = 20;

  private final TestModel model;
  private final InputValidity validity;
  private final GivenCases given;
  private final List<List<String>> values = new ArrayList<>();
  private final List<String> centre;
  private final boolean combinesInvalid;
  private final Random random = new Random(1);

  /**
   * The probes of a suite.
   *
   * @param suite of single calls
   * @param world of the activity; null if it has none
   */
  public Probes(TestModel model, TestSuite suite, @Nullable WorldDescription world) {
    this.model = model;
    this.validity = new InputValidity(model, suite.generation().seed());
    this.given = new GivenCases(model);
    for (int i = 0; i < model.inputs().size(); i++) {
      int index = i;
      Set<String> used =
          suite.cases().stream()
              .map(c -> c.values().get(index))
              .collect(Collectors.toCollection(LinkedHashSet::new));
      values.add(ProbeValues.of(model.inputs().get(i), world, used));
    }
    this.centre =
        suite.cases().stream()
            .filter(TestCase::valid)
            .findFirst()
            .or(() -> suite.cases().stream().findFirst())
            .map(TestCase::values)
            .orElse(List.of());
    this.combinesInvalid =
        suite.cases().stream().anyMatch(c -> !c.valid() && invalid(c.values()) > 1);
  }

  /** A simple valid value of each input. */
  public List<String> simplest() {
    List<String> simplest = new ArrayList<>();
    for (int i = 0; i < centre.size(); i++) {
      int index = i;
      simplest.add(
          values.get(i).stream()
              .filter(v -> validity.isValid(index, v))
              .min(java.util.Comparator.comparingDouble(Probes::size).thenComparing(v -> v))
              .orElse(centre.get(i)));
    }
    return simplest;
  }

  private static double size(String literal) {
    return Literals.isReal(literal) ? Math.abs(Literals.real(literal)) : literal.length();
  }

  /**
   * Different rows that the pre-conditions allow: each value once, then combinations of all values.
   */
  List<List<String>> rows(int max) {
    Set<List<String>> rows = new LinkedHashSet<>();
    for (int i = 0; i < values.size(); i++) {
      for (String value : values.get(i)) {
        List<String> row = new ArrayList<>(centre);
        row.set(i, value);
        reachable(row, i).ifPresent(rows::add);
      }
    }
    for (int attempt = 0;
        attempt < max * ATTEMPTS && rows.size() < max && !values.isEmpty();
        attempt++) {
      List<String> row = combined();
      if (isAllowed(row)) {
        rows.add(List.copyOf(row));
      }
    }
    return rows.stream().limit(max).toList();
  }

  /** The row, or one with other values of the other inputs, that the pre-conditions allow. */
  private Optional<List<String>> reachable(List<String> row, int kept) {
    List<String> candidate = row;
    for (int attempt = 0; attempt < ATTEMPTS; attempt++) {
      if (isAllowed(candidate)) {
        return Optional.of(List.copyOf(candidate));
      }
      candidate = combined();
      candidate.set(kept, row.get(kept));
    }
    return Optional.empty();
  }

  private List<String> combined() {
    return IntStream.range(0, values.size())
        .mapToObj(
            i ->
                values.get(i).isEmpty()
                    ? centre.get(i)
                    : values.get(i).get(random.nextInt(values.get(i).size())))
        .collect(Collectors.toCollection(ArrayList::new));
  }

  private boolean isAllowed(List<String> row) {
    if (!combinesInvalid && invalid(row) > 1) {
      return false;
    }
    return given.allows(
        IntStream.range(0, row.size())
            .mapToObj(
                i ->
                    new TestValue(
                        model.inputs().get(i).value(row.get(i)), validity.isValid(i, row.get(i))))
            .toList());
  }

  private int invalid(List<String> row) {
    return (int)
        IntStream.range(0, row.size()).filter(i -> !validity.isValid(i, row.get(i))).count();
  }

  /** Whether all values of a row are valid. */
  boolean isValid(List<String> row) {
    return invalid(row) == 0;
  }

  /** Conditions over one input, over the order of two inputs, and over pairs of valid values. */
  public List<Condition> conditions() {
    List<Condition> conditions = new ArrayList<>();
    for (int i = 0; i < values.size(); i++) {
      for (String value : values.get(i)) {
        conditions.add(is(i, value));
      }
      for (int other = 0; other < i; other++) {
        if (isNumber(model.inputs().get(i))
            && model.inputs().get(i).type().equals(model.inputs().get(other).type())) {
          conditions.addAll(ordered(other, i));
        }
      }
    }
    List<Condition> pairs = new ArrayList<>();
    for (int i = 0; i < values.size(); i++) {
      for (int other = 0; other < i; other++) {
        pairs.addAll(pairs(other, i));
      }
    }
    java.util.Collections.shuffle(pairs, random);
    conditions.addAll(pairs.subList(0, Math.min(MAX_PAIRS, pairs.size())));
    return conditions.subList(0, Math.min(MAX_CONDITIONS, conditions.size()));
  }

  private List<Condition> pairs(int one, int other) {
    List<Condition> pairs = new ArrayList<>();
    for (String first : values.get(one)) {
      for (String second : values.get(other)) {
        if (validity.isValid(one, first) && validity.isValid(other, second)) {
          Condition left = is(one, first);
          Condition right = is(other, second);
          pairs.add(
              new Condition(
                  left.text() + " and " + right.text().substring("where ".length()),
                  false,
                  left.holds().and(right.holds())));
        }
      }
    }
    return pairs;
  }

  private Condition is(int input, String value) {
    return new Condition(
        "where " + model.inputs().get(input).name() + " is " + value,
        true,
        row -> row.get(input).equals(value));
  }

  private List<Condition> ordered(int one, int other) {
    String first = "where " + model.inputs().get(one).name();
    String second = model.inputs().get(other).name();
    return List.of(
        new Condition(first + " < " + second, true, row -> compare(row, one, other) < 0),
        new Condition(first + " == " + second, true, row -> compare(row, one, other) == 0),
        new Condition(first + " > " + second, true, row -> compare(row, one, other) > 0));
  }

  private static double compare(List<String> row, int one, int other) {
    return Literals.isReal(row.get(one)) && Literals.isReal(row.get(other))
        ? Literals.real(row.get(one)) - Literals.real(row.get(other))
        : Double.NaN;
  }

  private static boolean isNumber(InputElement input) {
    return input.type() instanceof DataType.Scalar scalar && scalar.type().isNumeric();
  }
}
