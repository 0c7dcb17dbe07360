package org.sitaf.core.harness.plan;

import java.util.Locale;
import java.util.regex.Pattern;

/** Identifiers in generated sources, independent of the language. */
public final class Words {
  private static final Pattern WORD = Pattern.compile("[\\p{L}_$][\\p{L}\\p{Nd}_$]*");
  private static final int MAX_LENGTH = 255;

  private Words() {}

  /**
   * Whether a name consists of letters, digits, {@code _} and {@code $}, and does not begin with a
   * digit.
   */
  public static boolean isWord(String name) {
    return name.length() <= MAX_LENGTH && WORD.matcher(name).matches();
  }

  /**
   * Joins words in camel case: {@code IndexOfSensor} becomes {@code indexOfSensor}; {@code Finder}
   * and {@code GetRange} become {@code finderGetRange}.
   */
  public static String camelCase(String[] words) {
    StringBuilder joined = new StringBuilder();
    for (String word : words) {
      joined.append(joined.isEmpty() ? lowered(word) : raised(word));
    }
    return joined.toString();
  }

  /**
   * Converts {@code IndexOfSensor} to {@code indexOfSensor}, {@code IRSensor} to {@code irSensor},
   * {@code ID} to {@code id}.
   */
  private static String lowered(String word) {
    int upper = 0;
    while (upper < word.length() && Character.isUpperCase(word.charAt(upper))) {
      upper++;
    }
    int lowered = upper > 1 && upper < word.length() ? upper - 1 : upper;
    return word.substring(0, lowered).toLowerCase(Locale.ROOT) + word.substring(lowered);
  }

  /** Converts {@code pose} to {@code Pose}. */
  public static String raised(String word) {
    return word.isEmpty()
        ? word
        : word.substring(0, 1).toUpperCase(Locale.ROOT) + word.substring(1);
  }
}
