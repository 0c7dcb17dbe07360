package org.sitaf.server.build;

import java.util.Collection;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.suite.TestCase;
import org.sitaf.server.build.request.RecordedCases;
import org.sitaf.server.build.request.Requirement;
import org.sitaf.server.build.request.Requirements;
import org.sitaf.server.file.StoredFile;

/**
 * A test application that is stored with a build.
 *
 * @param language of the harness
 * @param cases number of cases
 * @param lastCase the highest number of a case
 */
record FrozenApplication(
    String language,
    Requirements requirements,
    Collection<StoredFile> files,
    int cases,
    int lastCase) {
  /** For builds whose application could not be generated. */
  static final FrozenApplication NONE =
      new FrozenApplication("", new Requirements(List.of()), List.of(), 0, 0);

  FrozenApplication {
    files = List.copyOf(files);
  }

  /**
   * Which cases are recorded; none if the application has no simulation.
   *
   * @param requested null for the default
   */
  RecordedCases recordedCases(@Nullable RecordedCases requested) {
    if (!requirements.all().contains(new Requirement.Simulation())) {
      return RecordedCases.NONE;
    }
    return requested == null ? RecordedCases.byDefault(cases) : requested;
  }

  static FrozenApplication of(
      TestApplication application, Requirements requirements, Collection<StoredFile> files) {
    return new FrozenApplication(
        application.activity().profile().harness().id(),
        requirements,
        files,
        application.suite().cases().size(),
        application.suite().cases().stream().mapToInt(TestCase::no).max().orElse(0));
  }
}
