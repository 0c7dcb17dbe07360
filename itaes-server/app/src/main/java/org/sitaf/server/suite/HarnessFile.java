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

/** A generated source of a test application. */
@Schema(name = "HarnessFile")
record HarnessFile(
    String path,
    String content,
    @Schema(
            description =
                "whether it is meant to be edited and kept in the activity, below harness/MODEL/")
        boolean editable,
    @Schema(
            description =
                "where the activity keeps the user's own; absent where it is not editable")
        @Nullable String keptPath,
    @Schema(description = "what would be generated, where the activity keeps a file of the user's")
        @Nullable String generated) {

  static List<HarnessFile> of(TestApplication application) {
    Activity activity = application.activity();
    TestModel model = application.model();
    FileTree sources = application.harness();
    String editable = InterfaceTestApplicationGenerator.editableFile(activity, model);
    String kept = InterfaceTestApplicationGenerator.keptDriver(activity, model);
    String generated =
        activity.files().contains(kept)
            ? text(
                InterfaceTestApplicationGenerator.generate(
                        without(activity, kept), model, application.suite())
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
                    path.equals(editable) ? kept : null,
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
        activity.warnings());
  }

  private static String text(FileTree files, String path) {
    return new String(files.content(path).orElseThrow(), StandardCharsets.UTF_8);
  }
}
