package org.sitaf.server.suite;

import io.swagger.v3.oas.annotations.media.Schema;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.model.TestModel;

/** A source file of a test application. */
@Schema(name = "HarnessFile")
record HarnessFile(
    String path,
    String content,
    @Schema(
            description =
                "whether users can edit it; the edited file is stored in the activity's"
                    + " harness/MODEL/")
        boolean editable,
    @Schema(description = "path of the edited file in the activity; absent if it is not editable")
        @Nullable String keptPath,
    @Schema(description = "the generated text; absent unless the activity contains an edited file")
        @Nullable String generated) {

  static List<HarnessFile> of(TestApplication application) {
    Activity activity = application.activity();
    TestModel model = application.model();
    FileTree sources = application.harness();
    String editable = InterfaceTestApplicationGenerator.editableFile(activity, model);
    String editedPath = InterfaceTestApplicationGenerator.keptDriver(activity, model);
    String generated =
        activity.files().contains(editedPath)
            ? text(
                InterfaceTestApplicationGenerator.generate(
                        without(activity, editedPath), model, application.suite())
                    .harness(),
                editable)
            : null;
    return sources.paths().stream()
        .map(
            path ->
                new HarnessFile(
                    path,
                    text(sources, path),
                    path.equals(editable),
                    path.equals(editable) ? editedPath : null,
                    path.equals(editable) ? generated : null))
        .toList();
  }

  private static Activity without(Activity activity, String path) {
    Map<String, byte[]> files = new HashMap<>();
    FileTree tree = activity.files();
    tree.paths().stream()
        .filter(p -> !p.equals(path))
        .forEach(p -> files.put(p, tree.content(p).orElseThrow()));
    return new Activity(
        activity.profile(),
        FileTree.of(files),
        activity.provided(),
        activity.required(),
        activity.outputPorts(),
        activity.world(),
        activity.models(),
        activity.ros(),
        activity.warnings());
  }

  private static String text(FileTree files, String path) {
    return new String(files.content(path).orElseThrow(), StandardCharsets.UTF_8);
  }
}
