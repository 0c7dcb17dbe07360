package org.sitaf.server.build.agent;

import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import org.sitaf.agent.v1.AnalysisOrder;
import org.sitaf.agent.v1.ApplicationFile;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.agent.v1.AttemptRef;
import org.sitaf.agent.v1.AttemptState;
import org.sitaf.agent.v1.CaseOutcome;
import org.sitaf.agent.v1.OutputValue;
import org.sitaf.agent.v1.RecordingOrder;
import org.sitaf.agent.v1.Register;
import org.sitaf.agent.v1.SignalLimits;
import org.sitaf.core.activity.hardware.DeviceBackend;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.Verdict;
import org.sitaf.server.build.AttemptKey;
import org.sitaf.server.build.BuildFailure;
import org.sitaf.server.build.BuildFailure.SourceProblem;
import org.sitaf.server.build.BuildKind;
import org.sitaf.server.build.BuildState;
import org.sitaf.server.build.Leases;
import org.sitaf.server.build.recording.Recordings;
import org.sitaf.server.build.request.AgentConstraints;
import org.sitaf.server.build.request.Capabilities;
import org.sitaf.server.build.signal.CaseSignals;
import org.sitaf.server.build.signal.StoredSignals;
import org.sitaf.server.error.RequestException;

/** Converts messages of the protocol; errors name the invalid field. */
final class Messages {
  private static final Pattern AGENT_NAME = Pattern.compile("[A-Za-z0-9._-]{1,100}");
  private static final Pattern LANGUAGE = Pattern.compile("[a-z]{1,20}");
  private static final int MAX_DEVICES = 100;
  private static final int MAX_SLOTS = 1000;
  private static final int MAX_TOOLCHAINS = 50;
  private static final int MAX_REASON = 500;
  private static final int MAX_LITERAL = 1001;

  private Messages() {}

  static AttemptKey toKey(AttemptRef ref) {
    if (ref.getBuildId().isEmpty() || ref.getAttempt() < 1 || ref.getFencingToken() == 0) {
      throw RequestException.malformed(
          "attempt: build_id, attempt and fencing_token must be given.");
    }
    return new AttemptKey(ref.getBuildId(), ref.getAttempt(), ref.getFencingToken());
  }

  static List<AttemptKey> toKeys(List<AttemptRef> refs) {
    return refs.stream().map(Messages::toKey).toList();
  }

  static AttemptRef toRef(AttemptKey key) {
    return AttemptRef.newBuilder()
        .setBuildId(key.buildId())
        .setAttempt(key.no())
        .setFencingToken(key.token())
        .build();
  }

  static Assignment toAssignment(Leases.Assignment assignment) {
    Assignment.Builder message =
        Assignment.newBuilder()
            .setAttempt(toRef(assignment.key()))
            .setActivity(assignment.activity())
            .setModel(assignment.model())
            .setRecordings(toOrder(assignment))
            .addAllDevices(assignment.devices())
            .setSignals(
                SignalLimits.newBuilder()
                    .setMaxCases(StoredSignals.MAX_CASES)
                    .setMaxBytes(assignment.signalBytes()));
    if (assignment.kind() != BuildKind.TEST) {
      message.setAnalysis(
          AnalysisOrder.newBuilder()
              .setKind(AnalysisMessages.orderOf(assignment.kind()))
              .setMaxCases(assignment.cases()));
    }
    assignment.files().stream()
        .sorted(java.util.Comparator.comparing(f -> f.path()))
        .forEach(
            file ->
                message.addFiles(
                    ApplicationFile.newBuilder()
                        .setPath(file.path())
                        .setSha256(file.sha256())
                        .setSize(file.size())));
    return message.build();
  }

  private static RecordingOrder toOrder(Leases.Assignment assignment) {
    RecordingOrder.Cases cases =
        switch (assignment.recordedCases()) {
          case NONE -> RecordingOrder.Cases.CASES_UNSPECIFIED;
          case FAILED -> RecordingOrder.Cases.FAILED;
          case ALL -> RecordingOrder.Cases.ALL;
        };
    return RecordingOrder.newBuilder()
        .setCases(cases)
        .setMaxRecordings(Recordings.MAX_RECORDINGS)
        .setMaxBytes(assignment.recordingBytes())
        .build();
  }

  static CaseSignals toSignals(org.sitaf.agent.v1.CaseSignals message) {
    return new CaseSignals(
        message.getSamples(),
        message.getTimesNsList().stream().map(Messages::toSeconds).toList(),
        message.getSignalsList().stream()
            .map(
                s ->
                    new CaseSignals.Signal(
                        s.getName(),
                        s.getUnit(),
                        s.getValuesList().stream()
                            .map(v -> Double.isFinite(v) ? v : null)
                            .toList()))
            .toList(),
        message.getConditionsList().stream()
            .map(
                c ->
                    new CaseSignals.Condition(
                        c.getName(),
                        toSeconds(c.getFromNs()),
                        toSeconds(c.getToNs()),
                        c.getSignalsList()))
            .toList());
  }

  private static double toSeconds(long nanos) {
    return nanos / 1e9;
  }

  static BuildState toState(AttemptState state) {
    return switch (state) {
      case ATTEMPT_STATE_PREPARING -> BuildState.PREPARING;
      case ATTEMPT_STATE_COMPILING -> BuildState.COMPILING;
      case ATTEMPT_STATE_RUNNING -> BuildState.RUNNING;
      case ATTEMPT_STATE_UPLOADING -> BuildState.UPLOADING;
      case ATTEMPT_STATE_UNSPECIFIED, UNRECOGNIZED ->
          throw RequestException.malformed("state: must be a value of AttemptState.");
    };
  }

  static BuildFailure toFailure(org.sitaf.agent.v1.BuildFailure failure) {
    BuildFailure.Category category =
        switch (failure.getCategory()) {
          case COMPILATION -> BuildFailure.Category.COMPILATION;
          case INFRASTRUCTURE -> BuildFailure.Category.INFRASTRUCTURE;
          case CANCELLED, CATEGORY_UNSPECIFIED, UNRECOGNIZED ->
              throw RequestException.malformed(
                  "failure.category: must be COMPILATION or INFRASTRUCTURE.");
        };
    return new BuildFailure(
        category,
        failure.getMessage(),
        failure.getDiagnosticsList().stream()
            .map(
                d ->
                    new SourceProblem(
                        d.getFile(), d.getLine(), d.getColumn(), d.getMessage(), d.getGenerated()))
            .toList());
  }

  static CaseResult toCase(CaseOutcome outcome) {
    return new CaseResult(
        outcome.getNo(),
        toVerdict(outcome.getVerdict()),
        outcome.getValuesList().stream().map(Messages::cut).toList(),
        outcome.getExpectedList().stream().map(Messages::toValue).toList(),
        outcome.getActualList().stream().map(Messages::toValue).toList(),
        outcome.hasProcessingTime()
            ? new CaseResult.ProcessingTime(
                outcome.getProcessingTime().getTotal(),
                outcome.getProcessingTime().getHardware(),
                outcome.getProcessingTime().getStub())
            : null,
        cut(outcome.getMessage()));
  }

  private static Verdict toVerdict(String verdict) {
    try {
      return Verdict.valueOf(verdict);
    } catch (IllegalArgumentException e) {
      throw RequestException.malformed("verdict: must be PASS, FAIL, ERROR or DONT.");
    }
  }

  private static NamedValue toValue(OutputValue value) {
    return new NamedValue(cut(value.getOutput()), cut(value.getLiteral()));
  }

  private static String cut(String text) {
    return text.length() <= MAX_LITERAL ? text : text.substring(0, MAX_LITERAL) + "…";
  }

  static Capabilities toCapabilities(Register register) {
    return new Capabilities(
        register.getToolchainsList().stream()
            .map(t -> new Capabilities.Toolchain(t.getLanguage(), t.getVersion()))
            .toList(),
        register.getSimulation(),
        register.getAnalyses(),
        Set.copyOf(register.getLabelsList()),
        Set.copyOf(register.getDevicesList()));
  }

  static String toReason(String text) {
    return text.length() <= MAX_REASON ? text : text.substring(0, MAX_REASON);
  }

  static void verify(Register register) {
    AgentConstraints.requireLabels(Set.copyOf(register.getLabelsList()));
    if (register.getDevicesCount() > MAX_DEVICES
        || register.getDevicesList().stream().anyMatch(d -> !DeviceBackend.isName(d))) {
      throw RequestException.malformed(
          "devices: must be at most "
              + MAX_DEVICES
              + ", each a name of at most 128 letters, digits and '_'.");
    }
    if (register.getRefuses().length() > MAX_REASON) {
      throw RequestException.malformed("refuses: must be at most " + MAX_REASON + " characters.");
    }
    if (!AGENT_NAME.matcher(register.getName()).matches()) {
      throw RequestException.malformed(
          "name: must be 1 to 100 letters, digits, '.', '_' or '-', not '"
              + register.getName()
              + "'.");
    }
    if (register.getSlots() < 1 || register.getSlots() > MAX_SLOTS) {
      throw RequestException.malformed("slots: must be 1 to " + MAX_SLOTS + ".");
    }
    if (register.getVersion().length() > 100) {
      throw RequestException.malformed("version: must be at most 100 characters.");
    }
    boolean invalid =
        register.getToolchainsCount() > MAX_TOOLCHAINS
            || register.getToolchainsList().stream()
                .anyMatch(
                    t ->
                        !LANGUAGE.matcher(t.getLanguage()).matches()
                            || t.getVersion().length() > 200);
    if (invalid) {
      throw RequestException.malformed(
          "toolchains: must be at most "
              + MAX_TOOLCHAINS
              + ", each with a language in lower case and a version of at most 200 characters.");
    }
  }
}
