package org.sitaf.core.harness;

import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.java.JavaHarness;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestSuite;

/**
 * Interface Test Application Generator (ITAG): makes the sources of a test application out of an
 * activity, a test model and its cases (paper, section 3.2 and Fig. 10).
 */
public final class InterfaceTestApplicationGenerator {
  private InterfaceTestApplicationGenerator() {}

  /**
   * Generates the test application of a model. The same documents give the same sources, byte by
   * byte.
   *
   * @throws InvalidInputException with everything in the documents that the harness's language
   *     cannot express
   */
  public static TestApplication generate(Activity activity, TestModel model, TestSuite suite) {
    Language language = activity.profile().harness();
    if (language != Language.JAVA) {
      throw InvalidInputException.of(
          "activity.yaml",
          "harness: test applications are generated in java, not yet in " + language.spelling());
    }
    FileTree sources = JavaHarness.generate(activity, model, suite);
    return new TestApplication(activity, model, suite, sources, JavaHarness.mainClass(model));
  }

  /** Where an activity keeps the concrete test driver that its user has edited. */
  public static String keptDriver(TestModel model) {
    return JavaHarness.keptDriver(model);
  }

  /** Which file of the harness the user may edit: the one that {@link #keptDriver} replaces. */
  public static String editableFile(TestModel model) {
    return JavaHarness.editableFile(model);
  }
}
