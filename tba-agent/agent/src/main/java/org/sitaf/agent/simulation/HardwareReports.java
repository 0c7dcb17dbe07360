package org.sitaf.agent.simulation;

import java.util.ArrayList;
import java.util.List;
import org.sitaf.core.verdict.HardwareReport;
import org.sitaf.sim.v1.TakeHardwareReportResponse;

/** Converts what a bridge measured in a case with devices that are not simulated. */
final class HardwareReports {
  private HardwareReports() {}

  static HardwareReport of(TakeHardwareReportResponse taken, List<String> devices) {
    return new HardwareReport(
        devices,
        taken.getExchanges(),
        taken.getMeanJitterS(),
        taken.getMaxJitterS(),
        taken.getMissedDeadlines(),
        taken.getReadings(),
        taken.getMaxAgeS(),
        taken.getStaleReadings(),
        taken.getRefusedCommands(),
        taken.getSafeStops(),
        taken.getFaultsList());
  }

  static HardwareReport withFault(HardwareReport report, String fault) {
    List<String> faults = new ArrayList<>(report.faults());
    faults.add(fault);
    return new HardwareReport(
        report.devices(),
        report.exchanges(),
        report.meanJitter(),
        report.maxJitter(),
        report.missedDeadlines(),
        report.readings(),
        report.maxAge(),
        report.staleReadings(),
        report.refusedCommands(),
        report.safeStops(),
        faults);
  }
}
