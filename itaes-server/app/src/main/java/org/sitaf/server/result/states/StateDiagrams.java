package org.sitaf.server.result.states;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.verdict.StateDiagram;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.server.activity.StoredActivities;
import org.sitaf.server.file.StoredFiles;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Component;

/** Draws the diagram of a result with the model as it was stored with the build. */
@Component
class StateDiagrams {
  /** Folder of the activity in a test application. */
  private static final String ACTIVITY = "activity/";

  private final JdbcClient jdbc;
  private final StoredFiles files;
  private final StoredActivities activities;

  StateDiagrams(JdbcClient jdbc, StoredFiles files, StoredActivities activities) {
    this.jdbc = jdbc;
    this.files = files;
    this.activities = activities;
  }

  private record BuiltFile(String path, String sha256) {}

  /** Empty if the build has no files or its model has no sequence. */
  Optional<StateDiagramView> of(String buildId, TestResult result) {
    Map<String, byte[]> contents = new LinkedHashMap<>();
    jdbc.sql(
            "SELECT path, sha256 FROM build_file WHERE build_id = (SELECT MIN(id) FROM build"
                + " WHERE (id = :build OR parent_id = :build) AND id IN (SELECT build_id FROM"
                + " build_file)) AND path LIKE 'activity/%'")
        .param("build", buildId)
        .query((row, index) -> new BuiltFile(row.getString(1), row.getString(2)))
        .list()
        .forEach(
            file ->
                contents.put(
                    file.path().substring(ACTIVITY.length()), files.content(file.sha256())));
    if (contents.isEmpty()) {
      return Optional.empty();
    }
    Activity activity = activities.read(FileTree.of(contents));
    return activity
        .model(result.name())
        .flatMap(
            model ->
                StateDiagram.of(model, result.cases(), result.provenance().seed())
                    .map(diagram -> StateDiagramView.of(diagram, model.target().settle())));
  }
}
