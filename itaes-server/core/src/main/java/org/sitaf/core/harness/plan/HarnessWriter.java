package org.sitaf.core.harness.plan;

import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.Diagnostics;

/** Spells test applications in one language. */
public interface HarnessWriter {

  /**
   * The sources of a test application: test driver, simulation control, test stub, concrete test
   * driver, and the interfaces and types that the component shares with them. The same plan gives
   * the same bytes.
   *
   * @param diagnostics gets everything that the language cannot express; when there is an error
   *     among it, what is returned is not used
   * @return the sources by path below the source folder, the generated {@link #editableFile} among
   *     them
   */
  FileTree write(HarnessPlan plan, Diagnostics diagnostics);

  /**
   * The beginning of an adapter, for its user to go on with.
   *
   * @param diagnostics as for {@link #write}
   * @return the sources by path below the adapter's folder
   */
  FileTree adapter(HarnessPlan.Adapter plan, Diagnostics diagnostics);

  /**
   * What to start: the qualified name of the main class in Java, of the module in Python, the name
   * of the executable in C++.
   */
  String entryPoint(String modelName);

  /** The path, among the sources, of the file that the user may edit. */
  String editableFile(String modelName);
}
