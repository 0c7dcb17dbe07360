package org.sitaf.server.comparison;

import java.util.Map;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestSuite;

/**
 * What was built.
 *
 * @param files SHA-256 of the activity's files by their path
 */
record BuiltVersion(
    Activity activity, TestModel model, TestSuite suite, Map<String, String> files) {
  BuiltVersion {
    files = Map.copyOf(files);
  }
}
