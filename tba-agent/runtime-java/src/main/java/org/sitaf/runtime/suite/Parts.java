package org.sitaf.runtime.suite;

import java.lang.reflect.RecordComponent;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/** Finds a part of an output by its name: {@code pose.position.x}, {@code path[3]}. */
final class Parts {
  private static final Pattern STEP = Pattern.compile("\\.(\\w+)|\\[(\\d+)]");

  private Parts() {}

  /** The named part of a value; empty when there is none. */
  static Optional<Object> of(@Nullable Object whole, String name) {
    Object part = whole;
    Matcher step = STEP.matcher(name);
    while (part != null && step.find()) {
      part =
          step.group(1) != null
              ? member(part, step.group(1))
              : element(part, Integer.parseInt(step.group(2)));
    }
    return Optional.ofNullable(part);
  }

  /** A member of a record; null when it has no such member. */
  static @Nullable Object member(Object value, String name) {
    if (value.getClass().isRecord()) {
      for (RecordComponent component : value.getClass().getRecordComponents()) {
        if (DocumentNames.of(component).equals(name)) {
          return read(component, value);
        }
      }
    }
    return null;
  }

  static @Nullable Object read(RecordComponent component, Object value) {
    try {
      return component.getAccessor().invoke(value);
    } catch (ReflectiveOperationException e) {
      throw new CaseDataException(
          value.getClass().getName() + "." + component.getName() + " cannot be read", e);
    }
  }

  private static @Nullable Object element(Object value, int index) {
    var elements = Literals.elementsOf(value);
    return elements != null && index < elements.size() ? elements.get(index) : null;
  }
}
