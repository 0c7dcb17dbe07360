package org.sitaf.cli;

import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;
import picocli.CommandLine.TypeConversionException;

/** Options that take one of a few words, written small. */
final class Words {
  private Words() {}

  static <E extends Enum<E>> E parse(String word, E[] choices) {
    return Arrays.stream(choices)
        .filter(choice -> spelling(choice).equals(word))
        .findFirst()
        .orElseThrow(
            () ->
                new TypeConversionException(
                    "must be one of "
                        + Arrays.stream(choices)
                            .map(Words::spelling)
                            .collect(Collectors.joining(", "))
                        + ", not '"
                        + word
                        + "'"));
  }

  private static String spelling(Enum<?> choice) {
    return choice.name().toLowerCase(Locale.ROOT);
  }
}
