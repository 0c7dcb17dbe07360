package org.sitaf.cli.option;

import java.nio.file.Path;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.TestModel;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** The parameters ACTIVITY_DIR and --model, shared by several commands. */
public final class ActivityArguments {
  @Parameters(paramLabel = "ACTIVITY_DIR", description = "Folder of activity.yaml.")
  private Path folder = Path.of("");

  @Option(
      names = "--model",
      paramLabel = "NAME",
      description = "The test model; default: all models of the activity.")
  private @Nullable String model;

  public Path folder() {
    return folder;
  }

  /** Whether the option is given. */
  public boolean namesModel() {
    return model != null;
  }

  /**
   * The model of the option, or all models of the activity.
   *
   * @throws InvalidInputException if the activity has no such model, or no model
   */
  public List<TestModel> modelsOf(Activity activity) {
    List<TestModel> all = activity.models();
    if (all.isEmpty()) {
      throw InvalidInputException.of(folder.toString(), "names no test model in activity.yaml");
    }
    if (model == null) {
      return all;
    }
    return List.of(
        activity
            .model(model)
            .orElseThrow(
                () ->
                    InvalidInputException.of(
                        "--model " + model,
                        "does not exist; "
                            + folder
                            + " has "
                            + String.join(", ", all.stream().map(TestModel::name).toList()))));
  }

  /**
   * The models for a command that changes the inputs of single calls.
   *
   * @param command such as {@code falsify}
   * @throws InvalidInputException as {@link #modelsOf}, and if a model has sequences of calls
   */
  public List<TestModel> modelsOfSingleCalls(Activity activity, String command) {
    List<TestModel> models = modelsOf(activity);
    for (TestModel each : models) {
      if (each.sequence() != null) {
        throw InvalidInputException.of(
            each.source(),
            "./sitaf "
                + command
                + " does not support models with a sequence_spec; select another model by --model,"
                + " or execute this one by ./sitaf run");
      }
    }
    return models;
  }
}
