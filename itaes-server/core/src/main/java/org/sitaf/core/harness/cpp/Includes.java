package org.sitaf.core.harness.cpp;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import org.sitaf.core.description.DataType;
import org.sitaf.core.harness.cpp.syntax.CppType;

/** The includes of a file: first the standard library, then headers of the test. */
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

  /** The lines, with an empty line after each of the two groups. */
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
