package org.sitaf.core.harness;

import java.io.ByteArrayOutputStream;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.activity.ros.RosImplementation;
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
  private static final String ROS = "ros";

  private TestApplicationFiles() {}

  static FileTree write(TestApplication application) {
    ByteArrayOutputStream suite = new ByteArrayOutputStream();
    TestSuiteXml.write(application.suite(), suite);
    Activity activity = application.activity();
    byte[] model = activity.files().content(application.model().source()).orElseThrow();
    Map<String, byte[]> files = new HashMap<>();
    files.put(MODEL, model);
    files.put(SUITE, suite.toByteArray());
    files.put(ENTRY_POINT, line(application.entryPoint()));
    activity
        .rosImplementation()
        .filter(implementation -> implementation != RosImplementation.INCLUDED)
        .ifPresent(implementation -> files.put(ROS, line(implementation.id())));
    return FileTree.of(files).with(ACTIVITY, activity.files()).with(HARNESS, application.harness());
  }

  static TestApplication read(FileTree files) {
    Activity activity =
        Activity.read(files.below(ACTIVITY), files.below(HARNESS).below(RosHarness.INTERFACES));
    Optional<String> ros = files.text(ROS).map(String::strip);
    if (ros.isPresent()) {
      activity =
          activity.with(
              RosImplementation.of(ros.get())
                  .orElseThrow(() -> InvalidInputException.of(ROS, "'" + ros.get() + "'")));
    }
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

  private static byte[] line(String text) {
    return (text + "\n").getBytes(StandardCharsets.UTF_8);
  }

  private static InputStream open(FileTree files, String path) {
    return files.open(path).orElseThrow(() -> InvalidInputException.of(path, "is missing"));
  }
}
