package org.sitaf.core.activity;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.ActivityProfile.Component;
import org.sitaf.core.activity.ActivityProfile.Limits;
import org.sitaf.core.activity.hardware.DeviceBackend;
import org.sitaf.core.activity.ros.MessageSignals;
import org.sitaf.core.activity.ros.RosImplementation;
import org.sitaf.core.activity.ros.RosInterfaces;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.MemberPath;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.description.WorldSignals;
import org.sitaf.core.description.source.ComponentDescription.Port;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.suite.TestCaseGenerator;

/**
 * A verified test activity: everything that is needed to test one component.
 *
 * @param files all files, including {@code activity.yaml}
 * @param outputPorts output data ports declared in the component's profile
 * @param world null if the component needs no simulation
 * @param ros topics of a ROS 2 node; null for any other component
 * @param warnings problems that do not prevent the use of the activity
 */
public record Activity(
    ActivityProfile profile,
    FileTree files,
    List<InterfaceDescription> provided,
    List<InterfaceDescription> required,
    List<Port.Data> outputPorts,
    @Nullable WorldDescription world,
    List<TestModel> models,
    @Nullable RosInterfaces ros,
    List<Diagnostic> warnings) {
  /** How much slower than real time a case with an installed ROS 2 may be. */
  private static final int REAL_TIME_FACTOR = 4;

  private static final FileTree NO_PACKAGES = FileTree.of(Map.of());

  public Activity {
    Objects.requireNonNull(profile);
    Objects.requireNonNull(files);
    provided = List.copyOf(provided);
    required = List.copyOf(required);
    outputPorts = List.copyOf(outputPorts);
    models = List.copyOf(models);
    warnings = List.copyOf(warnings);
  }

  /**
   * Reads and verifies an activity.
   *
   * @throws org.sitaf.core.diagnostic.InvalidInputException with all problems of all documents
   */
  public static Activity read(FileTree files) {
    return read(files, NO_PACKAGES);
  }

  /**
   * Reads and verifies an activity.
   *
   * @param packages interface files of a ROS 2 release by {@code PACKAGE/msg/NAME.msg}, which the
   *     activity can use without containing them
   * @throws org.sitaf.core.diagnostic.InvalidInputException with all problems of all documents
   */
  public static Activity read(FileTree files, FileTree packages) {
    return new ActivityReader(files, packages).read();
  }

  /**
   * Reads and verifies an activity whose component or adapter may not exist yet.
   *
   * @throws org.sitaf.core.diagnostic.InvalidInputException with all problems of all documents
   */
  public static Activity readWithoutComponent(FileTree files) {
    return readWithoutComponent(files, NO_PACKAGES);
  }

  /**
   * Reads and verifies an activity whose component or adapter may not exist yet.
   *
   * @param packages as in {@link #read(FileTree, FileTree)}
   * @throws org.sitaf.core.diagnostic.InvalidInputException with all problems of all documents
   */
  public static Activity readWithoutComponent(FileTree files, FileTree packages) {
    return new ActivityReader(files, packages).readWithoutComponent();
  }

  /**
   * Resolves the types of a model by the interfaces of this activity. The model does not need to be
   * part of the activity.
   */
  public TestModel resolve(TestModel model) {
    return InterfaceTypes.resolve(model, provided, required, outputPorts);
  }

  /** Verifies a resolved model against this activity. Returns all problems. */
  public List<Diagnostic> verify(TestModel model) {
    List<Diagnostic> found = new ArrayList<>(TestCaseGenerator.verifyConditions(model));
    found.addAll(
        ModelAgainstActivity.verify(
            model,
            provided,
            required,
            world,
            outputPorts,
            profile,
            ros == null ? null : ros.messages()));
    return found;
  }

  /** The same activity with its reference as the component, without the files of the component. */
  public Activity ofReference() {
    return with(profile.ofReference(), profile.component().folders());
  }

  /**
   * The same activity without the files of the reference, which the component under test could
   * otherwise read.
   */
  public Activity withoutReferenceFiles() {
    Component reference = profile.reference();
    return reference == null ? this : with(profile, reference.folders());
  }

  /** The same activity without repeated calls, unless a model orders them. */
  public Activity withoutTiming() {
    return copy(profile.withoutTiming(), files, ros);
  }

  /** The same activity with another content of a source file of its component. */
  public Activity withSource(String path, byte[] content) {
    return copy(profile, files.with(path, content), ros);
  }

  /**
   * The same activity with another implementation of ROS 2.
   *
   * @throws InvalidInputException if its component does not run with it
   */
  public Activity with(RosImplementation implementation) {
    if (implementation == RosImplementation.INCLUDED) {
      return this;
    }
    if (ros == null) {
      throw InvalidInputException.of(
          "activity.yaml",
          "the component is no ROS 2 node, so it does not run with an installed ROS 2; omit --ros"
              + " system");
    }
    return copy(profile, files, ros.with(implementation));
  }

  /** What a ROS 2 node runs with; empty for other components. */
  public Optional<RosImplementation> rosImplementation() {
    return Optional.ofNullable(ros).map(interfaces -> interfaces.node().implementation());
  }

  /**
   * The limits of the profile. A case with an installed ROS 2, where time passes in real time or
   * slower, has more real time.
   */
  public Limits limits() {
    Limits limits = profile.limits();
    return rosImplementation().equals(Optional.of(RosImplementation.SYSTEM))
        ? limits.withCaseWall(
            limits.caseWall().plus(limits.caseSimulation().multipliedBy(REAL_TIME_FACTOR)))
        : limits;
  }

  private Activity with(ActivityProfile other, List<String> hidden) {
    List<String> kept = other.component().folders();
    Map<String, byte[]> visible = new HashMap<>();
    for (String path : files.paths()) {
      if (isBelow(path, kept) || !isBelow(path, hidden)) {
        visible.put(path, files.content(path).orElseThrow());
      }
    }
    return copy(other, FileTree.of(visible), ros);
  }

  private Activity copy(
      ActivityProfile newProfile, FileTree newFiles, @Nullable RosInterfaces newRos) {
    return new Activity(
        newProfile, newFiles, provided, required, outputPorts, world, models, newRos, warnings);
  }

  private static boolean isBelow(String path, List<String> folders) {
    return folders.stream()
        .map(folder -> folder.endsWith("/") ? folder : folder + "/")
        .anyMatch(path::startsWith);
  }

  /** The interfaces whose calls a test application records: the required ones, and the topics. */
  public List<InterfaceDescription> recorded() {
    if (ros == null) {
      return required;
    }
    List<InterfaceDescription> recorded = new ArrayList<>(required);
    recorded.add(ros.messages());
    return recorded;
  }

  /** The numbers in messages that trajectory conditions can use; none without a ROS 2 node. */
  public List<String> messageSignals() {
    return ros == null ? List.of() : MessageSignals.of(ros.messages());
  }

  /** The names of all signals that are single values, for the trajectory conditions of a model. */
  public List<String> signals(TestModel model) {
    List<String> all = new ArrayList<>(world == null ? List.of() : WorldSignals.of(world));
    all.addAll(DeviceBackend.signals(profile.hardware()));
    all.addAll(messageSignals());
    all.addAll(PortSignals.of(outputPorts));
    if (model.sequence() != null && !all.contains(SequenceSpec.STEP)) {
      all.add(SequenceSpec.STEP);
    }
    return all;
  }

  /**
   * The signals that are lists of numbers, with their lengths, for the trajectory conditions of a
   * model.
   */
  public Map<String, Integer> signalLists(TestModel model) {
    Map<String, Integer> lists = new TreeMap<>(PortSignals.lists(outputPorts));
    if (world != null) {
      lists.putAll(WorldSignals.lists(world));
    }
    if (ros != null && model.sequence() == null) {
      lists.putAll(MessageSignals.lists(ros.messages()));
    }
    return lists;
  }

  /**
   * The interface whose calls are the messages of a ROS 2 node.
   *
   * @throws IllegalStateException without a ROS 2 node
   */
  public InterfaceDescription recordedMessages() {
    if (ros == null) {
      throw new IllegalStateException("the component is no ROS 2 node");
    }
    return ros.messages();
  }

  /** The output data port of an observed output. */
  public Optional<Port.Data> outputPort(String output) {
    return OutputPorts.named(outputPorts, output);
  }

  /**
   * The type of an output of a model's target: as the interface declares, else as the model says;
   * {@link DataType.Unknown} if neither knows the output. The model of a whole sequence often names
   * the type of its elements only.
   */
  public DataType outputType(TestModel model, String output) {
    return declaredType(model, output)
        .filter(type -> !(type instanceof DataType.Unknown))
        .or(() -> model.output(output).map(OutputElement::type))
        .orElse(new DataType.Unknown(output));
  }

  private Optional<DataType> declaredType(TestModel model, String output) {
    try {
      Method method = TargetMethod.find(model, provided).method();
      String root = MemberPath.root(output);
      Optional<DataType> whole =
          root.equals(OutputElement.RETURN_NAME)
              ? Optional.of(method.returnType())
              : method.parameters().stream()
                  .filter(p -> p.name().equals(root))
                  .map(Parameter::type)
                  .findFirst();
      return whole.flatMap(type -> MemberPath.resolve(type, output));
    } catch (IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  /** Finds a model by name. */
  public Optional<TestModel> model(String name) {
    return models.stream().filter(m -> m.name().equals(name)).findFirst();
  }
}
