package org.sitaf.runtime.simulation.frozen;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.IntFunction;
import org.jspecify.annotations.Nullable;
import org.sitaf.runtime.suite.CaseDataException;
import org.sitaf.runtime.suite.TestCase;
import org.sitaf.sim.v1.CreateSessionResponse;
import org.sitaf.sim.v1.PrepareManyRequest;
import org.sitaf.sim.v1.PrepareManyResponse;

/**
 * Prepares the following cases in bulk as long as components only read their devices. The session
 * itself prepares a case, with the same result, when the batch does not contain its values, its
 * simulation diverged or was rejected, or after {@link #stop}.
 */
public final class Preparation {
  /** The first batch is small, so that the first case starts soon; later batches grow. */
  private static final int FIRST_BATCH_SIZE = 32;

  private static final int MAX_BATCH_SIZE = 4096;

  /** Growth of the batch size; slower after a rejection, to avoid further rejected calls. */
  private static final int GROWTH = 8;

  private static final int CAREFUL_GROWTH = 2;

  /** When a batch of at most this size is rejected, its cases are prepared separately. */
  private static final int MIN_BATCH_SIZE = 8;

  private static final int MAX_NUMBERS = 1_000_000;

  private final Layout layout;
  private final IntFunction<List<TestCase>> upcoming;
  private final Function<PrepareManyRequest, Optional<PrepareManyResponse>> simulator;
  private @Nullable Batch batch;
  private int size = FIRST_BATCH_SIZE;
  private int growth = GROWTH;
  private int casesToPrepareSeparately;
  private boolean stopped;

  /**
   * Creates a preparation without prepared cases.
   *
   * @param upcoming returns up to a number of cases after the current one
   * @param simulator prepares many cases; empty when one of them is rejected
   */
  public Preparation(
      CreateSessionResponse created,
      IntFunction<List<TestCase>> upcoming,
      Function<PrepareManyRequest, Optional<PrepareManyResponse>> simulator) {
    this.layout = new Layout(created);
    this.upcoming = upcoming;
    this.simulator = simulator;
  }

  /** Stops preparing in bulk, because each case now needs the session itself. */
  public void stop() {
    stopped = true;
    batch = null;
  }

  /**
   * The world of the current case; empty when the session must prepare it.
   *
   * @param timeNanos simulation time at its end
   */
  public Optional<FrozenWorld> world(
      Map<String, Double> parameters, long settleNanos, long timeNanos) {
    if (stopped) {
      return Optional.empty();
    }
    Batch known = batch;
    Integer row = known == null ? null : known.find(parameters, settleNanos);
    if (row == null) {
      if (casesToPrepareSeparately > 0) {
        casesToPrepareSeparately--;
        return Optional.empty();
      }
      if (known != null && known.wasMostlyUnused()) {
        // The driver changes the suite's values before it sets them, so they cannot be predicted.
        stop();
        return Optional.empty();
      }
      known = prepareBatch(List.copyOf(parameters.keySet()), parameters, settleNanos);
      batch = known;
      row = 0;
    }
    return known == null ? Optional.empty() : known.take(row, timeNanos);
  }

  private @Nullable Batch prepareBatch(
      List<String> names, Map<String, Double> current, long settleNanos) {
    int width = Math.max(1, Math.max(layout.columns().size(), names.size()));
    List<TestCase> next = upcoming.apply(Math.min(size, MAX_NUMBERS / width) - 1);
    if (next.isEmpty()) {
      return null;
    }
    List<List<Double>> rows = rows(names, current, next);
    Optional<PrepareManyResponse> answer = ask(names, rows, settleNanos);
    if (answer.isEmpty()) {
      growth = CAREFUL_GROWTH;
    }
    while (answer.isEmpty() && rows.size() > MIN_BATCH_SIZE) {
      rows = rows.subList(0, Math.max(MIN_BATCH_SIZE, rows.size() / GROWTH));
      size = rows.size();
      answer = ask(names, rows, settleNanos);
    }
    if (answer.isEmpty()) {
      casesToPrepareSeparately = MIN_BATCH_SIZE - 1;
      size = MIN_BATCH_SIZE;
      return null;
    }
    PrepareManyResponse prepared = answer.get();
    if (!prepared.getColumnsList().equals(layout.columns())
        || prepared.getReadingsCount() != rows.size() * layout.columns().size()) {
      stop();
      return null;
    }
    size = Math.min(MAX_BATCH_SIZE, size * growth);
    return new Batch(layout, names, settleNanos, rows, prepared);
  }

  /** The values of the current case and of the following cases, each combination once. */
  private List<List<Double>> rows(
      List<String> names, Map<String, Double> current, List<TestCase> next) {
    Set<List<Double>> rows = new LinkedHashSet<>();
    rows.add(names.stream().map(current::get).toList());
    for (TestCase testCase : next) {
      try {
        rows.add(names.stream().map(testCase::doubleValue).toList());
      } catch (CaseDataException e) {
        // Reported when that case is read.
        break;
      }
    }
    return List.copyOf(rows);
  }

  private Optional<PrepareManyResponse> ask(
      List<String> names, List<List<Double>> rows, long settleNanos) {
    PrepareManyRequest.Builder request =
        PrepareManyRequest.newBuilder()
            .addAllParameters(names)
            .setCases(rows.size())
            .setSettleNs(settleNanos);
    rows.forEach(request::addAllValues);
    return simulator.apply(request.build());
  }
}
