package org.sitaf.server.build.agent;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sitaf.agent.v1.AnalysisOrder;
import org.sitaf.agent.v1.AnalysisReport;
import org.sitaf.agent.v1.ExplainedCause;
import org.sitaf.agent.v1.Explanation;
import org.sitaf.agent.v1.FlakyCase;
import org.sitaf.agent.v1.MutationScore;
import org.sitaf.agent.v1.NamedLiteral;
import org.sitaf.agent.v1.Repetition;
import org.sitaf.agent.v1.Score;
import org.sitaf.agent.v1.SurvivingFault;
import org.sitaf.core.explain.Explanation.Boundary;
import org.sitaf.core.explain.Explanation.Cause;
import org.sitaf.core.flaky.FlakyCause;
import org.sitaf.core.verdict.Verdict;
import org.sitaf.server.build.BuildKind;
import org.sitaf.server.build.analysis.ExplanationView;
import org.sitaf.server.build.analysis.RepetitionView;
import org.sitaf.server.build.analysis.ScoreView;
import org.sitaf.server.error.RequestException;

/** Converts the reports of analyses; errors name the invalid field. */
final class AnalysisMessages {
  /** Limits of the protocol. */
  private static final int MAX_BYTES = 3 << 20;

  private static final int MAX_ITEMS = 1000;

  private AnalysisMessages() {}

  static BuildKind kind(AnalysisReport report) {
    return switch (report.getReportCase()) {
      case EXPLANATION -> BuildKind.EXPLANATION;
      case SCORE -> BuildKind.SCORE;
      case REPETITION -> BuildKind.REPETITION;
      case REPORT_NOT_SET ->
          throw RequestException.malformed(
              "analysis: must be an explanation, a score or a repetition.");
    };
  }

  /**
   * The kind of an order.
   *
   * @throws IllegalArgumentException if the build is not an analysis
   */
  static AnalysisOrder.Kind orderOf(BuildKind kind) {
    return switch (kind) {
      case EXPLANATION -> AnalysisOrder.Kind.EXPLANATION;
      case SCORE -> AnalysisOrder.Kind.SCORE;
      case REPETITION -> AnalysisOrder.Kind.REPETITION;
      case TEST -> throw new IllegalArgumentException("a test is not an analysis");
    };
  }

  /** The report as it is stored. */
  static Object document(AnalysisReport report) {
    if (report.getSerializedSize() > MAX_BYTES) {
      throw RequestException.malformed("analysis: must be at most 3 MiB.");
    }
    return switch (kind(report)) {
      case SCORE -> score(report.getScore());
      case REPETITION -> repetition(report.getRepetition());
      default -> explanation(report.getExplanation());
    };
  }

  private static ExplanationView explanation(Explanation message) {
    if (message.getFurtherCount() > MAX_ITEMS) {
      throw RequestException.malformed("explanation.further: must be at most " + MAX_ITEMS + ".");
    }
    return new ExplanationView(
        message.getCausesList().stream().map(AnalysisMessages::cause).toList(),
        message.getExecutions(),
        message.getUnexplainedList(),
        message.getFurtherList().stream()
            .map(f -> new ExplanationView.FurtherView(f.getValuesList(), f.getFailed()))
            .toList(),
        message.getInputsList().stream()
            .map(
                i ->
                    new ExplanationView.InputView(
                        i.getName(), i.getNumeric(), i.getValuesList(), i.getInvalidList()))
            .toList());
  }

  private static ExplanationView.CauseView cause(ExplainedCause message) {
    if (!message.getVerdict().equals("FAIL") && !message.getVerdict().equals("ERROR")) {
      throw RequestException.malformed("cause.verdict: must be FAIL or ERROR.");
    }
    return ExplanationView.CauseView.of(
        new Cause(
            map(message.getParametersList()),
            message.getRelation().isEmpty() ? null : message.getRelation(),
            Verdict.valueOf(message.getVerdict()),
            message.getMessage(),
            message.getCasesList(),
            map(message.getSimplestList()),
            message.hasBoundary() ? boundary(message) : null,
            message.getExecutions(),
            message.getStepsList()),
        map(message.getRecordList()));
  }

  private static Boundary boundary(ExplainedCause message) {
    String passes = message.getBoundary().getPasses();
    String fails = message.getBoundary().getFails();
    try {
      Double.parseDouble(passes);
      Double.parseDouble(fails);
    } catch (NumberFormatException e) {
      throw RequestException.malformed("cause.boundary: passes and fails must be numbers.");
    }
    return new Boundary(message.getBoundary().getParameter(), passes, fails);
  }

  private static Map<String, String> map(List<NamedLiteral> literals) {
    Map<String, String> map = new LinkedHashMap<>();
    literals.forEach(l -> map.put(l.getName(), l.getLiteral()));
    return map;
  }

  private static RepetitionView repetition(Repetition message) {
    if (message.getCasesCount() > MAX_ITEMS) {
      throw RequestException.malformed("repetition.cases: must be at most " + MAX_ITEMS + ".");
    }
    return new RepetitionView(
        message.getRuns(),
        message.getCount(),
        message.getCasesList().stream().map(AnalysisMessages::flaky).toList());
  }

  private static RepetitionView.FlakyCaseView flaky(FlakyCase message) {
    return new RepetitionView.FlakyCaseView(
        message.getNo(),
        switch (message.getCause()) {
          case COMPONENT -> FlakyCause.COMPONENT;
          case SIMULATOR -> FlakyCause.SIMULATOR;
          case MACHINE -> FlakyCause.MACHINE;
          case UNKNOWN -> FlakyCause.UNKNOWN;
          case CAUSE_UNSPECIFIED, UNRECOGNIZED ->
              throw RequestException.malformed(
                  "repetition.cases.cause: must be COMPONENT, SIMULATOR, MACHINE or UNKNOWN.");
        },
        message.getVerdictsList().stream().map(AnalysisMessages::verdict).toList(),
        message.getReason());
  }

  private static Verdict verdict(String name) {
    return Arrays.stream(Verdict.values())
        .filter(v -> v.name().equals(name))
        .findFirst()
        .orElseThrow(
            () ->
                RequestException.malformed(
                    "repetition.cases.verdicts: must be PASS, FAIL, ERROR or DONT."));
  }

  private static ScoreView score(Score message) {
    if (message.getSurvivorsCount() > MAX_ITEMS) {
      throw RequestException.malformed("score.survivors: must be at most " + MAX_ITEMS + ".");
    }
    return new ScoreView(
        message.getInjected(),
        message.getNoticed(),
        message.getEquivalent(),
        survivors(message.getSurvivorsList()),
        message.getOutputsList().stream()
            .map(o -> new ScoreView.OutputView(o.getOutput(), o.getChanged(), o.getNoticed()))
            .toList(),
        message.getWarningsList(),
        message.hasMutations() ? mutations(message.getMutations()) : null);
  }

  private static ScoreView.MutationScoreView mutations(MutationScore message) {
    if (message.getSurvivorsCount() > MAX_ITEMS || message.getUnchangedCount() > MAX_ITEMS) {
      throw RequestException.malformed(
          "score.mutations: survivors and unchanged must be at most " + MAX_ITEMS + ".");
    }
    return new ScoreView.MutationScoreView(
        message.getMade(),
        message.getNoticed(),
        survivors(message.getSurvivorsList()),
        message.getUnchangedList());
  }

  private static List<ScoreView.SurvivorView> survivors(List<SurvivingFault> faults) {
    return faults.stream()
        .map(s -> new ScoreView.SurvivorView(s.getFault(), s.getWhere(), s.getSuggestion()))
        .toList();
  }
}
