package org.sitaf.core.activity;

import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.diagnostic.Diagnostics;

/**
 * The sizes of fixed arrays. A test application holds every value of a case, and a fixed array has
 * all of its elements even if the case sets none of them.
 */
final class ArraySizes {
  private static final long MAX_ELEMENTS = 1_000_000;

  private ArraySizes() {}

  /** Reports the methods whose values hold more elements than a test application can. */
  static void verify(InterfaceDescription description, Diagnostics diagnostics) {
    for (Method method : description.methods()) {
      verify(description, method, "the return value", method.returnType(), diagnostics);
      for (Parameter parameter : method.parameters()) {
        verify(description, method, parameter.name(), parameter.type(), diagnostics);
      }
    }
  }

  private static void verify(
      InterfaceDescription description,
      Method method,
      String value,
      DataType type,
      Diagnostics diagnostics) {
    long elements = elements(type);
    if (elements > MAX_ELEMENTS) {
      diagnostics.error(
          description.source(),
          0,
          description.name() + "." + method.name(),
          "%s holds arrays of %,d elements, but a test application holds at most %,d"
              .formatted(value, elements, MAX_ELEMENTS));
    }
  }

  private static long elements(DataType type) {
    long own = 0;
    for (DataType part : type.parts()) {
      own = saturated(own + elements(part));
    }
    return type instanceof DataType.FixedArray array
        ? saturated(array.length() * Math.max(1, own))
        : type instanceof DataType.Sequence ? 0 : own;
  }

  private static long saturated(long elements) {
    return Math.min(elements, Integer.MAX_VALUE);
  }
}
