package org.sitaf.core.compare.result;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.lock.PackageChanges;
import org.sitaf.core.verdict.Provenance;
import org.sitaf.core.verdict.TestResult;

/**
 * The packages and tools that two versions do not share. They may be the reason for a difference
 * that looks like one of the component.
 */
public final class OtherTools {
  private OtherTools() {}

  /** One text for each, such as {@code numpy 2.4.0 -> 2.4.6}. */
  public static List<String> of(@Nullable TestResult base, @Nullable TestResult now) {
    if (base == null || now == null) {
      return List.of();
    }
    Provenance before = base.provenance();
    Provenance after = now.provenance();
    List<String> changes =
        new ArrayList<>(PackageChanges.between(before.packages(), after.packages()));
    if (!before.compiler().equals(after.compiler())) {
      changes.add(before.compiler() + " -> " + after.compiler());
    }
    if (!before.bridge().equals(after.bridge())) {
      changes.add("simulator " + before.bridge() + " -> " + after.bridge());
    }
    return changes;
  }
}
