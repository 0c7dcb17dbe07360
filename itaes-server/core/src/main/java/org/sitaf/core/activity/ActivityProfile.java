package org.sitaf.core.activity;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.hardware.DeviceBackend;
import org.sitaf.core.activity.ros.RosNode;
import org.sitaf.core.timing.Timing;

/**
 * The test profile (paper, Fig. 13): the content of {@code activity.yaml}.
 *
 * @param reference a second implementation of the same interface, whose outputs are the expected
 *     values where a model has none; null if there is none
 * @param provided interface files of the component, relative to the activity
 * @param required interface files that the stub implements
 * @param libraries external libraries, relative to the activity
 * @param idlIncludes folders in which included IDL files are searched, relative to the activity
 * @param harness language of the generated test application
 * @param world the world description; null if the component needs no simulation
 * @param models test models, relative to the activity
 * @param parallel whether cases may run in several simulations at once
 * @param timing how often the call of each case is repeated, unless the model says; null for never
 * @param sanitizers with which a C++ component and its test application are compiled
 * @param ros what only ROS 2 nodes have; null for any other component
 * @param hardware the devices that are not simulated
 */
public record ActivityProfile(
    String name,
    String description,
    Component component,
    @Nullable Component reference,
    List<String> provided,
    List<String> required,
    List<String> libraries,
    List<String> idlIncludes,
    Language harness,
    @Nullable String world,
    List<String> models,
    boolean parallel,
    Set<Sanitizer> sanitizers,
    @Nullable Timing timing,
    @Nullable RosNode ros,
    List<DeviceBackend> hardware,
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
    idlIncludes = List.copyOf(idlIncludes);
    models = List.copyOf(models);
    hardware = List.copyOf(hardware);
    sanitizers = java.util.Collections.unmodifiableSet(new TreeSet<>(sanitizers));
  }

  /**
   * The profile of the test application of the reference, in the reference's language.
   *
   * @throws IllegalStateException if there is no reference
   */
  public ActivityProfile ofReference() {
    Component second = reference;
    if (second == null) {
      throw new IllegalStateException("the activity has no reference");
    }
    return copy(
        second,
        null,
        second.language(),
        second.language() == Language.CPP ? sanitizers : Set.of(),
        null);
  }

  /** The same profile without repeated calls. */
  public ActivityProfile withoutTiming() {
    return copy(component, reference, harness, sanitizers, null);
  }

  private ActivityProfile copy(
      Component newComponent,
      @Nullable Component newReference,
      Language newHarness,
      Set<Sanitizer> newSanitizers,
      @Nullable Timing newTiming) {
    return new ActivityProfile(
        name,
        description,
        newComponent,
        newReference,
        provided,
        required,
        libraries,
        idlIncludes,
        newHarness,
        world,
        models,
        parallel,
        newSanitizers,
        newTiming,
        ros,
        hardware,
        limits);
  }

  /** Language of a component or of a test application. */
  public enum Language {
    JAVA,
    CPP,
    PYTHON;

    /** The name in documents, in lower case. */
    public String id() {
      return name().toLowerCase(java.util.Locale.ROOT);
    }
  }

  /** Checks that a C++ compiler adds to a program. */
  public enum Sanitizer {
    /** Invalid accesses to memory: AddressSanitizer. */
    ADDRESS,
    /** Undefined behaviour, such as an overflow of a signed integer: UBSan. */
    UNDEFINED,
    /** Accesses of several threads without an order: ThreadSanitizer. */
    THREAD;

    /** The name in documents, and in the option {@code -fsanitize} of compilers. */
    public String id() {
      return name().toLowerCase(java.util.Locale.ROOT);
    }
  }

  /** When a component is created and destroyed. */
  public enum LifeCycle {
    /** A new component for each case. */
    CASE,
    /** One component for all cases. */
    SUITE
  }

  /**
   * The component under test.
   *
   * @param sources folder of sources; null with a library or package
   * @param library compiled library; null with sources or a package
   * @param headers folder of headers of a C++ library, or null
   * @param header include path of the header that declares a C++ class; null to search it
   * @param packageName package of the language's package manager; null with sources or a library
   * @param className qualified class name in the syntax of the language
   * @param adapter folder of the adapter's sources, or null
   * @param profile component profile, or null
   * @param properties property values by name, set before the first call
   * @param period null for a passive component
   * @param before calls before the call under test, as written
   * @param cpp how a C++ component is compiled
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
      List<String> before,
      CppBuild cpp) {
    public Component {
      Objects.requireNonNull(language);
      Objects.requireNonNull(className);
      Objects.requireNonNull(lifeCycle);
      properties = java.util.Collections.unmodifiableMap(new TreeMap<>(properties));
      before = List.copyOf(before);
      Objects.requireNonNull(cpp);
    }

    /** A component that says nothing about how C++ is compiled. */
    public Component(
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
      this(
          language,
          sources,
          library,
          headers,
          header,
          packageName,
          className,
          adapter,
          profile,
          properties,
          lifeCycle,
          period,
          before,
          CppBuild.DEFAULT);
    }

    /** The folders of its sources and of its adapter in the activity. */
    public List<String> folders() {
      return Stream.of(sources, adapter).filter(Objects::nonNull).toList();
    }
  }

  /**
   * Limits of a build and its cases.
   *
   * @param caseWall maximum wall-clock time of a case
   * @param caseSimulation maximum simulation time of a case
   * @param memoryMiB maximum memory of the test application
   * @param preparation maximum wall-clock time for fetching, building and installing the packages
   *     of the component
   * @param jitter maximum time by which simulation time is late on the wall clock in a case with
   *     real devices; beyond it the case is not judged
   */
  public record Limits(
      Duration caseWall,
      Duration caseSimulation,
      int memoryMiB,
      Duration preparation,
      Duration jitter) {
    /** The default limits. */
    public static final Limits DEFAULT =
        new Limits(
            Duration.ofSeconds(10),
            Duration.ofSeconds(60),
            1024,
            Duration.ofMinutes(5),
            Duration.ofMillis(20));

    public Limits {
      if (caseWall.isZero()
          || caseWall.isNegative()
          || caseSimulation.isZero()
          || caseSimulation.isNegative()
          || memoryMiB < 1
          || preparation.isZero()
          || preparation.isNegative()
          || jitter.isZero()
          || jitter.isNegative()) {
        throw new IllegalArgumentException("limits must be greater than 0");
      }
    }

    /** The same limits with another time for a case. */
    public Limits withCaseWall(Duration limit) {
      return new Limits(limit, caseSimulation, memoryMiB, preparation, jitter);
    }
  }
}
