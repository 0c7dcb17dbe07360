package org.sitaf.agent.manager;

import com.google.protobuf.ByteString;
import java.io.ByteArrayOutputStream;
import java.util.List;
import org.sitaf.agent.build.BuildOutcome;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.agent.v1.AnalysisReport;
import org.sitaf.agent.v1.BuildFailure;
import org.sitaf.agent.v1.BuildFailure.Category;
import org.sitaf.agent.v1.Diagnostic;
import org.sitaf.agent.v1.SubmitResultRequest;
import org.sitaf.core.digest.Sha256;
import org.sitaf.core.verdict.document.TestResultXml;

/** Creates the messages that submit outcomes to the server. */
final class SubmitMessages {
  private static final int MAX_DIAGNOSTICS = 200;
  private static final int MAX_TEXT = 4000;

  /** Limit of the protocol. */
  private static final int MAX_REPORT_BYTES = 3 << 20;

  private SubmitMessages() {}

  static SubmitResultRequest of(Attempt attempt, BuildOutcome outcome) {
    if (outcome instanceof BuildOutcome.Completed completed) {
      ByteArrayOutputStream document = new ByteArrayOutputStream();
      TestResultXml.write(completed.result(), document);
      byte[] bytes = document.toByteArray();
      return SubmitResultRequest.newBuilder()
          .setAttempt(attempt.ref())
          .setResultDescriptor(ByteString.copyFrom(bytes))
          .setSha256(Sha256.hex(bytes))
          .build();
    }
    if (outcome instanceof BuildOutcome.Analysed analysed) {
      AnalysisReport report = AnalysisMessages.of(analysed.report());
      if (report.getSerializedSize() > MAX_REPORT_BYTES) {
        return failure(
            attempt,
            Category.COMPILATION,
            "the values of the suite are too long to be explained",
            List.of());
      }
      return SubmitResultRequest.newBuilder()
          .setAttempt(attempt.ref())
          .setAnalysis(report)
          .setSha256(Sha256.hex(report.toByteArray()))
          .build();
    }
    if (outcome instanceof BuildOutcome.CompilationFailed failed) {
      return failure(attempt, Category.COMPILATION, failed.message(), failed.diagnostics());
    }
    if (outcome instanceof BuildOutcome.InfrastructureFailed failed) {
      return infrastructure(attempt, failed.message());
    }
    if (outcome instanceof BuildOutcome.Cancelled cancelled) {
      return failure(attempt, Category.CANCELLED, cancelled.reason(), List.of());
    }
    throw new IllegalArgumentException("unknown outcome " + outcome);
  }

  static SubmitResultRequest infrastructure(Attempt attempt, String message) {
    return failure(attempt, Category.INFRASTRUCTURE, message, List.of());
  }

  private static SubmitResultRequest failure(
      Attempt attempt, Category category, String message, List<SourceDiagnostic> diagnostics) {
    BuildFailure.Builder failure =
        BuildFailure.newBuilder().setCategory(category).setMessage(cut(message));
    for (SourceDiagnostic diagnostic : diagnostics) {
      if (failure.getDiagnosticsCount() >= MAX_DIAGNOSTICS) {
        break;
      }
      failure.addDiagnostics(
          Diagnostic.newBuilder()
              .setFile(diagnostic.file())
              .setLine(diagnostic.line())
              .setColumn(diagnostic.column())
              .setMessage(cut(diagnostic.message()))
              .setGenerated(diagnostic.generated()));
    }
    return SubmitResultRequest.newBuilder().setAttempt(attempt.ref()).setFailure(failure).build();
  }

  /** Shortens the text of a compiler to the limit of a message. */
  private static String cut(String text) {
    return text.length() <= MAX_TEXT ? text : text.substring(0, MAX_TEXT) + "…";
  }
}
