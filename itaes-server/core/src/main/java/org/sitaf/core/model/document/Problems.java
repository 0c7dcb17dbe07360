package org.sitaf.core.model.document;

import java.math.BigDecimal;
import java.util.Optional;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.model.Decimals;

/** Collects the problems of one document, and reads texts that may be invalid. */
record Problems(String file, Diagnostics diagnostics) {

  void error(int line, String where, String message) {
    diagnostics.error(file, line, where, message);
  }

  /** The result of a reading; empty if it fails, which is reported. */
  <T> Optional<T> attempt(int line, String where, Supplier<T> reading) {
    try {
      return Optional.of(reading.get());
    } catch (IllegalArgumentException e) {
      error(line, where, String.valueOf(e.getMessage()));
      return Optional.empty();
    }
  }

  /** A number; 0 if there is no text. */
  static double number(@Nullable String text) {
    return text == null ? 0 : Decimals.parse(text).max(BigDecimal.valueOf(-1e300)).doubleValue();
  }

  /** The text without surrounding blanks; empty if there is none. */
  static String text(@Nullable String text) {
    return text == null ? "" : text.strip();
  }
}
