package org.sitaf.core.verdict.document;

import java.util.ArrayList;
import java.util.List;
import org.sitaf.core.verdict.StepResult;
import org.sitaf.core.verdict.Verdict;
import org.sitaf.schemas.StepResultType;

/** The steps of a sequence in the document of a result. */
final class StepsXml {
  private StepsXml() {}

  static List<StepResult> read(List<StepResultType> given) {
    List<StepResult> steps = new ArrayList<>();
    for (StepResultType step : given) {
      steps.add(
          new StepResult(
              step.getName() == null ? "" : step.getName(),
              Verdict.valueOf(String.valueOf(step.getVerdict())),
              Boolean.TRUE.equals(step.isAfterFailure()),
              step.getValue(),
              TestResultXml.read(step.getExpected()),
              TestResultXml.read(step.getActual()),
              step.getAt(),
              TestResultXml.read(step.getProcessingTime()),
              step.getMessage() == null ? "" : step.getMessage()));
    }
    return steps;
  }

  static List<StepResultType> write(List<StepResult> steps) {
    List<StepResultType> written = new ArrayList<>();
    for (StepResult step : steps) {
      StepResultType type = new StepResultType();
      type.setName(step.name());
      type.setVerdict(step.verdict().name());
      type.setAfterFailure(step.afterFailure() ? true : null);
      type.getValue().addAll(step.values());
      type.getExpected().addAll(TestResultXml.write(step.expected()));
      type.getActual().addAll(TestResultXml.write(step.actual()));
      type.setAt(step.at());
      type.setProcessingTime(TestResultXml.write(step.time()));
      type.setMessage(step.message().isEmpty() ? null : step.message());
      written.add(type);
    }
    return written;
  }
}
