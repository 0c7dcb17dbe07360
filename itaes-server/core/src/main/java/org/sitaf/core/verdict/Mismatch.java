package org.sitaf.core.verdict;

import java.util.Objects;

/**
 * Why a recorded value is not as expected.
 *
 * @param verdict FAIL for a wrong value; ERROR where the expected value does not fit the output's
 *     type, so that nothing can be compared
 * @param path to the difference within the value, such as {@code [3].x}; empty for the value itself
 * @param text what differs
 */
record Mismatch(Verdict verdict, String path, String text) {
  Mismatch {
    Objects.requireNonNull(verdict);
    Objects.requireNonNull(path);
    Objects.requireNonNull(text);
  }
}
