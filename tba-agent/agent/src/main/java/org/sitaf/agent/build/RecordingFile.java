package org.sitaf.agent.build;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The name of the file of a recording: {@code NO.glb}, or {@code NO.relation-R.glb} for the second
 * run of a relation.
 *
 * @param no number of the case
 * @param relation index of the relation in the model, from 1; 0 for the case itself
 */
public record RecordingFile(int no, int relation) {
  private static final Pattern NAME =
      Pattern.compile("(\\d{1,9})(?:\\.relation-(\\d{1,3}))?\\.glb");

  /** Whether a file name is that of a recording. */
  public static boolean isRecording(String name) {
    return NAME.matcher(name).matches();
  }

  /**
   * Reads a file name.
   *
   * @throws IllegalArgumentException if it is not that of a recording
   */
  public static RecordingFile of(String name) {
    Matcher parts = NAME.matcher(name);
    if (!parts.matches()) {
      throw new IllegalArgumentException("'" + name + "' is not the name of a recording");
    }
    return new RecordingFile(
        Integer.parseInt(parts.group(1)),
        parts.group(2) == null ? 0 : Integer.parseInt(parts.group(2)));
  }

  /** The file name. */
  public String name() {
    return relation == 0 ? no + ".glb" : no + ".relation-" + relation + ".glb";
  }
}
