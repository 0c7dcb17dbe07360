package org.sitaf.core.activity;

import java.util.Collections;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;

/**
 * A library that the CMake project of a C++ component builds. The project's folder is the folder of
 * the component's sources.
 *
 * @param name a library target of the project
 * @param options cache variables, as with {@code cmake -D}
 */
public record CmakeTarget(String name, Map<String, String> options) {
  public CmakeTarget {
    Objects.requireNonNull(name);
    options = Collections.unmodifiableMap(new TreeMap<>(options));
  }
}
