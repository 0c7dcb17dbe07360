package org.sitaf.cli.explain;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.sitaf.cli.run.LocalBuilds;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.ActivityArchive;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.explain.Explanation;
import org.sitaf.core.explain.Explanation.Cause;
import org.sitaf.core.explain.report.Bundle;
import org.sitaf.core.explain.report.RunRecord;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.TestResult;
import tools.jackson.databind.json.JsonMapper;

/** Writes a bundle for each cause. */
record Bundles(
    LocalBuilds builds, Activity activity, FileTree files, TestModel model, TestSuite suite) {
  void write(Explanation explanation, Path folder, PrintWriter out)
      throws IOException, InterruptedException {
    Files.createDirectories(folder);
    int number = 1;
    for (Cause cause : explanation.causes()) {
      Optional<TestSuite> only = Bundle.simplest(model, suite, cause, 1);
      if (only.isEmpty()) {
        continue;
      }
      Path file = folder.resolve(model.name() + "-" + number++ + ".zip");
      TestResult result =
          builds.completed(activity, builds.runQuietly(activity, model, only.get()));
      String record =
          new JsonMapper()
                  .writerWithDefaultPrettyPrinter()
                  .writeValueAsString(Bundle.record(model, suite, RunRecord.of(result)))
              + "\n";
      FileTree bundle =
          Bundle.files(
              files,
              only.get(),
              record.getBytes(UTF_8),
              Bundle.readme(
                  activity.profile().name(),
                  model.name(),
                  cause,
                  ExplanationText.SENTENCES,
                  String.valueOf(file.getFileName())));
      try (OutputStream zip = new BufferedOutputStream(Files.newOutputStream(file))) {
        ActivityArchive.write(bundle, zip);
      }
      out.println("  bundle: " + file);
      out.flush();
    }
  }
}
