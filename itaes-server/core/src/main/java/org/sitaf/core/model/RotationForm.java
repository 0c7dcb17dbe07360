package org.sitaf.core.model;

import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;

/** How a rotation is written as numbers. */
public enum RotationForm {
  /** The cells x, y, z, w. */
  QUATERNION_XYZW,
  /** The cells w, x, y, z. */
  QUATERNION_WXYZ,
  /** Nine cells by rows, or three rows. */
  MATRIX,
  /** Roll, pitch and yaw about fixed x, y and z, in radians. */
  RPY;

  /** The name in documents. */
  public String text() {
    return name().toLowerCase(Locale.ROOT);
  }

  /**
   * Parses the name in a document.
   *
   * @throws IllegalArgumentException if there is no such form
   */
  public static RotationForm parse(String text) {
    return Arrays.stream(values())
        .filter(form -> form.text().equals(text))
        .findFirst()
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    "must be "
                        + Arrays.stream(values())
                            .map(RotationForm::text)
                            .collect(Collectors.joining(", "))
                        + ", not '"
                        + text
                        + "'"));
  }
}
