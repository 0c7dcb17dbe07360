package org.sitaf.agent.build;

import java.io.IOException;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.executor.OutputSink;
import org.sitaf.agent.simulation.BuildSimulator;
import org.sitaf.agent.simulation.HardwareOrder;
import org.sitaf.agent.simulation.SimulatorException;
import org.sitaf.agent.simulation.WorldException;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.core.activity.hardware.DeviceBackend;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.HardwareReport;
import org.sitaf.core.verdict.ResultAssembler;
import org.sitaf.core.verdict.Verdict;

/**
 * The devices of a build that are not simulated. A case in which one did not work, or in which
 * simulation time did not keep up with the wall clock, says nothing about the component.
 */
final class CaseHardware {
  private static final String PROFILE = "activity/activity.yaml";
  private static final String REASON = "infrastructure: ";

  private final TestApplication application;
  private final OfferedDevices offered;
  private final List<DeviceBackend> backends;

  CaseHardware(TestApplication application, OfferedDevices offered) {
    this.application = application;
    this.offered = offered;
    this.backends = application.activity().profile().hardware();
  }

  /**
   * Lets a simulator use the devices, if there are any; they must fit its world.
   *
   * @throws CompilationException if they do not
   * @throws IOException if this machine does not offer a device, or a provider does not answer
   */
  void begin(BuildSimulator simulator, OutputSink log)
      throws IOException, InterruptedException, CompilationException {
    if (backends.isEmpty()) {
      return;
    }
    Map<String, String> addresses = new HashMap<>();
    Map<String, byte[]> recordings = new HashMap<>();
    for (DeviceBackend backend : backends) {
      String file = backend.file();
      if (file != null) {
        recordings.put(
            backend.device(), application.activity().files().content(file).orElseThrow());
        continue;
      }
      addresses.put(
          backend.device(),
          offered
              .address(backend)
              .orElseThrow(
                  () ->
                      new IOException(
                          "activity.yaml: hardware."
                              + backend.device()
                              + (offered.others()
                                  ? ": has no address; add the address of its provider, or use"
                                      + " --device "
                                      + backend.device()
                                      + "=ADDRESS"
                                  : ": this agent does not offer the device; start it with --device "
                                      + backend.device()
                                      + "=ADDRESS"))));
    }
    try {
      List<String> served =
          simulator.use(new HardwareOrder(backends, addresses, recordings, parameters()));
      log.remark("devices: " + String.join(", ", served));
    } catch (WorldException e) {
      String message = String.valueOf(e.getMessage());
      throw new CompilationException(
          "the devices do not fit: " + message,
          message.lines().map(line -> SourceDiagnostic.ofFile(PROFILE, line)).toList());
    }
  }

  /** What the test sets: the inputs of its cases, and in sequences those of calls and events. */
  private Set<String> parameters() {
    Set<String> names =
        application.suite().parameters().stream()
            .filter(parameter -> parameter.kind() == InputKind.TDSD)
            .map(CaseParameter::name)
            .collect(Collectors.toCollection(TreeSet::new));
    SequenceSpec sequence = application.model().sequence();
    if (sequence != null) {
      sequence.events().forEach(event -> names.add(event.set()));
      sequence.calls().stream()
          .flatMap(call -> call.model().inputs().stream())
          .filter(input -> input.kind() == InputKind.TDSD)
          .forEach(input -> names.add(input.name()));
    }
    return names;
  }

  /** The result of a case with what was measured; DONT if the devices did not work. */
  CaseResult judged(
      ResultAssembler assembler, CaseResult result, @Nullable BuildSimulator simulator) {
    if (backends.isEmpty() || simulator == null) {
      return result;
    }
    HardwareReport report;
    try {
      report = simulator.takeHardwareReport(result.no());
    } catch (SimulatorException e) {
      return assembler.without(
          result.no(),
          Verdict.DONT,
          REASON + "it is not known how the devices worked: " + e.getMessage());
    }
    if (report == null) {
      return result;
    }
    String fault = fault(report);
    CaseResult sound =
        fault.isEmpty() ? result : assembler.without(result.no(), Verdict.DONT, REASON + fault);
    return sound.with(report);
  }

  private String fault(HardwareReport report) {
    if (!report.faults().isEmpty()) {
      return String.join("; ", report.faults());
    }
    double limit = application.activity().profile().limits().jitter().toNanos() / 1e9;
    boolean isReal = backends.stream().anyMatch(DeviceBackend::isReal);
    return isReal && report.maxJitter() > limit
        ? String.format(
            Locale.ROOT,
            "simulation time was %.1f ms late on the wall clock, more than limits.jitter_ms: %s",
            report.maxJitter() * 1e3,
            limit * 1e3)
        : "";
  }
}
