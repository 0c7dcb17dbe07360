package org.sitaf.server.build.log;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Extracts the lines of one case from a build's log: those between the agent's marker {@code
 * [sitaf] case NO} and the next marker, and the agent's remarks on the case. A component can forge
 * markers, which only affects its own log.
 */
final class CaseLog {
  private static final Pattern OTHER_MARKER =
      Pattern.compile("\\[sitaf] (outside of cases|case \\d+)|== shard .*");
  private static final String PREFIX = "[sitaf] ";
  private static final int MAX_MARKER = 64;

  private final String marker;
  private final int limit;
  private final ByteArrayOutputStream extracted = new ByteArrayOutputStream();
  private final ByteArrayOutputStream line = new ByteArrayOutputStream();
  private boolean inCase;
  private boolean lineContinues;
  private boolean lineBelongs;

  /**
   * Creates a reader.
   *
   * @param limit maximum number of bytes to extract
   */
  CaseLog(int no, int limit) {
    this.marker = PREFIX + "case " + no;
    this.limit = limit;
  }

  /** Reads the next piece of the log; returns false when the limit is reached. */
  boolean read(byte[] piece) {
    for (byte b : piece) {
      read(b);
    }
    return extracted.size() < limit;
  }

  /** The extracted lines; must be called after the last piece of the log. */
  byte[] result() {
    endPiece(true);
    byte[] all = extracted.toByteArray();
    return all.length <= limit ? all : Arrays.copyOf(all, limit);
  }

  private void read(byte b) {
    line.write(b);
    if (b == '\n') {
      endPiece(true);
    } else if (line.size() == 1 << 12) {
      // Long lines are processed in pieces; the first piece decides whether the line belongs.
      endPiece(false);
    }
  }

  private void endPiece(boolean lineEnds) {
    if (!lineContinues) {
      lineBelongs = belongs();
    }
    if (lineBelongs) {
      extracted.writeBytes(line.toByteArray());
    }
    line.reset();
    lineContinues = !lineEnds;
  }

  /** Whether the line belongs to the case. */
  private boolean belongs() {
    byte[] bytes = line.toByteArray();
    String start =
        new String(bytes, 0, Math.min(bytes.length, MAX_MARKER), StandardCharsets.UTF_8)
            .stripTrailing();
    if (start.equals(marker)) {
      inCase = true;
      return false;
    }
    Matcher other = OTHER_MARKER.matcher(start);
    if (other.matches()) {
      inCase = false;
      return false;
    }
    return start.startsWith(PREFIX) ? start.startsWith(marker + ": ") : inCase;
  }
}
