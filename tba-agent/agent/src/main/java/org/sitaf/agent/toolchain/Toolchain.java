package org.sitaf.agent.toolchain;

import java.util.Objects;
import org.sitaf.core.activity.ActivityProfile.Language;

/**
 * A language that this machine can compile and run.
 *
 * @param version of the compiler, such as {@code javac 17.0.15}
 */
public record Toolchain(Language language, String version) {
  public Toolchain {
    Objects.requireNonNull(language);
    Objects.requireNonNull(version);
  }

  @Override
  public String toString() {
    return language.spelling() + " (" + version + ")";
  }
}
