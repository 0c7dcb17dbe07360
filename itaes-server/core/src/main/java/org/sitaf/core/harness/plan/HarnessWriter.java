package org.sitaf.core.harness.plan;

import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.Diagnostics;

/** Generates the sources of test applications in one language. */
public interface HarnessWriter {

  /**
   * Generates the sources of a test application: test driver, simulation control, test stub,
   * concrete test driver, and the interfaces and types that they share with the component. The same
   * plan gives the same bytes.
   *
   * @param diagnostics receives everything that the language cannot express; after an error, the
   *     result is not used
   * @return the sources by path below the source folder, including {@link #editableFile}
   */
  FileTree write(HarnessPlan plan, Diagnostics diagnostics);

  /**
   * Generates the skeleton of an adapter.
   *
   * @param diagnostics as for {@link #write}
   * @return the sources by path below the adapter's folder
   */
  FileTree adapter(HarnessPlan.Adapter plan, Diagnostics diagnostics);

  /**
   * The program to start: the qualified name of the main class (Java) or module (Python), or the
   * name of the executable (C++).
   */
  String entryPoint(String modelName);

  /** The path of the source that the user may edit. */
  String editableFile(String modelName);
}
