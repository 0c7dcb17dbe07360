package org.sitaf.core.verdict.document;

import org.jspecify.annotations.Nullable;
import org.sitaf.core.verdict.HardwareReport;
import org.sitaf.schemas.HardwareReportType;

/** What was measured in a case with devices that are not simulated, in a result descriptor. */
final class HardwareReportXml {
  private HardwareReportXml() {}

  static HardwareReport read(HardwareReportType given) {
    return new HardwareReport(
        given.getDevice(),
        number(given.getExchanges()),
        real(given.getMeanJitter()),
        real(given.getMaxJitter()),
        number(given.getMissedDeadlines()),
        number(given.getReadings()),
        real(given.getMaxAge()),
        number(given.getStaleReadings()),
        number(given.getRefusedCommands()),
        number(given.getSafeStops()),
        given.getFault());
  }

  static @Nullable HardwareReportType write(@Nullable HardwareReport report) {
    if (report == null) {
      return null;
    }
    HardwareReportType written = new HardwareReportType();
    written.getDevice().addAll(report.devices());
    written.getFault().addAll(report.faults());
    written.setExchanges(report.exchanges());
    written.setMeanJitter(report.meanJitter());
    written.setMaxJitter(report.maxJitter());
    written.setMissedDeadlines(report.missedDeadlines());
    written.setReadings(report.readings());
    written.setMaxAge(report.maxAge());
    written.setStaleReadings(report.staleReadings());
    written.setRefusedCommands(report.refusedCommands());
    written.setSafeStops(report.safeStops());
    return written;
  }

  private static long number(@Nullable Long value) {
    return value == null ? 0 : value;
  }

  private static double real(@Nullable Double value) {
    return value == null ? 0 : value;
  }
}
