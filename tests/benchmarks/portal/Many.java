import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Adds copies of an activity with its suite, of a finished build and of an agent to the database of a server that is stopped.
 * The newest build of each copy has a result.
 *
 * <p>Arguments: the database's file without its ending, the id of a build, and the numbers of activities, builds and agents.
 */
final class Many {
  private final Connection connection;

  private Many(Connection connection) {
    this.connection = connection;
  }

  public static void main(String[] arguments) throws SQLException {
    String build = arguments[1];
    int activities = Integer.parseInt(arguments[2]);
    int builds = Integer.parseInt(arguments[3]);
    int agents = Integer.parseInt(arguments[4]);
    try (Connection connection =
        DriverManager.getConnection("jdbc:h2:file:" + arguments[0], "", "")) {
      connection.setAutoCommit(false);
      new Many(connection).add(build, activities, builds, agents);
      connection.commit();
    }
  }

  private void add(String build, int activities, int builds, int agents) throws SQLException {
    String activity = value("SELECT activity_id FROM build WHERE id = '" + build + "'");
    String suite = value("SELECT suite_id FROM build WHERE id = '" + build + "'");
    String activityCopy = "'copy-activity-' || r.x";
    String suiteCopy = "'copy-suite-' || r.x";
    String earlier = "DATEADD('SECOND', -r.x, t.%s)";
    copy(
        "activity",
        "id = '" + activity + "'",
        activities,
        Map.of(
            "id", activityCopy,
            "name", "t.name || '-' || LPAD(r.x, 4, '0')",
            "created", earlier.formatted("created"),
            "updated", earlier.formatted("updated")));
    for (String table : List.of("activity_file", "activity_model", "activity_method", "activity_owner")) {
      copy(table, "activity_id = '" + activity + "'", activities, Map.of("activity_id", activityCopy));
    }
    copy(
        "suite",
        "id = '" + suite + "'",
        activities,
        Map.of("id", suiteCopy, "activity_id", activityCopy, "created", earlier.formatted("created")));
    for (String table : List.of("suite_document", "suite_parameter", "suite_owner")) {
      copy(table, "suite_id = '" + suite + "'", activities, Map.of("suite_id", suiteCopy));
    }
    String ofBuild = "(MOD(r.x - 1, " + activities + ") + 1)";
    copy(
        "build",
        "id = '" + build + "'",
        builds,
        Map.of(
            "id", "'copy-build-' || r.x",
            "activity_id", "'copy-activity-' || " + ofBuild,
            "activity_name", "t.activity_name || '-' || LPAD(" + ofBuild + ", 4, '0')",
            "suite_id", "'copy-suite-' || " + ofBuild,
            "created", earlier.formatted("created"),
            "started", earlier.formatted("started"),
            "finished", earlier.formatted("finished")));
    copy("build_owner", "build_id = '" + build + "'", builds, Map.of("build_id", "'copy-build-' || r.x"));
    for (String table : List.of("result", "result_case", "build_transition")) {
      copy(table, "build_id = '" + build + "'", activities, Map.of("build_id", "'copy-build-' || r.x"));
    }
    copy(
        "agent",
        "name = (SELECT MIN(name) FROM agent)",
        agents,
        Map.of("name", "'bench-' || LPAD(r.x, 3, '0')", "connected", "FALSE"));
  }

  /** Inserts copies of rows; an expression of a column can use the row, t, and the number of the copy, r.x. */
  private void copy(String table, String where, int copies, Map<String, String> changed)
      throws SQLException {
    Map<String, String> columns = new LinkedHashMap<>();
    for (String column : columns(table)) {
      columns.put(column, changed.getOrDefault(column, "t." + column));
    }
    String sql =
        "INSERT INTO %s (%s) SELECT %s FROM %s t CROSS JOIN SYSTEM_RANGE(1, %d) r WHERE t.%s"
            .formatted(
                table,
                String.join(", ", columns.keySet()),
                String.join(", ", columns.values()),
                table,
                copies,
                where);
    try (Statement statement = connection.createStatement()) {
      statement.executeUpdate(sql);
    }
  }

  private List<String> columns(String table) throws SQLException {
    List<String> names = new ArrayList<>();
    try (ResultSet found =
        connection.getMetaData().getColumns(null, "PUBLIC", table.toUpperCase(), null)) {
      while (found.next()) {
        names.add(found.getString("COLUMN_NAME").toLowerCase());
      }
    }
    if (names.isEmpty()) {
      throw new IllegalStateException("there is no table " + table);
    }
    return names;
  }

  private String value(String sql) throws SQLException {
    try (Statement statement = connection.createStatement();
        ResultSet found = statement.executeQuery(sql)) {
      if (!found.next()) {
        throw new IllegalStateException("nothing found: " + sql);
      }
      return found.getString(1);
    }
  }
}
