package org.sitaf.core.value;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import org.sitaf.core.model.TestSpec;
import org.sitaf.core.model.Value;

/** Generates random strings with boundary lengths (paper, Fig. 8). */
final class StringValues {
  private static final String ALPHABET = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
  private static final String DIGITS = "0123456789";
  private static final String SPECIAL = "!\"#$%&'()*+,-./:;<=>?@[\\]^_`{|}~";

  private StringValues() {}

  static List<TestValue> generate(TestSpec.RandomStrings spec, ElementRandom random) {
    String characters = characters(spec);
    int min = spec.minLength();
    int max = spec.maxLength();
    int middle = (min + max) / 2;
    List<TestValue> values = new ArrayList<>();
    for (int length :
        new TreeSet<>(List.of(min - 1, min, min + 1, middle, max - 1, max, max + 1))) {
      if (length == 0 || (length > 0 && !characters.isEmpty())) {
        String text = random(characters, length, random);
        values.add(new TestValue(new Value.Text(text), length >= min && length <= max));
      }
    }
    if (!spec.negativeCharacters().isEmpty()) {
      values.add(new TestValue(new Value.Text(negative(spec, characters, middle, random)), false));
    }
    return values;
  }

  static boolean isValid(String text, TestSpec.RandomStrings spec) {
    String characters = characters(spec);
    return text.length() >= spec.minLength()
        && text.length() <= spec.maxLength()
        && text.chars().allMatch(c -> characters.indexOf(c) >= 0);
  }

  /** Allowed characters with all negative characters inserted at random positions. */
  private static String negative(
      TestSpec.RandomStrings spec, String characters, int length, ElementRandom random) {
    StringBuilder text =
        new StringBuilder(
            random(characters, Math.max(0, length - spec.negativeCharacters().length()), random));
    for (char c : spec.negativeCharacters().toCharArray()) {
      text.insert(random.nextInt(text.length() + 1), c);
    }
    return text.toString();
  }

  private static String random(String characters, int length, ElementRandom random) {
    StringBuilder text = new StringBuilder(length);
    for (int i = 0; i < length && !characters.isEmpty(); i++) {
      text.append(characters.charAt(random.nextInt(characters.length())));
    }
    return text.toString();
  }

  private static String characters(TestSpec.RandomStrings spec) {
    StringBuilder all = new StringBuilder();
    if (spec.alphabet()) {
      all.append(ALPHABET);
    }
    if (spec.number()) {
      all.append(DIGITS);
    }
    if (spec.specialCharacters()) {
      all.append(SPECIAL);
    }
    if (spec.space()) {
      all.append(' ');
    }
    StringBuilder allowed = new StringBuilder();
    all.chars()
        .filter(c -> spec.negativeCharacters().indexOf(c) < 0)
        .forEach(c -> allowed.append((char) c));
    return allowed.toString();
  }
}
