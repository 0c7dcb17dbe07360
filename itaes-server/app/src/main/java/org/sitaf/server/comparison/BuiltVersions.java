package org.sitaf.server.comparison;

import java.io.ByteArrayInputStream;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.suite.document.TestSuiteXml;
import org.sitaf.server.activity.StoredActivities;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.file.StoredFiles;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Component;

/** Reads the activity, the model and the cases as they were stored with a build. */
@Component
public class BuiltVersions {
  /** Folder of the activity in a test application. */
  private static final String ACTIVITY = "activity/";

  private static final String SUITE = "suite.xml";

  private final JdbcClient jdbc;
  private final StoredFiles contents;
  private final StoredActivities activities;

  BuiltVersions(JdbcClient jdbc, StoredFiles contents, StoredActivities activities) {
    this.jdbc = jdbc;
    this.contents = contents;
    this.activities = activities;
  }

  private record BuiltFile(String build, String path, String sha256) {}

  /** SHA-256 of the files of a build's activity; shards have the same ones. */
  Map<String, String> files(String buildId) {
    Map<String, String> files = new LinkedHashMap<>();
    of(buildId, "path LIKE 'activity/%'")
        .forEach(f -> files.putIfAbsent(f.path().substring(ACTIVITY.length()), f.sha256()));
    return files;
  }

  /**
   * Reads what was built.
   *
   * @throws RequestException if the build has no files, or not this model
   */
  BuiltVersion read(String buildId, String modelName) {
    Map<String, String> files = files(buildId);
    Activity activity = activity(buildId, files);
    List<BuiltFile> suites = of(buildId, "path = '" + SUITE + "'");
    if (suites.isEmpty()) {
      throw notStored(buildId);
    }
    return new BuiltVersion(
        activity, StoredActivities.model(activity, modelName), suite(suites), files);
  }

  /**
   * Reads the activity that was built.
   *
   * @throws RequestException if the build has no files
   */
  public Activity activity(String buildId) {
    return activity(buildId, files(buildId));
  }

  private Activity activity(String buildId, Map<String, String> files) {
    if (files.isEmpty()) {
      throw notStored(buildId);
    }
    Map<String, byte[]> bytes = new LinkedHashMap<>();
    files.forEach((path, sha256) -> bytes.put(path, contents.content(sha256)));
    return activities.read(FileTree.of(bytes));
  }

  private static RequestException notStored(String buildId) {
    return RequestException.conflict(
        "The results cannot be compared: the files of build " + buildId + " are not stored.");
  }

  /** The cases of all shards. */
  private TestSuite suite(List<BuiltFile> documents) {
    List<TestCase> cases = new ArrayList<>();
    TestSuite first = null;
    for (BuiltFile document : documents) {
      TestSuite part =
          TestSuiteXml.read(new ByteArrayInputStream(contents.content(document.sha256())), SUITE);
      first = first == null ? part : first;
      cases.addAll(part.cases());
    }
    if (first == null) {
      throw new IllegalStateException("a build has a suite");
    }
    return documents.size() == 1 ? first : first.withCases(cases);
  }

  private List<BuiltFile> of(String buildId, String condition) {
    return jdbc.sql(
            "SELECT build_id, path, sha256 FROM build_file WHERE build_id IN (SELECT id FROM build"
                + " WHERE (id = :build AND shards = 0) OR parent_id = :build) AND "
                + condition
                + " ORDER BY build_id, path")
        .param("build", buildId)
        .query((row, no) -> new BuiltFile(row.getString(1), row.getString(2), row.getString(3)))
        .list();
  }
}
