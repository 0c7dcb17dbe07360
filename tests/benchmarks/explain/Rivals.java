import de.rwth.swc.coffee4j.algorithmic.constraint.MinimalForbiddenTuplesCheckerFactory;
import de.rwth.swc.coffee4j.algorithmic.model.CompleteTestModel;
import de.rwth.swc.coffee4j.algorithmic.model.GroupSpecificTestModel;
import de.rwth.swc.coffee4j.algorithmic.model.TestModel;
import de.rwth.swc.coffee4j.algorithmic.model.TestResult;
import de.rwth.swc.coffee4j.algorithmic.model.TupleList;
import de.rwth.swc.coffee4j.algorithmic.report.Reporter;
import de.rwth.swc.coffee4j.algorithmic.sequential.characterization.FaultCharacterizationAlgorithm;
import de.rwth.swc.coffee4j.algorithmic.sequential.characterization.FaultCharacterizationConfiguration;
import de.rwth.swc.coffee4j.algorithmic.sequential.characterization.ben.Ben;
import de.rwth.swc.coffee4j.algorithmic.sequential.characterization.delta.ImprovedDeltaDebugging;
import de.rwth.swc.coffee4j.algorithmic.sequential.characterization.mixtgte.Mixtgte;
import java.lang.reflect.Proxy;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.sitaf.core.combine.CombinationProblem;
import org.sitaf.core.explain.Tuple;

/** The algorithms of coffee4j, on the same suites and with the same outcomes. */
enum Rivals {
  IMPROVED_DELTA_DEBUGGING(ImprovedDeltaDebugging::new),
  MIXTGTE(Mixtgte::new),
  BEN(Ben::new);

  private static final int MAX_EXECUTIONS = 2_000;

  private final Function<FaultCharacterizationConfiguration, FaultCharacterizationAlgorithm> algorithm;

  Rivals(Function<FaultCharacterizationConfiguration, FaultCharacterizationAlgorithm> algorithm) {
    this.algorithm = algorithm;
  }

  record Answer(Set<Tuple> causes, int executions) {}

  Answer explain(Planted planted) {
    FaultCharacterizationAlgorithm search =
        algorithm.apply(new FaultCharacterizationConfiguration(model(planted), reporter()));
    Map<int[], TestResult> results = new LinkedHashMap<>();
    planted.rows().forEach(row -> results.put(row, result(planted, row)));
    int executions = 0;
    List<int[]> next = search.computeNextTestInputs(results);
    while (!next.isEmpty() && executions < MAX_EXECUTIONS) {
      Map<int[], TestResult> answers = new LinkedHashMap<>();
      for (int[] row : next) {
        answers.put(row, result(planted, row));
        executions++;
      }
      next = search.computeNextTestInputs(answers);
    }
    return new Answer(
        search.computeFailureInducingCombinations().stream()
            .map(Tuple::new)
            .collect(Collectors.toSet()),
        executions);
  }

  private static TestResult result(Planted planted, int[] row) {
    var outcome = planted.execute(row);
    return outcome.failed()
        ? TestResult.failure(new IllegalStateException(outcome.kind()))
        : TestResult.success();
  }

  private static TestModel model(Planted planted) {
    List<TupleList> forbidden = new ArrayList<>();
    for (Tuple tuple : planted.forbidden()) {
      int[] parameters =
          IntStream.range(0, planted.levels().length)
              .filter(i -> tuple.values()[i] != CombinationProblem.FREE)
              .toArray();
      forbidden.add(
          new TupleList(
              forbidden.size() + 1,
              parameters,
              List.of(Arrays.stream(parameters).map(i -> tuple.values()[i]).toArray())));
    }
    CompleteTestModel model =
        CompleteTestModel.builder()
            .positiveTestingStrength(2)
            .parameterSizes(planted.levels())
            .exclusionTupleLists(forbidden)
            .build();
    return GroupSpecificTestModel.positive(
        model, new MinimalForbiddenTuplesCheckerFactory().createConstraintChecker(model));
  }

  private static Reporter reporter() {
    return (Reporter)
        Proxy.newProxyInstance(
            Reporter.class.getClassLoader(), new Class<?>[] {Reporter.class}, (p, m, a) -> null);
  }
}
