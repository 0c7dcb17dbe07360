package org.sitaf.core.activity;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * How the sources of a C++ component are compiled.
 *
 * @param packages system packages that pkg-config knows, each with an optional version: {@code
 *     fmt==9.1.0}
 * @param includes folders of headers, relative to the activity
 * @param defines macros: {@code NAME} or {@code NAME=VALUE}
 * @param standard the last two digits of the year of the C++ standard
 * @param flags further options of the compiler; see {@link CppBuildReader} for those allowed
 * @param cmake what the component's own CMake project builds; null if each source is compiled
 */
public record CppBuild(
    List<String> packages,
    List<String> includes,
    List<String> defines,
    int standard,
    List<String> flags,
    @Nullable CmakeTarget cmake) {
  /** The standard of the runtime and of the generated sources. */
  public static final int DEFAULT_STANDARD = 17;

  /** A component that says nothing about its build. */
  public static final CppBuild DEFAULT =
      new CppBuild(List.of(), List.of(), List.of(), DEFAULT_STANDARD, List.of(), null);

  public CppBuild {
    packages = List.copyOf(packages);
    includes = List.copyOf(includes);
    defines = List.copyOf(defines);
    flags = List.copyOf(flags);
  }

  /** The standard for generated sources, which include the component's headers. */
  public int standardOfHarness() {
    return Math.max(standard, DEFAULT_STANDARD);
  }
}
