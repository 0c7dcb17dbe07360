package org.sitaf.core.harness.java;

import com.samskivert.mustache.Mustache;
import com.samskivert.mustache.Template;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.java.plan.HarnessPlan;
import org.sitaf.core.harness.java.plan.HarnessPlanner;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestSuite;

/**
 * The Java sources of a test application: test driver, simulation control, test stub, and the
 * concrete test driver that the user may edit (paper, Figs. 10, 13(e) and 16).
 */
public final class JavaHarness {
  private static final String CONCRETE = "ConcreteTestDriver";

  private static final Mustache.Compiler TEMPLATES = Mustache.compiler().escapeHTML(false);

  private JavaHarness() {}

  /**
   * Generates the sources, by path below the source folder.
   *
   * @throws InvalidInputException with everything that Java cannot express
   */
  public static FileTree generate(Activity activity, TestModel model, TestSuite suite) {
    HarnessPlan plan = HarnessPlanner.plan(activity, model, suite);
    String folder = folder(model);
    Map<String, byte[]> files = new HashMap<>();
    files.put(folder + "TestDriver.java", print("TestDriver", TestDriverView.of(plan)));
    files.put(
        folder + "SimulationControl.java",
        print("SimulationControl", SimulationControlView.of(plan)));
    files.put(folder + "TestStub.java", print("TestStub", TestStubView.of(plan)));
    files.put(
        editableFile(model),
        activity
            .files()
            .content(keptDriver(model))
            .orElseGet(() -> print(CONCRETE, ConcreteTestDriverView.of(plan))));
    for (HarnessPlan.Stub stub : plan.stubs()) {
      files.put(
          "sitaf/interfaces/" + stub.name() + ".java",
          print("RequiredInterface", RequiredInterfaceView.of(stub)));
    }
    return FileTree.of(files);
  }

  /** What to start. */
  public static String mainClass(TestModel model) {
    return HarnessPlanner.packageName(model) + "." + CONCRETE;
  }

  /** The path, among the sources, of the file that the user may edit. */
  public static String editableFile(TestModel model) {
    return folder(model) + CONCRETE + ".java";
  }

  /**
   * Where an activity keeps the user's version of that file; it is taken instead of a generated
   * one.
   */
  public static String keptDriver(TestModel model) {
    return "harness/" + model.name() + "/" + CONCRETE + ".java";
  }

  private static String folder(TestModel model) {
    return HarnessPlanner.packageName(model).replace('.', '/') + "/";
  }

  private static byte[] print(String template, Object view) {
    return load(template).execute(view).getBytes(StandardCharsets.UTF_8);
  }

  private static Template load(String name) {
    try (InputStream stream = JavaHarness.class.getResourceAsStream(name + ".mustache")) {
      return TEMPLATES.compile(
          new InputStreamReader(Objects.requireNonNull(stream, name), StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
