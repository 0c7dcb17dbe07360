package org.sitaf.core.beginning;

import java.util.regex.Pattern;

/** Writes text into {@code activity.yaml} so that it remains one value. */
public final class YamlScalar {
  private static final Pattern PLAIN = Pattern.compile("/?\\w[\\w./-]*(?:::?\\w[\\w./-]*)*");

  private YamlScalar() {}

  /** The text as it is, or in quotes if it contains characters with a meaning. */
  public static String of(String text) {
    return PLAIN.matcher(text).matches() ? text : "'" + text.replace("'", "''") + "'";
  }
}
