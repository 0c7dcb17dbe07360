package org.sitaf.server.build.log;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * What a log holds of one case: what follows the agent's remarks {@code [sitaf] case NO} until the
 * next case prints, and the remarks on it. A component that prints such lines itself deceives only
 * those who test it.
 */
final class CaseLog {
  private static final Pattern OTHER =
      Pattern.compile("\\[sitaf] (outside of cases|case \\d+)|== shard .*");
  private static final String REMARK = "[sitaf] ";
  private static final int HEAD = 64;

  private final String heading;
  private final int atMost;
  private final ByteArrayOutputStream found = new ByteArrayOutputStream();
  private final ByteArrayOutputStream line = new ByteArrayOutputStream();
  private boolean within;
  private boolean lineGoesOn;
  private boolean lineCounts;

  /**
   * Nothing is read yet.
   *
   * @param atMost bytes that are kept
   */
  CaseLog(int no, int atMost) {
    this.heading = REMARK + "case " + no;
    this.atMost = atMost;
  }

  /** Reads on; false when no more is wanted. */
  boolean read(byte[] more) {
    for (byte b : more) {
      read(b);
    }
    return found.size() < atMost;
  }

  /** What was found; after the last piece of the log. */
  byte[] found() {
    endPiece(true);
    byte[] all = found.toByteArray();
    return all.length <= atMost ? all : Arrays.copyOf(all, atMost);
  }

  private void read(byte b) {
    line.write(b);
    if (b == '\n') {
      endPiece(true);
    } else if (line.size() == 1 << 12) {
      // Nobody knows how long a line is; what it begins with says what it is.
      endPiece(false);
    }
  }

  private void endPiece(boolean lineEnds) {
    if (!lineGoesOn) {
      lineCounts = counts();
    }
    if (lineCounts) {
      found.writeBytes(line.toByteArray());
    }
    line.reset();
    lineGoesOn = !lineEnds;
  }

  /** Whether the line that begins here belongs to the case. */
  private boolean counts() {
    byte[] bytes = line.toByteArray();
    String head =
        new String(bytes, 0, Math.min(bytes.length, HEAD), StandardCharsets.UTF_8).stripTrailing();
    if (head.equals(heading)) {
      within = true;
      return false;
    }
    Matcher other = OTHER.matcher(head);
    if (other.matches()) {
      within = false;
      return false;
    }
    return head.startsWith(REMARK) ? head.startsWith(heading + ": ") : within;
  }
}
