package org.sitaf.core.activity;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.description.source.ComponentDescription.Port;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestCaseGenerator;

/**
 * A test activity, read and verified: everything that a test of one component needs.
 *
 * @param files all files, {@code activity.yaml} among them
 * @param outputPorts data ports through which the component sends, as its profile declares them
 * @param world null where the component needs no simulation
 * @param warnings what was found and does not keep the activity from being used
 */
public record Activity(
    ActivityProfile profile,
    FileTree files,
    List<InterfaceDescription> provided,
    List<InterfaceDescription> required,
    List<Port.Data> outputPorts,
    @Nullable WorldDescription world,
    List<TestModel> models,
    List<Diagnostic> warnings) {
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
   * Reads an activity and verifies all of it.
   *
   * @throws org.sitaf.core.diagnostic.InvalidInputException with every problem of every document
   */
  public static Activity read(FileTree files) {
    return new ActivityReader(files).read();
  }

  /**
   * Reads an activity whose component, or the adapter to it, is not written yet: all of it is
   * verified but that these are there.
   *
   * @throws org.sitaf.core.diagnostic.InvalidInputException with every problem of every document
   */
  public static Activity readWithoutComponent(FileTree files) {
    return new ActivityReader(files).readWithoutComponent();
  }

  /**
   * A model as it stands in this activity, which need not hold it: its enumerations get their
   * literals from the interfaces.
   */
  public TestModel resolve(TestModel model) {
    return InterfaceTypes.resolve(model, provided, required, outputPorts);
  }

  /** What keeps a resolved model from being used with this activity; empty where nothing does. */
  public List<Diagnostic> verify(TestModel model) {
    List<Diagnostic> found = new ArrayList<>(TestCaseGenerator.verifyConditions(model));
    found.addAll(ModelAgainstActivity.verify(model, provided, required, world, outputPorts));
    return found;
  }

  /** The output data port that an observed output is, or is a part of. */
  public Optional<Port.Data> outputPort(String output) {
    return OutputPorts.named(outputPorts, output);
  }

  /** The model of a name. */
  public Optional<TestModel> model(String name) {
    return models.stream().filter(m -> m.name().equals(name)).findFirst();
  }
}
