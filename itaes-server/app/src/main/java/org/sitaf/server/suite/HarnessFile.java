package org.sitaf.server.suite;

import io.swagger.v3.oas.annotations.media.Schema;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;

/** A generated source of a test application. */
@Schema(name = "HarnessFile")
record HarnessFile(
    String path,
    String content,
    @Schema(
            description =
                "whether it is meant to be edited and kept in the activity, below harness/MODEL/")
        boolean editable) {

  static List<HarnessFile> of(TestApplication application) {
    FileTree sources = application.harness();
    String editable =
        InterfaceTestApplicationGenerator.editableFile(application.activity(), application.model());
    return sources.paths().stream()
        .map(
            path ->
                new HarnessFile(
                    path,
                    new String(sources.content(path).orElseThrow(), StandardCharsets.UTF_8),
                    path.equals(editable)))
        .toList();
  }
}
