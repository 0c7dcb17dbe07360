package org.sitaf.core.harness.plan;

import java.util.regex.Pattern;

/** What a name in generated sources can be made of, whatever the language. */
public final class Words {
  private static final Pattern WORD = Pattern.compile("[\\p{L}_$][\\p{L}\\p{Nd}_$]*");
  private static final int MAX_LENGTH = 255;

  private Words() {}

  /**
   * Whether a name holds letters, digits, {@code _} and {@code $} only, and begins with no digit.
   */
  public static boolean isWord(String name) {
    return name.length() <= MAX_LENGTH && WORD.matcher(name).matches();
  }
}
