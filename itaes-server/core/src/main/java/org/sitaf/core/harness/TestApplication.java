package org.sitaf.core.harness;

import java.util.Objects;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestSuite;

/**
 * Everything that an agent needs to compile and execute a test: what the server sends, and what
 * {@code sitaf run} hands over directly.
 *
 * <p>As files:
 *
 * <pre>
 * activity/...   the activity, as the user keeps it
 * harness/...    the generated sources
 * model.xml      the test model, for the post-conditions
 * suite.xml      the test cases
 * main-class     what to start, one line
 * </pre>
 *
 * @param harness the sources of the test application, paths relative to {@code harness/}
 * @param mainClass what to start, qualified as the harness's language writes it
 */
public record TestApplication(
    Activity activity, TestModel model, TestSuite suite, FileTree harness, String mainClass) {
  public TestApplication {
    Objects.requireNonNull(activity);
    Objects.requireNonNull(model);
    Objects.requireNonNull(suite);
    Objects.requireNonNull(harness);
    Objects.requireNonNull(mainClass);
  }

  /** The application as files, in the layout above. */
  public FileTree files() {
    return TestApplicationFiles.write(this);
  }

  /**
   * Reads an application back from its files.
   *
   * @throws org.sitaf.core.diagnostic.InvalidInputException with every problem of every document
   */
  public static TestApplication read(FileTree files) {
    return TestApplicationFiles.read(files);
  }
}
