package org.sitaf.core.harness;

import java.util.List;
import java.util.Map;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.ActivityProfile.Component;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.cpp.CppHarness;
import org.sitaf.core.harness.java.JavaHarness;
import org.sitaf.core.harness.plan.HarnessPlan;
import org.sitaf.core.harness.plan.HarnessPlanner;
import org.sitaf.core.harness.plan.HarnessWriter;
import org.sitaf.core.harness.python.PythonHarness;
import org.sitaf.core.harness.ros.RosHarness;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestSuite;

/**
 * Interface Test Application Generator (ITAG): generates the sources of a test application from an
 * activity, a test model and its cases (paper, section 3.2 and Fig. 10).
 */
public final class InterfaceTestApplicationGenerator {
  private InterfaceTestApplicationGenerator() {}

  /**
   * Generates the test application of a model. The same documents give the same bytes. A concrete
   * test driver in the activity replaces the generated one.
   *
   * @throws InvalidInputException with everything that cannot be tested or expressed in the
   *     language of the harness
   */
  public static TestApplication generate(Activity activity, TestModel model, TestSuite suite) {
    HarnessWriter writer = writer(activity);
    FileTree sources = sources(activity, model, suite);
    FileTree withKept =
        activity
            .files()
            .content(keptDriver(activity, model))
            .map(kept -> sources.with(writer.editableFile(model.name()), kept))
            .orElse(sources);
    return new TestApplication(activity, model, suite, withKept, writer.entryPoint(model.name()));
  }

  /**
   * Generates the application that executes the cases with the reference instead of the component.
   * A concrete test driver in the activity is the component's, so it is not used.
   *
   * @throws IllegalStateException if the activity has no reference
   * @throws InvalidInputException as {@link #generate}
   */
  public static TestApplication ofReference(TestApplication application) {
    Activity activity = application.activity().ofReference();
    TestModel model = application.model().withoutTiming().withoutRelations();
    TestSuite suite = application.suite().withoutExpected();
    return new TestApplication(
        activity,
        model,
        suite,
        sources(activity, model, suite),
        writer(activity).entryPoint(model.name()));
  }

  /**
   * Generates only the sources. The concrete test driver is always the generated one.
   *
   * @throws InvalidInputException as {@link #generate}
   */
  public static FileTree sources(Activity activity, TestModel model, TestSuite suite) {
    if (activity.ros() != null) {
      return RosHarness.write(activity, model, suite);
    }
    Diagnostics diagnostics = new Diagnostics();
    HarnessPlan plan = HarnessPlanner.plan(activity, model, suite, diagnostics);
    FileTree sources = writer(activity).write(plan, diagnostics);
    diagnostics.throwIfErrors();
    return sources;
  }

  /**
   * The names of the methods that the cases call, in the order of the model.
   *
   * @throws InvalidInputException as {@link #generate}
   */
  public static List<String> methodsUnderTest(Activity activity, TestModel model, TestSuite suite) {
    Diagnostics diagnostics = new Diagnostics();
    HarnessPlan plan = HarnessPlanner.plan(activity, model, suite, diagnostics);
    diagnostics.throwIfErrors();
    HarnessPlan.Sequence sequence = plan.sequence();
    return sequence == null
        ? List.of(plan.method().name())
        : sequence.calls().stream().map(step -> step.call().method().name()).distinct().toList();
  }

  /**
   * The path of the user's concrete test driver in an activity: {@code harness/MODEL/} and the name
   * of the {@link #editableFile}.
   */
  public static String keptDriver(Activity activity, TestModel model) {
    String editable = editableFile(activity, model);
    return "harness/" + model.name() + "/" + editable.substring(editable.lastIndexOf('/') + 1);
  }

  /** The path of the generated file that the user may replace by {@link #keptDriver}. */
  public static String editableFile(Activity activity, TestModel model) {
    return writer(activity).editableFile(model.name());
  }

  /**
   * Generates the skeleton of an adapter between a component and the interfaces of its test, in the
   * component's language: a class with all methods, which the user completes.
   *
   * @return the sources by path in the activity
   * @throws InvalidInputException if the activity has no adapter or the language cannot express it
   */
  public static FileTree adapter(Activity activity) {
    Component component = activity.profile().component();
    if (component.adapter() == null) {
      throw InvalidInputException.of(
          HarnessPlanner.PROFILE,
          "component.adapter is missing; set it to a folder, such as adapter: adapter/, and set"
              + " class: to the class of the adapter");
    }
    return skeleton(activity, "adapter", component.adapter());
  }

  /**
   * Generates the skeleton of a component that implements the interfaces itself: a class whose
   * methods return zero values until the user writes them.
   *
   * @return the sources by path in the activity
   * @throws InvalidInputException if the language cannot express the interfaces
   */
  public static FileTree component(Activity activity) {
    Component component = activity.profile().component();
    if (component.sources() == null || component.adapter() != null) {
      throw new IllegalArgumentException("the component needs sources, and no adapter");
    }
    return skeleton(activity, "sources", component.sources());
  }

  private static FileTree skeleton(Activity activity, String key, String folder) {
    Diagnostics diagnostics = new Diagnostics();
    HarnessPlan.Adapter plan = HarnessPlanner.adapter(activity, diagnostics);
    diagnostics.throwIfErrors();
    FileTree sources =
        writer(activity.profile().component().language(), activity).adapter(plan, diagnostics);
    diagnostics.throwIfErrors();
    try {
      return FileTree.of(Map.of()).with(folder, sources);
    } catch (IllegalArgumentException e) {
      throw InvalidInputException.of(
          HarnessPlanner.PROFILE, "component." + key + ": " + e.getMessage());
    }
  }

  private static HarnessWriter writer(Activity activity) {
    return writer(activity.profile().harness(), activity);
  }

  private static HarnessWriter writer(Language language, Activity activity) {
    return switch (language) {
      case JAVA -> new JavaHarness();
      case CPP -> new CppHarness(activity);
      case PYTHON -> new PythonHarness();
    };
  }
}
