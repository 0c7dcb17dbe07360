package org.sitaf.agent.build;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.executor.OutputSink;
import org.sitaf.agent.simulation.BuildSimulator;
import org.sitaf.agent.simulation.SignalOrder;
import org.sitaf.agent.simulation.SimulatorException;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.core.activity.ActivityProfile.Limits;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.description.WorldSignals;
import org.sitaf.core.description.source.ComponentDescription.Port;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.model.Target;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.trajectory.TrajectoryConditions;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.MessageTraces;
import org.sitaf.core.verdict.PortTraces;
import org.sitaf.core.verdict.ResultAssembler;
import org.sitaf.core.verdict.TraceSource.MissingTraceException;

/**
 * The signals of the cases of one build: what the simulator samples, and the judgement of the
 * trajectory conditions over it.
 */
final class CaseSignals {
  private final TestApplication application;
  private final TrajectoryConditions conditions;
  private final SignalOrder order;
  private final boolean reported;
  private final BuildListener listener;
  private final @Nullable KeptSignals kept;
  private final @Nullable MessageTraces messages;
  private final PortTraces ports;

  /**
   * @param settings whether all signals are reported to the listener, and which are kept
   */
  CaseSignals(TestApplication application, BuildSettings settings, BuildListener listener) {
    this.application = application;
    this.listener = listener;
    WorldDescription world = application.activity().world();
    List<String> sampled = world == null ? List.of() : WorldSignals.of(world);
    boolean sequence = application.model().sequence() != null;
    // The messages of a sequence count from the call of each step.
    List<String> sent = sequence ? List.of() : application.activity().messageSignals();
    List<Port.Data> ports = application.activity().outputPorts();
    Diagnostics diagnostics = new Diagnostics();
    Limits limits = application.activity().profile().limits();
    this.conditions =
        TrajectoryConditions.compile(
            application.model(),
            application.activity().signals(application.model()),
            application.activity().signalLists(application.model()),
            limits.caseSimulation().toNanos() / 1e9,
            diagnostics);
    diagnostics.throwIfErrors();
    this.reported = settings.signals() && world != null;
    SignalLimits limitsOfKept = settings.kept();
    RecordingOrder recordings = settings.recordings();
    this.kept =
        limitsOfKept == null || world == null
            ? null
            : new KeptSignals(
                limitsOfKept,
                recordings == null ? null : recordings.cases(),
                world,
                conditions,
                listener);
    // Elements of lists are sampled only for conditions, because a scan can have thousands.
    Set<String> wanted = new TreeSet<>(conditions.signals());
    if (this.reported) {
      wanted.addAll(sampled);
      wanted.addAll(sent);
    }
    this.ports = new PortTraces(ports, conditions.signals());
    this.messages =
        sent.isEmpty()
            ? null
            : new MessageTraces(application.activity().recordedMessages(), wanted);
    // The simulator knows nothing of messages, ports and steps.
    wanted.removeAll(sent);
    if (messages != null) {
      wanted.removeAll(messages.names());
    }
    wanted.removeAll(this.ports.names());
    if (!sampled.contains(SequenceSpec.STEP)) {
      wanted.remove(SequenceSpec.STEP);
    }
    List<String> names = List.copyOf(wanted);
    // The time alone gives the number of samples.
    this.order = new SignalOrder(names.isEmpty() ? List.of("t") : names, conditions.needSettling());
  }

  /** The compiled conditions. */
  TrajectoryConditions conditions() {
    return conditions;
  }

  /**
   * Lets the simulator sample the signals, if any are needed.
   *
   * @throws CompilationException if a condition needs more memory than a case may have
   */
  void begin(BuildSimulator simulator, long stepNanos)
      throws CompilationException, SimulatorException {
    if (conditions.isEmpty() && !reported) {
      return;
    }
    requireMemory(stepNanos);
    simulator.sample(order);
  }

  private void requireMemory(long stepNanos) throws CompilationException {
    Target target = application.model().target();
    long nanos = target.runFor().toNanos() + (order.settling() ? target.settle().toNanos() : 0);
    SequenceSpec sequence = application.model().sequence();
    if (sequence != null) {
      long longest =
          sequence.calls().stream()
              .map(c -> c.model().target())
              .mapToLong(t -> t.settle().toNanos() + t.runFor().toNanos())
              .max()
              .orElse(0);
      nanos += longest * sequence.length();
    }
    long samples = nanos / Math.max(1, stepNanos) + 1;
    int limit = application.activity().profile().limits().memoryMiB();
    for (Map.Entry<String, Long> needed :
        conditions.beyond((long) limit << 20, samples).entrySet()) {
      String message =
          "the trajectory condition '%s' would keep %,d MiB of samples (%,d samples), more than limits.memory_mb: %d; shorten run_for or the formula"
              .formatted(needed.getKey(), needed.getValue() >> 20, samples, limit);
      throw new CompilationException(
          message,
          List.of(SourceDiagnostic.ofFile("activity/" + application.model().source(), message)));
    }
  }

  /** Removes the signals of a case that is not judged by them. */
  void discard(int no, @Nullable BuildSimulator simulator) {
    if (simulator == null || conditions.isEmpty() && !reported) {
      return;
    }
    try {
      var unused = simulator.takeSignals(no);
    } catch (SimulatorException e) {
      // They are not needed.
    }
  }

  /** The result of a recorded case. */
  CaseResult judge(
      ResultAssembler assembler, CaseRecord record, @Nullable BuildSimulator simulator) {
    if (simulator == null || conditions.isEmpty() && !reported) {
      return assembler.judge(record);
    }
    Optional<Trace> trace = Optional.empty();
    String problem = "the simulator has no signals of this case";
    try {
      trace = simulator.takeSignals(record.no());
      if (messages != null && trace.isPresent()) {
        trace = Optional.of(messages.extended(trace.get(), record.calls()));
      }
      if (trace.isPresent()) {
        trace = Optional.of(ports.extended(trace.get(), record.ports()));
      }
    } catch (MissingTraceException e) {
      trace = Optional.empty();
      problem = String.valueOf(e.getMessage());
    } catch (SimulatorException e) {
      problem = String.valueOf(e.getMessage());
    }
    if (!record.steps().isEmpty()) {
      trace = trace.map(t -> SequenceSignal.added(t, record.steps()));
    }
    if (reported && trace.isPresent()) {
      listener.signals(record.no(), trace.get());
    }
    Optional<Trace> taken = trace;
    String why = problem;
    CaseResult result =
        assembler.judge(record, () -> taken.orElseThrow(() -> new MissingTraceException(why)));
    if (kept != null && taken.isPresent()) {
      kept.add(result, taken.get());
    }
    return result;
  }

  /** Logs which signals are kept. */
  void report(OutputSink log) {
    if (kept != null) {
      kept.report(log);
    }
  }
}
