package org.sitaf.core.suite.sequence;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.sitaf.core.combine.Progress;
import org.sitaf.core.combine.TooManyCombinationsException;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.Strength;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.sequence.CoveringWords;
import org.sitaf.core.sequence.Machine;
import org.sitaf.core.sequence.array.TupleSpace;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.Conditions;
import org.sitaf.core.suite.GeneratedSuite;
import org.sitaf.core.suite.Generation;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.GeneratorVersion;
import org.sitaf.core.suite.StepParameters;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;

/**
 * Generates the suite of a model with a sequence: all allowed t-tuples of steps, all valid rows of
 * each call and of the initial values in valid cases; then forbidden calls and invalid rows.
 */
public final class SequenceGenerator {
  private static final int MAX_CASES = 1_000_000;
  private static final int MAX_LISTED = 10;

  private final TestModel model;
  private final SequenceSpec sequence;
  private final GenerationOptions options;
  private final Progress progress;
  private final Diagnostics diagnostics = new Diagnostics();

  private SequenceGenerator(TestModel model, GenerationOptions options, Progress progress) {
    this.model = model;
    this.sequence = Objects.requireNonNull(model.sequence());
    this.options = options;
    this.progress = progress;
  }

  /**
   * Generates the suite. The same model and options give the same cases.
   *
   * @throws InvalidInputException if the model is contradictory or the suite would be too large
   * @throws java.util.concurrent.CancellationException if the thread is interrupted
   */
  public static GeneratedSuite generate(
      TestModel model, GenerationOptions options, Progress progress) {
    return new SequenceGenerator(model, options, progress).generate();
  }

  private GeneratedSuite generate() {
    if (options.maxCases() != null) {
      throw problem(
          "does not support a maximum number of cases; reduce order or increase length for fewer"
              + " cases");
    }
    Conditions.compile(model, diagnostics);
    diagnostics.throwIfErrors();
    GenerationOptions ofRows =
        new GenerationOptions(
            options.strength(), options.invalidValues(), options.seed(), options.effort());
    SequenceVerification.Explored explored =
        SequenceVerification.explore(model, ofRows, diagnostics);
    diagnostics.throwIfErrors();
    List<PlannedCase> cases;
    try {
      cases = plan(Objects.requireNonNull(explored), ofRows);
    } catch (IllegalStateException | TooManyCombinationsException e) {
      throw problem(String.valueOf(e.getMessage()));
    }
    diagnostics.throwIfErrors();
    return new GeneratedSuite(
        suite(new CaseWriter(model, explored.steps(), explored.variables(), diagnostics), cases),
        diagnostics.all());
  }

  private InvalidInputException problem(String message) {
    return new InvalidInputException(
        List.of(Diagnostic.error(model.source(), sequence.line(), "sequence_spec", message)));
  }

  private List<PlannedCase> plan(SequenceVerification.Explored explored, GenerationOptions ofRows) {
    Machine machine = explored.space().machine();
    TupleSpace tuples = new TupleSpace(explored.steps().size(), sequence.order());
    CoveringWords words = new CoveringWords(machine, tuples, sequence.length(), sequence.repeat());
    BitSet allowed = words.allowed();
    reportForbidden(tuples, allowed);
    RowAssignment assignment =
        new RowAssignment(explored.space(), explored.rows(), sequence.length(), sequence.repeat());
    KeptSequences kept = new KeptSequences(model, options.earlier(), explored, diagnostics);
    List<PlannedCase> given = kept.cases();
    BitSet required = (BitSet) allowed.clone();
    List<PlannedCase> cases = new ArrayList<>();
    for (PlannedCase planned : given) {
      if (planned.isValid()) {
        assignment.use(planned);
        CoveringWords.remove(required, tuples, planned.kinds());
      }
    }
    for (int[] word : words.cover(required, options.effort(), options.seed(), progress)) {
      cases.add(assignment.assign(word));
    }
    assignment.complete(cases, words);
    initialRows(given, cases, ofRows);
    invalid(explored, given, cases);
    List<PlannedCase> all = new ArrayList<>(given);
    all.addAll(cases);
    if (all.isEmpty()) {
      throw problem("no sequence of at most " + sequence.length() + " steps is allowed");
    }
    if (all.size() > MAX_CASES) {
      throw problem(
          String.format(
              Locale.ROOT,
              "results in %,d cases, but at most %,d can be generated; reduce order or the number"
                  + " of values",
              all.size(),
              MAX_CASES));
    }
    return all;
  }

  /** Every initial row starts a case; cases are repeated if there are too few. */
  private void initialRows(
      List<PlannedCase> given, List<PlannedCase> cases, GenerationOptions ofRows) {
    StepRows rows = StepRows.of(model, Set.of(), ofRows, diagnostics);
    Set<StepRow> started = given.stream().map(PlannedCase::initial).collect(Collectors.toSet());
    List<StepRow> missing =
        rows.valid().stream()
            .filter(r -> model.inputs().isEmpty() || !started.contains(r))
            .toList();
    List<PlannedCase> sources = new ArrayList<>(cases.isEmpty() ? given : cases);
    for (int i = 0;
        i < Math.max(cases.size(), model.inputs().isEmpty() ? 0 : missing.size());
        i++) {
      if (i >= cases.size()) {
        cases.add(sources.get(i % sources.size()).copy());
      }
      List<StepRow> from = missing.isEmpty() ? rows.valid() : missing;
      cases.get(i).setInitial(from.get(i % from.size()));
    }
    PlannedCase longest =
        sources.stream()
            .filter(PlannedCase::isValid)
            .max(Comparator.comparingInt(PlannedCase::distinctKinds))
            .orElse(null);
    for (StepRow row : rows.invalid()) {
      if (longest != null && !started.contains(row)) {
        PlannedCase invalid = longest.copy();
        invalid.setInitial(row);
        cases.add(invalid);
      }
    }
  }

  private void invalid(
      SequenceVerification.Explored explored, List<PlannedCase> given, List<PlannedCase> cases) {
    InvalidCases invalid =
        new InvalidCases(
            explored.space(),
            explored.steps(),
            explored.rows(),
            sequence.length(),
            sequence.order(),
            sequence.repeat(),
            options.seed());
    List<PlannedCase> added = new ArrayList<>();
    for (int kind = 0; kind < explored.steps().size(); kind++) {
      if (explored.steps().get(kind).hasForbidden()) {
        added.addAll(invalid.forbidden(kind));
      }
    }
    for (int kind = 0; kind < explored.steps().size(); kind++) {
      for (StepRow row : explored.rows().get(kind).invalid()) {
        int call = kind;
        boolean isGiven =
            given.stream()
                .flatMap(c -> c.steps().stream())
                .anyMatch(s -> s.kind() == call && s.row().equals(row));
        if (!isGiven) {
          invalid.invalidRow(kind, row).ifPresent(added::add);
        }
      }
    }
    List<StepRow> initial =
        cases.stream().map(PlannedCase::initial).filter(StepRow::isValid).distinct().toList();
    for (int i = 0; i < added.size(); i++) {
      if (!initial.isEmpty()) {
        added.get(i).setInitial(initial.get(i % initial.size()));
      }
    }
    given.stream().filter(c -> !c.isValid()).forEach(c -> added.removeIf(c::hasSameSteps));
    cases.addAll(added);
  }

  /** Reports the tuples that no sequence contains. */
  private void reportForbidden(TupleSpace tuples, BitSet allowed) {
    int[] possible =
        IntStream.range(0, tuples.size())
            .filter(t -> sequence.repeat() || tuples.isDistinct(t))
            .toArray();
    int missing = possible.length - allowed.cardinality();
    if (missing == 0) {
      return;
    }
    List<String> names = sequence.steps().stream().map(s -> s.name()).toList();
    String listed =
        IntStream.of(possible)
            .filter(t -> !allowed.get(t))
            .limit(MAX_LISTED)
            .mapToObj(
                t ->
                    IntStream.of(tuples.letters(t))
                        .mapToObj(names::get)
                        .collect(Collectors.joining(" ", "(", ")")))
            .collect(Collectors.joining(", "));
    diagnostics.warning(
        model.source(),
        sequence.line(),
        "sequence_spec",
        String.format(
            Locale.ROOT,
            "%,d of %,d %d-tuples of steps are not allowed, since no sequence of at most %d steps"
                + " holds them: %s%s",
            missing,
            possible.length,
            tuples.strength(),
            sequence.length(),
            listed,
            missing > MAX_LISTED ? ", …" : ""));
  }

  private TestSuite suite(CaseWriter writer, List<PlannedCase> cases) {
    Strength strength = options.strength() == null ? model.strength() : options.strength();
    InvalidValues invalidValues =
        options.invalidValues() == null ? model.invalidValues() : options.invalidValues();
    List<TestCase> written = writer.write(cases);
    List<StepParameters> steps = new ArrayList<>();
    sequence.calls().forEach(c -> steps.add(new StepParameters(c.name(), parameters(c.model()))));
    sequence.events().forEach(e -> steps.add(new StepParameters(e.name(), List.of())));
    return new TestSuite(
        model.name() + "-" + sequence.order() + "way-sequences",
        model.description(),
        model.name(),
        new Generation(
            strength,
            invalidValues,
            options.seed(),
            options.effort().name().toLowerCase(Locale.ROOT),
            GeneratorVersion.current()),
        parameters(model),
        steps,
        written);
  }

  private static List<CaseParameter> parameters(TestModel of) {
    return of.inputs().stream()
        .map(i -> new CaseParameter(i.name(), i.kind(), i.realType()))
        .toList();
  }
}
