package org.sitaf.agent.simulation;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.verdict.HardwareReport;

/** The robot simulator of one build, until it is closed. Thread-safe. */
public sealed interface BuildSimulator extends AutoCloseable permits OwnSimulator, SharedSimulator {

  /** Who uses it and its limits, for the build log. */
  String description();

  /**
   * Name and version, such as {@code sitaf-bridge 0.1.0 (MuJoCo 4.0.0)}.
   *
   * @throws SimulatorException if it does not answer
   */
  String version() throws SimulatorException, InterruptedException;

  /**
   * Compiles the build's world, the only one that its endpoints offer.
   *
   * @param description name of the world description among the files
   * @param files of the world's folder, by relative path
   * @param faults names of faults that a test sets, which must fit the world
   * @return length of a simulation step in nanoseconds
   * @throws WorldException if the simulator rejects it or crashes
   * @throws SimulatorException if it does not answer
   */
  long check(String description, Map<String, byte[]> files, Set<String> faults)
      throws WorldException, SimulatorException, InterruptedException;

  /**
   * Lets the sessions of endpoints that are opened later sample signals.
   *
   * @throws SimulatorException if the simulator opens no endpoints for a build
   */
  void sample(SignalOrder order) throws SimulatorException;

  /**
   * Takes the signals of a case whose record was read; call it before the endpoint of the case is
   * closed.
   *
   * @return empty if the test application kept none
   * @throws SimulatorException if the simulator does not answer
   */
  Optional<Trace> takeSignals(int no) throws SimulatorException;

  /**
   * Lets the sessions of endpoints that are opened later use devices that are not simulated; call
   * {@link #check} first. Real devices are held until this simulator is closed.
   *
   * @return what serves each device
   * @throws WorldException if a device does not fit the world
   * @throws SimulatorException if a provider does not answer, or the simulator is shared with
   *     others
   */
  List<String> use(HardwareOrder order)
      throws WorldException, SimulatorException, InterruptedException;

  /**
   * Ends a case with devices that are not simulated, and returns what was measured; call it before
   * the endpoint of the case is closed.
   *
   * @return null if all devices are simulated
   * @throws SimulatorException if the simulator does not answer
   */
  @Nullable HardwareReport takeHardwareReport(int no) throws SimulatorException;

  /**
   * The recorded motion of the case that runs; see {@link LiveMotion}.
   *
   * @throws SimulatorException if the simulator does not answer
   */
  Optional<LiveMotion.Motion> motion(long known) throws SimulatorException;

  /**
   * Opens an endpoint for one process of a test application; call {@link #check} first.
   *
   * @throws SimulatorException if no simulator answers and none can be started
   */
  SimulatorEndpoint open() throws SimulatorException, InterruptedException;

  /**
   * The gRPC target with full access, for the agent only.
   *
   * @throws SimulatorException if no simulator answers and none can be started
   */
  String target() throws SimulatorException, InterruptedException;

  @Override
  void close();
}
