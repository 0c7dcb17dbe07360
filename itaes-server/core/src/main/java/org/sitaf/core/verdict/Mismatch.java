package org.sitaf.core.verdict;

import java.util.Objects;

/**
 * A difference between a recorded and an expected value.
 *
 * @param verdict FAIL for a wrong value; ERROR if the expected value does not fit the output's type
 *     and cannot be compared
 * @param path to the difference within the value, such as {@code [3].x}; empty for the value itself
 * @param text description of the difference
 */
record Mismatch(Verdict verdict, String path, String text) {
  Mismatch {
    Objects.requireNonNull(verdict);
    Objects.requireNonNull(path);
    Objects.requireNonNull(text);
  }
}
