package org.sitaf.core.verdict;

import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * What was measured in a case with devices that are not simulated. Times are in seconds.
 *
 * @param devices names of these devices with what serves them, such as {@code ir1: a real device}
 * @param exchanges advances of simulation time, each paced to the wall clock
 * @param meanJitter mean time by which they ended too late
 * @param maxJitter greatest time by which one ended too late
 * @param missedDeadlines those that ended later than the next one should have
 * @param readings of real devices
 * @param maxAge greatest age of an accepted reading
 * @param staleReadings readings that were too old, so that the component got those of a failed
 *     device
 * @param refusedCommands commands beyond an envelope
 * @param safeStops how often the devices were stopped
 * @param faults why devices did not work; empty if they did
 */
public record HardwareReport(
    List<String> devices,
    long exchanges,
    double meanJitter,
    double maxJitter,
    long missedDeadlines,
    long readings,
    double maxAge,
    long staleReadings,
    long refusedCommands,
    long safeStops,
    List<String> faults) {
  public HardwareReport {
    devices = List.copyOf(devices);
    faults = List.copyOf(faults);
  }

  /**
   * The sums and greatest values of several cases; empty if no case has real or recorded devices.
   */
  public static Optional<HardwareReport> of(List<CaseResult> cases) {
    return cases.stream()
        .map(CaseResult::hardware)
        .filter(Objects::nonNull)
        .reduce(HardwareReport::plus);
  }

  private HardwareReport plus(HardwareReport other) {
    long both = exchanges + other.exchanges;
    return new HardwareReport(
        devices,
        both,
        both == 0 ? 0 : (meanJitter * exchanges + other.meanJitter * other.exchanges) / both,
        Math.max(maxJitter, other.maxJitter),
        missedDeadlines + other.missedDeadlines,
        readings + other.readings,
        Math.max(maxAge, other.maxAge),
        staleReadings + other.staleReadings,
        refusedCommands + other.refusedCommands,
        safeStops + other.safeStops,
        Stream.concat(faults.stream(), other.faults.stream()).distinct().toList());
  }

  /** One sentence for people. */
  public String text() {
    return String.format(
        Locale.ROOT,
        "%s; jitter at most %.2f ms, mean %.2f ms in %d exchanges, %d missed deadlines; readings at"
            + " most %.1f ms old, %d too old; %d commands refused; %d safe stops",
        String.join(", ", devices),
        maxJitter * 1e3,
        meanJitter * 1e3,
        exchanges,
        missedDeadlines,
        maxAge * 1e3,
        staleReadings,
        refusedCommands,
        safeStops);
  }
}
