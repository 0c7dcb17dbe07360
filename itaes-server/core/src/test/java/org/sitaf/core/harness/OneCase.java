package org.sitaf.core.harness;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.ActivityProfile;
import org.sitaf.core.activity.ActivityProfile.Component;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.ActivityProfile.LifeCycle;
import org.sitaf.core.activity.ActivityProfile.Limits;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.Strength;
import org.sitaf.core.model.Target;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.Generation;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;

/**
 * A test application with one case, which calls the first method of the first provided interface.
 * For tests of texts and names in generated sources.
 *
 * @param className class of the component
 * @param description description of activity and model
 * @param before set-up calls of the component
 * @param files files of the activity
 */
public record OneCase(
    Language language,
    String className,
    String modelName,
    String description,
    Map<String, String> properties,
    List<String> before,
    FileTree files,
    List<InterfaceDescription> provided,
    List<InterfaceDescription> required,
    List<CaseParameter> columns,
    List<String> values) {
  /** Generates the test application. */
  public TestApplication application() {
    TestModel model = model();
    TestSuite suite =
        new TestSuite(
            "s",
            "",
            modelName,
            new Generation(new Strength(1), InvalidValues.ISOLATE, 1, "default", "test"),
            columns,
            List.of(new TestCase(1, true, values, List.of())));
    Activity activity =
        new Activity(
            profile(), files, provided, required, List.of(), null, List.of(model), null, List.of());
    return InterfaceTestApplicationGenerator.generate(activity, model, suite);
  }

  private TestModel model() {
    InterfaceDescription target = provided.get(0);
    return new TestModel(
        modelName,
        description,
        new Target(
            target.name(), target.methods().get(0).name(), null, Duration.ZERO, Duration.ZERO),
        List.of(),
        Map.of(),
        List.of(),
        List.of(),
        List.of(),
        List.of(),
        List.of(),
        List.of(),
        InvalidValues.ISOLATE,
        new Strength(1),
        List.of(),
        List.of(),
        TestModel.UNBOUNDED,
        null,
        "model.xml");
  }

  private ActivityProfile profile() {
    Component component =
        new Component(
            language,
            "component/",
            null,
            null,
            null,
            null,
            className,
            null,
            null,
            properties,
            LifeCycle.CASE,
            null,
            before);
    return new ActivityProfile(
        "echo",
        description,
        component,
        null,
        List.of("provided.xml"),
        required.isEmpty() ? List.of() : List.of("required.xml"),
        List.of(),
        List.of(),
        language,
        null,
        List.of("model.xml"),
        false,
        Set.of(),
        null,
        null,
        List.of(),
        Limits.DEFAULT);
  }
}
