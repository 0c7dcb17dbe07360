package org.sitaf.core.verdict.document;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.verdict.StepResult;
import org.sitaf.core.verdict.StepResult.Kind;
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
              kind(step.getClazz()),
              Verdict.valueOf(String.valueOf(step.getVerdict())),
              Boolean.TRUE.equals(step.isAfterFailure()),
              TestResultXml.read(step.getValue()),
              TestResultXml.read(step.getExpected()),
              TestResultXml.read(step.getActual()),
              step.getAt(),
              TestResultXml.read(step.getProcessingTime()),
              step.getMessage() == null ? "" : step.getMessage(),
              step.getBefore(),
              step.getAfter()));
    }
    return steps;
  }

  private static Kind kind(@Nullable String given) {
    if (given == null) {
      return Kind.VALID;
    }
    try {
      return Kind.valueOf(given.toUpperCase(Locale.ROOT));
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(
          "the class of a step must be forbidden or invalid, not '" + given + "'", e);
    }
  }

  static List<StepResultType> write(List<StepResult> steps) {
    List<StepResultType> written = new ArrayList<>();
    for (StepResult step : steps) {
      StepResultType type = new StepResultType();
      type.setName(step.name());
      type.setClazz(step.kind() == Kind.VALID ? null : step.kind().name().toLowerCase(Locale.ROOT));
      type.setVerdict(step.verdict().name());
      type.setAfterFailure(step.afterFailure() ? true : null);
      type.getValue().addAll(TestResultXml.write(step.inputs()));
      type.getExpected().addAll(TestResultXml.write(step.expected()));
      type.getActual().addAll(TestResultXml.write(step.actual()));
      type.setAt(step.at());
      type.setProcessingTime(TestResultXml.write(step.time()));
      type.setMessage(step.message().isEmpty() ? null : step.message());
      type.setBefore(step.before());
      type.setAfter(step.after());
      written.add(type);
    }
    return written;
  }
}
