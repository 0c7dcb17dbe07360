package org.sitaf.core.harness;

import java.io.ByteArrayOutputStream;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.ros.RosHarness;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.suite.document.TestSuiteXml;

/** Reads and writes the files of a test application. */
final class TestApplicationFiles {
  private static final String ACTIVITY = "activity";
  private static final String HARNESS = "harness";
  private static final String MODEL = "model.xml";
  private static final String SUITE = "suite.xml";
  private static final String ENTRY_POINT = "entry-point";

  private TestApplicationFiles() {}

  static FileTree write(TestApplication application) {
    ByteArrayOutputStream suite = new ByteArrayOutputStream();
    TestSuiteXml.write(application.suite(), suite);
    Activity activity = application.activity();
    byte[] model = activity.files().content(application.model().source()).orElseThrow();
    return FileTree.of(
            Map.of(
                MODEL,
                model,
                SUITE,
                suite.toByteArray(),
                ENTRY_POINT,
                (application.entryPoint() + "\n").getBytes(StandardCharsets.UTF_8)))
        .with(ACTIVITY, activity.files())
        .with(HARNESS, application.harness());
  }

  static TestApplication read(FileTree files) {
    Activity activity =
        Activity.read(files.below(ACTIVITY), files.below(HARNESS).below(RosHarness.INTERFACES));
    TestModel model = TestModelXml.read(open(files, MODEL), MODEL);
    TestSuite suite = TestSuiteXml.read(open(files, SUITE), SUITE);
    String entryPoint =
        files
            .text(ENTRY_POINT)
            .orElseThrow(() -> InvalidInputException.of(ENTRY_POINT, "is missing"))
            .strip();
    return new TestApplication(
        activity,
        activity.model(model.name()).orElse(model),
        suite,
        files.below(HARNESS),
        entryPoint);
  }

  private static InputStream open(FileTree files, String path) {
    return files.open(path).orElseThrow(() -> InvalidInputException.of(path, "is missing"));
  }
}
