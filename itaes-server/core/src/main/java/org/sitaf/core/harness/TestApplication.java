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
 * entry-point    what to start, one line
 * </pre>
 *
 * @param harness the sources of the test application, paths relative to {@code harness/}
 * @param entryPoint what to start: the qualified name of the main class (Java) or of the module
 *     (Python), the name of the executable (C++)
 */
public record TestApplication(
    Activity activity, TestModel model, TestSuite suite, FileTree harness, String entryPoint) {
  public TestApplication {
    Objects.requireNonNull(activity);
    Objects.requireNonNull(model);
    Objects.requireNonNull(suite);
    Objects.requireNonNull(harness);
    Objects.requireNonNull(entryPoint);
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
