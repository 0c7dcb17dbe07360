package org.sitaf.agent.toolchain.coverage;

import org.sitaf.core.verdict.Coverage;

/** Reads a report in lcov format, which coverage.py writes, too. */
public final class LcovReport {
  private LcovReport() {}

  /**
   * Reads a report.
   *
   * @param activity path of the activity's folder in the report; other files are ignored
   * @param sources folder of the component's sources in the activity; other files are ignored
   * @throws IllegalArgumentException if the report is not in this format
   */
  public static Coverage read(String report, String activity, String sources) {
    String folder = activity.isEmpty() || activity.endsWith("/") ? activity : activity + "/";
    LineCounts counts = new LineCounts();
    String file = "";
    for (String line : report.lines().toList()) {
      int colon = line.indexOf(':');
      String[] fields = line.substring(colon + 1).split(",");
      switch (colon < 0 ? line : line.substring(0, colon)) {
        case "SF" -> {
          String path = line.substring(colon + 1);
          String inside = path.startsWith(folder) ? path.substring(folder.length()) : "";
          file = inside.startsWith(sources) ? inside : "";
        }
        case "DA" -> {
          if (!file.isEmpty()) {
            counts.line(file, Integer.parseInt(fields[0]), isPositive(fields[1]));
          }
        }
        case "BRDA" -> {
          if (!file.isEmpty()) {
            counts.branch(
                file,
                Integer.parseInt(fields[0]),
                fields[1] + "," + fields[2],
                isPositive(fields[3]));
          }
        }
        default -> {
          // Functions and totals are computed from the lines.
        }
      }
    }
    return counts.coverage();
  }

  private static boolean isPositive(String count) {
    return !count.equals("-") && !count.equals("0");
  }
}
