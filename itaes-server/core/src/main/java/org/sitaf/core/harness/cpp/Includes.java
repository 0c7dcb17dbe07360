package org.sitaf.core.harness.cpp;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.sitaf.core.description.DataType;
import org.sitaf.core.harness.cpp.spelling.CppType;

/** The headers that a file needs: the standard library's first, then those of the test. */
final class Includes {
  private final SortedSet<String> standard = new TreeSet<>();
  private final SortedSet<String> own = new TreeSet<>();

  Includes standard(String... headers) {
    standard.addAll(List.of(headers));
    return this;
  }

  Includes own(String... headers) {
    own.addAll(List.of(headers));
    return this;
  }

  Includes types(List<DataType> types) {
    types.forEach(type -> CppType.addHeaders(type, standard, own));
    return this;
  }

  /** The lines, with an empty one between the two kinds and behind them. */
  List<String> lines() {
    List<String> lines = new ArrayList<>();
    standard.forEach(header -> lines.add("#include <" + header + ">"));
    if (!standard.isEmpty() && !own.isEmpty()) {
      lines.add("");
    }
    own.forEach(header -> lines.add("#include \"" + header + "\""));
    if (!lines.isEmpty()) {
      lines.add("");
    }
    return lines;
  }
}
