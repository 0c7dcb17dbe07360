package org.sitaf.agent.manager;

import java.io.ByteArrayInputStream;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.analysis.AnalysisOrder;
import org.sitaf.agent.build.AnalysisReport.Explained;
import org.sitaf.agent.build.AnalysisReport.Repeated;
import org.sitaf.agent.build.AnalysisReport.Scored;
import org.sitaf.agent.v1.AnalysisReport;
import org.sitaf.agent.v1.ExplainedCause;
import org.sitaf.agent.v1.ExplainedInput;
import org.sitaf.agent.v1.FailureBoundary;
import org.sitaf.agent.v1.FlakyCase;
import org.sitaf.agent.v1.FurtherCase;
import org.sitaf.agent.v1.NamedLiteral;
import org.sitaf.agent.v1.Repetition;
import org.sitaf.agent.v1.Score;
import org.sitaf.agent.v1.ScoredOutput;
import org.sitaf.agent.v1.SurvivingFault;
import org.sitaf.core.explain.Explanation;
import org.sitaf.core.explain.Explanation.Boundary;
import org.sitaf.core.explain.Explanation.Cause;
import org.sitaf.core.score.SpecificationScore;
import org.sitaf.core.score.SpecificationScore.Survivor;
import org.sitaf.core.score.mutation.MutationScore;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.document.TestResultXml;

/** Converts analyses from and to messages of the protocol; texts and lists are limited. */
final class AnalysisMessages {
  private static final int MAX_TEXT = 4000;
  private static final int MAX_CAUSES = 200;
  private static final int MAX_ITEMS = 1000;

  private AnalysisMessages() {}

  /**
   * What to analyse.
   *
   * @param analysed the descriptor of the analysed result; null if there is none
   * @throws IllegalArgumentException if the order contradicts the protocol
   */
  static AnalysisOrder order(org.sitaf.agent.v1.AnalysisOrder message, byte @Nullable [] analysed) {
    int cases = (int) Math.min(Integer.toUnsignedLong(message.getMaxCases()), Integer.MAX_VALUE);
    return switch (message.getKind()) {
      case SCORE -> new AnalysisOrder.Score(cases);
      case EXPLANATION -> new AnalysisOrder.Explain(result(analysed), cases);
      case REPETITION -> new AnalysisOrder.Repeat(result(analysed), cases);
      case KIND_UNSPECIFIED, UNRECOGNIZED ->
          throw new IllegalArgumentException(
              "the kind of the analysis is not known; update the agent");
    };
  }

  private static TestResult result(byte @Nullable [] analysed) {
    if (analysed == null) {
      throw new IllegalArgumentException("the assignment has no result to analyse");
    }
    return TestResultXml.read(new ByteArrayInputStream(analysed), "analysed-result.xml");
  }

  static AnalysisReport of(org.sitaf.agent.build.AnalysisReport report) {
    if (report instanceof Scored scored) {
      return AnalysisReport.newBuilder().setScore(score(scored)).build();
    }
    if (report instanceof Explained explained) {
      return AnalysisReport.newBuilder().setExplanation(explanation(explained)).build();
    }
    if (report instanceof Repeated repeated) {
      return AnalysisReport.newBuilder().setRepetition(repetition(repeated)).build();
    }
    throw new IllegalArgumentException("unknown report " + report);
  }

  private static Repetition repetition(Repeated repeated) {
    Repetition.Builder message =
        Repetition.newBuilder().setRuns(repeated.runs()).setCount(repeated.flaky().size());
    repeated.flaky().stream()
        .limit(MAX_ITEMS)
        .forEach(
            f ->
                message.addCases(
                    FlakyCase.newBuilder()
                        .setNo(f.no())
                        .setCause(
                            switch (f.cause()) {
                              case COMPONENT -> FlakyCase.Cause.COMPONENT;
                              case SIMULATOR -> FlakyCase.Cause.SIMULATOR;
                              case MACHINE -> FlakyCase.Cause.MACHINE;
                              case UNKNOWN -> FlakyCase.Cause.UNKNOWN;
                            })
                        .addAllVerdicts(f.verdicts().stream().map(Enum::name).toList())
                        .setReason(cut(f.reason()))));
    return message.build();
  }

  private static org.sitaf.agent.v1.Explanation explanation(Explained explained) {
    Explanation explanation = explained.explanation();
    org.sitaf.agent.v1.Explanation.Builder message =
        org.sitaf.agent.v1.Explanation.newBuilder()
            .setExecutions(explanation.executions())
            .addAllUnexplained(explanation.unexplained());
    List<Cause> causes = explanation.causes();
    for (int i = 0; i < Math.min(causes.size(), MAX_CAUSES); i++) {
      message.addCauses(cause(causes.get(i), explained.records().get(i)));
    }
    explained.further().stream()
        .limit(MAX_ITEMS)
        .forEach(
            f ->
                message.addFurther(
                    FurtherCase.newBuilder().addAllValues(f.values()).setFailed(f.failed())));
    explained
        .inputs()
        .forEach(
            input ->
                message.addInputs(
                    ExplainedInput.newBuilder()
                        .setName(input.name())
                        .setNumeric(input.numeric())
                        .addAllValues(input.values().keySet())
                        .addAllInvalid(
                            input.values().entrySet().stream()
                                .filter(v -> !v.getValue())
                                .map(Map.Entry::getKey)
                                .toList())));
    return message.build();
  }

  private static ExplainedCause cause(Cause cause, Map<String, String> record) {
    ExplainedCause.Builder message =
        ExplainedCause.newBuilder()
            .addAllParameters(literals(cause.parameters()))
            .setRelation(cause.relation() == null ? "" : cause.relation())
            .setVerdict(cause.verdict().name())
            .setMessage(cut(cause.message()))
            .addAllCases(cause.cases())
            .addAllSimplest(literals(cause.simplest()))
            .setExecutions(cause.executions())
            .addAllSteps(
                cause.steps().stream().limit(MAX_ITEMS).map(AnalysisMessages::cut).toList())
            .addAllRecord(literals(record));
    Boundary boundary = cause.boundary();
    if (boundary != null) {
      message.setBoundary(
          FailureBoundary.newBuilder()
              .setParameter(boundary.parameter())
              .setPasses(boundary.passes())
              .setFails(boundary.fails()));
    }
    return message.build();
  }

  private static List<NamedLiteral> literals(Map<String, String> values) {
    return values.entrySet().stream()
        .map(v -> NamedLiteral.newBuilder().setName(v.getKey()).setLiteral(v.getValue()).build())
        .toList();
  }

  private static Score score(Scored scored) {
    SpecificationScore score = scored.score();
    Score.Builder message =
        Score.newBuilder()
            .setInjected(score.injected())
            .setNoticed(score.noticed())
            .setEquivalent(score.equivalent())
            .addAllWarnings(
                score.warnings().stream().limit(MAX_ITEMS).map(AnalysisMessages::cut).toList());
    message.addAllSurvivors(survivors(score.survivors()));
    MutationScore mutations = scored.mutations();
    if (mutations != null) {
      message.setMutations(
          org.sitaf.agent.v1.MutationScore.newBuilder()
              .setMade(mutations.made())
              .setNoticed(mutations.noticed())
              .addAllSurvivors(survivors(mutations.survivors()))
              .addAllUnchanged(
                  mutations.unchanged().stream()
                      .limit(MAX_ITEMS)
                      .map(m -> cut(m.where() + ": " + m.change()))
                      .toList()));
    }
    score
        .byOutput()
        .forEach(
            (output, count) ->
                message.addOutputs(
                    ScoredOutput.newBuilder()
                        .setOutput(cut(output))
                        .setChanged(count.changed())
                        .setNoticed(count.noticed())));
    return message.build();
  }

  private static List<SurvivingFault> survivors(List<Survivor> survivors) {
    return survivors.stream()
        .limit(MAX_ITEMS)
        .map(
            s ->
                SurvivingFault.newBuilder()
                    .setFault(cut(s.fault()))
                    .setWhere(cut(s.where()))
                    .setSuggestion(cut(s.suggestion()))
                    .build())
        .toList();
  }

  private static String cut(String text) {
    return text.length() <= MAX_TEXT ? text : text.substring(0, MAX_TEXT) + "…";
  }
}
