package org.sitaf.core.trajectory;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.description.fault.FaultName;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.expression.EvaluationException;
import org.sitaf.core.expression.Expression;
import org.sitaf.core.expression.ExpressionCompiler;
import org.sitaf.core.expression.Scope;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.TrajectoryCondition;

/** The trajectory conditions of a model. */
public final class TrajectoryConditions {
  /** The size of a list whose length is not known before the run. */
  public static final int ANY_LENGTH = Integer.MAX_VALUE;

  /** No conditions. */
  public static final TrajectoryConditions NONE = new TrajectoryConditions(List.of());

  /** Maximum number of conditions in a model. */
  private static final int MAX_CONDITIONS = 200;

  /** Maximum number of signals in a message. */
  private static final int MAX_LISTED = 50;

  private static final DataType BOOLEAN = new DataType.Scalar(ScalarType.BOOLEAN);

  private static final DataType LIST =
      new DataType.Sequence(new DataType.Scalar(ScalarType.DOUBLE), 0);

  private static final ExpressionCompiler CONSTANTS = new ExpressionCompiler(List.of());

  private final List<CompiledCondition> conditions;

  private TrajectoryConditions(List<CompiledCondition> conditions) {
    this.conditions = List.copyOf(conditions);
  }

  /**
   * Checks the formulas of a model whose signals are not known.
   *
   * @param longestSeconds limit of the simulation time of a case
   */
  public static void check(TestModel model, double longestSeconds, Diagnostics diagnostics) {
    for (TrajectoryCondition condition : model.trajectoryConditions()) {
      parse(condition, model, longestSeconds, diagnostics);
    }
  }

  /**
   * Compiles the conditions of a model over signals that are numbers.
   *
   * @param signals names of all signals; a name that is two signals is listed twice
   * @param longestSeconds limit of the simulation time of a case
   */
  public static TrajectoryConditions compile(
      TestModel model, Collection<String> signals, double longestSeconds, Diagnostics diagnostics) {
    return compile(model, signals, Map.of(), longestSeconds, diagnostics);
  }

  /**
   * Compiles the conditions of a model. Invalid conditions are reported and omitted.
   *
   * @param signals names of all signals that are numbers; a name that is two signals is listed
   *     twice
   * @param lists sizes of all signals that are lists of numbers, by name; the elements of {@code
   *     list} are the signals {@code list[0]} and so on; {@link #ANY_LENGTH} if it is not known
   * @param longestSeconds limit of the simulation time of a case
   */
  public static TrajectoryConditions compile(
      TestModel model,
      Collection<String> signals,
      Map<String, Integer> lists,
      double longestSeconds,
      Diagnostics diagnostics) {
    List<CompiledCondition> compiled = new ArrayList<>();
    if (model.trajectoryConditions().isEmpty()) {
      return new TrajectoryConditions(compiled);
    }
    if (model.trajectoryConditions().size() > MAX_CONDITIONS) {
      diagnostics.error(
          model.source(),
          0,
          "trajectory_condition_spec_list",
          "has more than " + MAX_CONDITIONS + " conditions");
      return new TrajectoryConditions(compiled);
    }
    Names names = Names.of(model, signals, lists);
    ExpressionCompiler compiler =
        new ExpressionCompiler(
            Scope.of(names.types()).with(model.definitions(), model.constants()));
    for (TrajectoryCondition condition : model.trajectoryConditions()) {
      parse(condition, model, longestSeconds, diagnostics)
          .flatMap(parsed -> compile(condition, parsed, compiler, names, model, diagnostics))
          .ifPresent(compiled::add);
    }
    return new TrajectoryConditions(compiled);
  }

  /** The signals that the conditions use, sorted. */
  public List<String> signals() {
    return conditions.stream().flatMap(c -> c.signals().stream()).distinct().sorted().toList();
  }

  /**
   * The signals that a plot shows, sorted: those that the conditions use, but of a list that a
   * condition uses as a whole the smallest and the largest element.
   */
  public List<String> plotted() {
    return conditions.stream().flatMap(c -> c.plotted().stream()).distinct().sorted().toList();
  }

  /** The signals that a plot shows. */
  public Trace plotted(Trace trace) {
    Map<String, double[]> columns = new HashMap<>(trace.byName());
    conditions.forEach(c -> c.addPlotted(columns, trace.count()));
    List<String> names = plotted();
    return new Trace(
        trace.firstNanos(), trace.stepNanos(), names, names.stream().map(columns::get).toList());
  }

  /** Whether a condition begins with the settling before the call. */
  public boolean needSettling() {
    return conditions.stream().anyMatch(c -> c.condition().fromSettle());
  }

  /** Whether there are none. */
  public boolean isEmpty() {
    return conditions.isEmpty();
  }

  /** The name of each condition that needs more memory for its samples, with the bytes. */
  public Map<String, Long> beyond(long maxBytes, long samples) {
    Map<String, Long> found = new LinkedHashMap<>();
    for (CompiledCondition condition : conditions) {
      long bytes = condition.bytes(samples);
      if (bytes > maxBytes) {
        found.put(condition.condition().name(), bytes);
      }
    }
    return found;
  }

  /** The names of the conditions, in the order of the model. */
  public List<String> names() {
    return conditions.stream().map(c -> c.condition().name()).toList();
  }

  /** Where each condition applies in a trace, in the order of the model. */
  public List<ConditionSpan> spans(Trace trace) {
    return conditions.stream().map(c -> c.span(trace)).toList();
  }

  /**
   * Evaluates one condition.
   *
   * @param index position in {@link #names()}
   * @param inputs values of the inputs for CEL
   * @throws EvaluationException if an atom cannot be evaluated
   */
  public TrajectoryOutcome evaluate(int index, Trace trace, Map<String, Object> inputs)
      throws EvaluationException {
    return conditions.get(index).evaluate(trace, inputs);
  }

  private static Optional<ParsedFormula> parse(
      TrajectoryCondition condition,
      TestModel model,
      double longestSeconds,
      Diagnostics diagnostics) {
    ParsedFormula parsed;
    try {
      parsed = FormulaParser.parse(condition.formula(), TrajectoryConditions::constant);
    } catch (FormulaException e) {
      error(condition, model, e.line(), e.column(), String.valueOf(e.getMessage()), diagnostics);
      return Optional.empty();
    }
    for (ParsedFormula.IntervalText interval : parsed.intervals()) {
      if (interval.interval().from() > longestSeconds) {
        error(
            condition,
            model,
            interval.line(),
            interval.column(),
            "the interval begins at "
                + interval.interval().from()
                + " s, but a case ends after limits.case_sim_s: "
                + longestSeconds,
            diagnostics);
      }
    }
    return Optional.of(parsed);
  }

  private static double constant(String text) {
    try {
      if (CONSTANTS.compile(text).evaluate(Map.of()) instanceof Number number) {
        return number.doubleValue();
      }
      throw new IllegalArgumentException("'" + text + "' is not a number");
    } catch (EvaluationException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  private static Optional<CompiledCondition> compile(
      TrajectoryCondition condition,
      ParsedFormula parsed,
      ExpressionCompiler compiler,
      Names names,
      TestModel model,
      Diagnostics diagnostics) {
    List<CompiledAtom> atoms = new ArrayList<>();
    for (ParsedFormula.AtomText atom : parsed.atoms()) {
      String problem;
      try {
        Expression expression = compiler.compile(atom.text());
        problem = names.problem(expression);
        if (problem.isEmpty()) {
          CompiledAtom compiled = new CompiledAtom(expression, names.signals(), names.lists());
          problem = compiled.problem();
          atoms.add(compiled);
        }
      } catch (IllegalArgumentException e) {
        String message = String.valueOf(e.getMessage());
        problem = message.contains("unknown name") ? message + names.known() : message;
      }
      if (!problem.isEmpty()) {
        error(condition, model, atom.line(), atom.column(), problem, diagnostics);
      }
    }
    return atoms.size() == parsed.atoms().size()
        ? Optional.of(new CompiledCondition(condition, parsed.formula(), atoms))
        : Optional.empty();
  }

  private static void error(
      TrajectoryCondition condition,
      TestModel model,
      int line,
      int column,
      String message,
      Diagnostics diagnostics) {
    diagnostics.error(
        model.source(),
        condition.line() == 0 ? 0 : condition.line() + line - 1,
        "trajectory_condition " + condition.name(),
        "column " + column + " of the formula: " + message);
  }

  /**
   * The names that formulas can use.
   *
   * @param types of signals, inputs and their validity
   * @param signals that are numbers, including the time
   * @param lists sizes of the signals that are lists
   * @param ambiguous names with two meanings
   */
  private record Names(
      Map<String, DataType> types,
      Set<String> signals,
      Map<String, Integer> lists,
      Set<String> ambiguous) {
    static Names of(TestModel model, Collection<String> signals, Map<String, Integer> lists) {
      Map<String, DataType> types = new HashMap<>();
      Set<String> ambiguous = new TreeSet<>();
      List<String> names = model.inputs().stream().map(InputElement::name).toList();
      types.put(Variables.VALID, BOOLEAN);
      for (String name : Variables.roots(names)) {
        types.put(
            Variables.VALID_PREFIX + name,
            names.contains(name) ? BOOLEAN : new DataType.Unknown(""));
      }
      for (String input : Variables.roots(names)) {
        types.put(input, typeOf(input, model));
      }
      names.forEach(name -> FaultName.find(name).ifPresent(fault -> putTimes(fault, types)));
      Set<String> all = new TreeSet<>();
      List<String> given = new ArrayList<>(signals);
      given.add(CompiledCondition.TIME);
      for (String signal : given) {
        if (types.put(signal, new DataType.Scalar(ScalarType.DOUBLE)) != null) {
          ambiguous.add(signal);
        }
        all.add(signal);
      }
      for (String list : lists.keySet()) {
        if (types.put(list, LIST) != null) {
          ambiguous.add(list);
        }
      }
      return new Names(types, all, lists, ambiguous);
    }

    private static void putTimes(FaultName fault, Map<String, DataType> types) {
      DataType seconds = new DataType.Scalar(ScalarType.DOUBLE);
      types.putIfAbsent(fault.fault() + FaultName.Part.AT.suffix(), seconds);
      types.putIfAbsent(fault.fault() + FaultName.Part.FOR.suffix(), seconds);
      types.put(fault.fault() + FaultName.END, seconds);
    }

    private static DataType typeOf(String input, TestModel model) {
      return model.inputs().stream()
          .filter(i -> i.name().equals(input))
          .map(InputElement::type)
          .findFirst()
          .orElse(new DataType.Unknown(""));
    }

    /** What is wrong with the names in an atom; empty if nothing is. */
    String problem(Expression atom) {
      for (String name : atom.variables()) {
        if (ambiguous.contains(name)) {
          return "'" + name + "' is two signals, or a signal and an input; rename one of them";
        }
      }
      return "";
    }

    String known() {
      Set<String> all = new TreeSet<>(signals);
      lists.forEach(
          (list, size) -> all.add(list + "[0] to " + ListElements.element(list, size - 1)));
      String list = all.stream().limit(MAX_LISTED).collect(Collectors.joining(", "));
      int more = all.size() - MAX_LISTED;
      Set<String> inputs = new TreeSet<>(types.keySet());
      inputs.removeAll(signals);
      inputs.removeAll(lists.keySet());
      inputs.removeIf(
          name -> name.equals(Variables.VALID) || name.startsWith(Variables.VALID_PREFIX));
      return "; signals: "
          + list
          + (more > 0 ? " and " + more + " more" : "")
          + "; inputs: "
          + String.join(", ", inputs);
    }
  }
}
