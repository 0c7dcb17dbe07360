package org.sitaf.core.activity;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/**
 * The test profile (paper, Fig. 13): what {@code activity.yaml} says.
 *
 * @param provided interface files of the component, relative to the activity
 * @param required interface files that the stub implements
 * @param libraries external libraries, relative to the activity
 * @param harness language of the generated test application
 * @param world the world description; null where the component needs no simulation
 * @param models test models, relative to the activity
 * @param parallel whether cases may run in several simulations at once
 */
public record ActivityProfile(
    String name,
    String description,
    Component component,
    List<String> provided,
    List<String> required,
    List<String> libraries,
    Language harness,
    @Nullable String world,
    List<String> models,
    boolean parallel,
    Limits limits) {
  public ActivityProfile {
    Objects.requireNonNull(name);
    Objects.requireNonNull(description);
    Objects.requireNonNull(component);
    Objects.requireNonNull(harness);
    Objects.requireNonNull(limits);
    provided = List.copyOf(provided);
    required = List.copyOf(required);
    libraries = List.copyOf(libraries);
    models = List.copyOf(models);
  }

  /** Language of a component or of a test application. */
  public enum Language {
    JAVA,
    CPP,
    PYTHON;

    /** As documents spell it. */
    public String spelling() {
      return name().toLowerCase(java.util.Locale.ROOT);
    }
  }

  /** When a component is made and destroyed. */
  public enum LifeCycle {
    /** Anew for each case. */
    CASE,
    /** Once for all cases. */
    SUITE
  }

  /**
   * The component under test.
   *
   * @param sources folder of sources; null where a library or a package is given
   * @param library built library; null where sources or a package are given
   * @param headers folder of headers of a C++ library, or null
   * @param header the header that declares a C++ class, as an include names it; null where it is
   *     found by its content
   * @param packageName package of the language's ecosystem; null where sources or a library are
   *     given
   * @param className class, qualified as its language writes it
   * @param adapter folder of the adapter's sources, or null
   * @param profile component profile, or null
   * @param properties set before the first call, by name
   * @param period null for a passive component
   * @param before calls before the one under test, as written
   */
  public record Component(
      Language language,
      @Nullable String sources,
      @Nullable String library,
      @Nullable String headers,
      @Nullable String header,
      @Nullable String packageName,
      String className,
      @Nullable String adapter,
      @Nullable String profile,
      Map<String, String> properties,
      LifeCycle lifeCycle,
      @Nullable Duration period,
      List<String> before) {
    public Component {
      Objects.requireNonNull(language);
      Objects.requireNonNull(className);
      Objects.requireNonNull(lifeCycle);
      properties = java.util.Collections.unmodifiableMap(new TreeMap<>(properties));
      before = List.copyOf(before);
    }
  }

  /**
   * Bounds of a build and its cases.
   *
   * @param caseWall wall-clock time of a case
   * @param caseSimulation simulation time of a case
   * @param memoryMiB memory of the test application
   * @param preparation wall-clock time in which the packages of the component are fetched, built
   *     and installed
   */
  public record Limits(
      Duration caseWall, Duration caseSimulation, int memoryMiB, Duration preparation) {
    /** What holds where the profile is silent. */
    public static final Limits DEFAULT =
        new Limits(Duration.ofSeconds(10), Duration.ofSeconds(60), 1024, Duration.ofMinutes(5));

    public Limits {
      if (caseWall.isZero()
          || caseWall.isNegative()
          || caseSimulation.isZero()
          || caseSimulation.isNegative()
          || memoryMiB < 1
          || preparation.isZero()
          || preparation.isNegative()) {
        throw new IllegalArgumentException("limits must be above 0");
      }
    }
  }
}
