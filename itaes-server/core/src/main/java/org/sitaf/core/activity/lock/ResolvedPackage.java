package org.sitaf.core.activity.lock;

import java.util.Objects;

/**
 * A package that a test application uses, directly or through another package.
 *
 * @param name normalised name of a Python package, or {@code GROUP:ARTIFACT} of a Maven package,
 *     with {@code :CLASSIFIER} if there is one
 * @param version the exact release
 * @param sha256 of the downloaded file in hexadecimal
 */
public record ResolvedPackage(String name, String version, String sha256)
    implements Comparable<ResolvedPackage> {
  public ResolvedPackage {
    Objects.requireNonNull(name);
    Objects.requireNonNull(version);
    Objects.requireNonNull(sha256);
  }

  /** Whether this is a Maven package and not a Python package. */
  public boolean isMaven() {
    return name.indexOf(':') >= 0;
  }

  @Override
  public int compareTo(ResolvedPackage other) {
    int byName = name.compareTo(other.name);
    int byVersion = byName == 0 ? version.compareTo(other.version) : byName;
    return byVersion == 0 ? sha256.compareTo(other.sha256) : byVersion;
  }
}
