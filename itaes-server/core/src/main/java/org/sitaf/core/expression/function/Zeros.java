package org.sitaf.core.expression.function;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Values without a negative zero. */
final class Zeros {
  private Zeros() {}

  /** The value with 0.0 for each -0.0 in it; the same object if there is none. */
  static Object unsigned(Object value) {
    if (value instanceof Double number) {
      return number == 0 ? (Object) 0.0 : number;
    }
    if (value instanceof List<?> list) {
      return list(list);
    }
    return value instanceof Map<?, ?> map ? map(map) : value;
  }

  private static Object list(List<?> list) {
    List<Object> changed = null;
    int index = 0;
    for (Object element : list) {
      Object other = unsigned(element);
      if (changed == null && isOther(element, other)) {
        changed = new ArrayList<>(list);
      }
      if (changed != null) {
        changed.set(index, other);
      }
      index++;
    }
    return changed == null ? list : changed;
  }

  private static Object map(Map<?, ?> map) {
    Map<Object, Object> changed = null;
    for (Map.Entry<?, ?> entry : map.entrySet()) {
      Object other = unsigned(entry.getValue());
      if (isOther(entry.getValue(), other)) {
        changed = changed == null ? new LinkedHashMap<>(map) : changed;
        changed.put(entry.getKey(), other);
      }
    }
    return changed == null ? map : changed;
  }

  private static boolean isOther(Object before, Object after) {
    return before instanceof Double ? !before.equals(after) : before != after;
  }
}
