package org.sitaf.core.harness;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.timing.Timing;

/**
 * Everything that an agent needs to compile and execute a test. The server sends it to the agent;
 * {@code sitaf run} passes it directly.
 *
 * <p>As files:
 *
 * <pre>
 * activity/...   the user's activity
 * harness/...    the generated sources
 * model.xml      the test model, for the post-conditions
 * suite.xml      the test cases
 * entry-point    the program to start, one line
 * ros            what a ROS 2 node runs with, one line; not there for what comes along
 * </pre>
 *
 * @param harness the sources of the test application, with paths relative to {@code harness/}
 * @param entryPoint the program to start: the qualified name of the main class (Java) or module
 *     (Python), or the name of the executable (C++)
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

  /** The same application without the files of the activity's reference implementation. */
  public TestApplication withoutReferenceFiles() {
    return new TestApplication(activity.withoutReferenceFiles(), model, suite, harness, entryPoint);
  }

  /** How often the call of each case is repeated; null if it is not. */
  public @Nullable Timing timing() {
    return model.timing() == null ? activity.profile().timing() : model.timing();
  }

  /** The application as files, in the layout above. */
  public FileTree files() {
    return TestApplicationFiles.write(this);
  }

  /**
   * Reads an application from its files.
   *
   * @throws org.sitaf.core.diagnostic.InvalidInputException with all problems of all documents
   */
  public static TestApplication read(FileTree files) {
    return TestApplicationFiles.read(files);
  }
}
