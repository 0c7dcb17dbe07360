package org.sitaf.core.suite;

import java.util.Objects;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.Strength;

/**
 * The settings of a generation. The same model and settings give the same cases.
 *
 * @param effort fast, default or best
 * @param generator name and version of the generator
 * @param maxCases maximum number of cases; null if there is none
 * @param tuples with a maximum, what the cases cover
 */
public record Generation(
    Strength strength,
    InvalidValues invalidValues,
    long seed,
    String effort,
    String generator,
    @Nullable Integer maxCases,
    @Nullable Tuples tuples) {

  /** Covered tuples and all that are possible. */
  public record Tuples(long covered, long all) {
    private static final Pattern TEXT = Pattern.compile("(\\d{1,18})/(\\d{1,18})");

    /** The value in documents. */
    public String text() {
      return covered + "/" + all;
    }

    /**
     * Parses the value in a document.
     *
     * @throws IllegalArgumentException if it is not two numbers
     */
    public static Tuples parse(String text) {
      Matcher numbers = TEXT.matcher(text);
      if (!numbers.matches()) {
        throw new IllegalArgumentException("tuples must be covered/all, not '" + text + "'");
      }
      return new Tuples(Long.parseLong(numbers.group(1)), Long.parseLong(numbers.group(2)));
    }
  }

  /** The settings of a generation without a bound. */
  public Generation(
      Strength strength, InvalidValues invalidValues, long seed, String effort, String generator) {
    this(strength, invalidValues, seed, effort, generator, null, null);
  }

  public Generation {
    Objects.requireNonNull(strength);
    Objects.requireNonNull(invalidValues);
    Objects.requireNonNull(effort);
    Objects.requireNonNull(generator);
  }
}
