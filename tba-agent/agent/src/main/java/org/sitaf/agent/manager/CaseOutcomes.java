package org.sitaf.agent.manager;

import java.util.List;
import org.sitaf.agent.v1.CaseOutcome;
import org.sitaf.agent.v1.OutputValue;
import org.sitaf.agent.v1.ProcessingTime;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;

/** Short case results for the live view; complete ones are part of the final result. */
final class CaseOutcomes {
  private static final int MAX_TEXT = 1000;
  private static final int MAX_VALUES = 100;

  private CaseOutcomes() {}

  static CaseOutcome of(CaseResult result) {
    CaseOutcome.Builder outcome =
        CaseOutcome.newBuilder()
            .setNo(result.no())
            .setVerdict(result.verdict().name())
            .setMessage(cut(result.message()));
    result.values().stream().limit(MAX_VALUES).forEach(v -> outcome.addValues(cut(v)));
    outcome.addAllExpected(outputs(result.expected()));
    outcome.addAllActual(outputs(result.actual()));
    if (result.time() != null) {
      outcome.setProcessingTime(
          ProcessingTime.newBuilder()
              .setTotal(result.micros().orElse(result.time().total()))
              .setHardware(result.time().hardware())
              .setStub(result.time().stub()));
    }
    return outcome.build();
  }

  private static List<OutputValue> outputs(List<NamedValue> values) {
    return values.stream()
        .limit(MAX_VALUES)
        .map(
            v ->
                OutputValue.newBuilder()
                    .setOutput(cut(v.output()))
                    .setLiteral(cut(v.literal()))
                    .build())
        .toList();
  }

  private static String cut(String text) {
    return text.length() <= MAX_TEXT ? text : text.substring(0, MAX_TEXT) + "…";
  }
}
