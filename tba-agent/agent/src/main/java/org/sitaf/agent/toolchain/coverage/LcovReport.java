package org.sitaf.agent.toolchain.coverage;

import org.sitaf.core.verdict.Coverage;

/** A report in the format of lcov, which coverage.py writes too. */
public final class LcovReport {
  private LcovReport() {}

  /**
   * Reads a report.
   *
   * @param activity path of the activity's folder as the report has it; files elsewhere are left
   *     out
   * @param sources folder of the component's sources within the activity; others are left out
   * @throws IllegalArgumentException when it is no such report
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
            counts.line(file, Integer.parseInt(fields[0]), isAboveZero(fields[1]));
          }
        }
        case "BRDA" -> {
          if (!file.isEmpty()) {
            counts.branch(
                file,
                Integer.parseInt(fields[0]),
                fields[1] + "," + fields[2],
                isAboveZero(fields[3]));
          }
        }
        default -> {
          // Functions and sums, which the lines tell too.
        }
      }
    }
    return counts.coverage();
  }

  private static boolean isAboveZero(String count) {
    return !count.equals("-") && !count.equals("0");
  }
}
