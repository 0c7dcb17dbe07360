package org.sitaf.server.storage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.zaxxer.hikari.HikariDataSource;
import java.io.IOException;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.SQLException;
import java.sql.SQLTransientConnectionException;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.springframework.dao.DataAccessException;
import org.springframework.jdbc.core.simple.JdbcClient;

@Timeout(60)
class GuardedDataSourceTest {
  @TempDir private Path folder;
  private Optional<String> fullReason = Optional.empty();
  private int ends;

  /** The database is opened again when this is 0. */
  private volatile CountDownLatch opening = new CountDownLatch(0);

  private GuardedDataSource database =
      new GuardedDataSource(new HikariDataSource(), this::fullReason, this::beforeEnd);
  private JdbcClient jdbc = JdbcClient.create(database);

  private Optional<String> fullReason() {
    return fullReason;
  }

  private void beforeEnd() {
    ends++;
    try {
      opening.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @BeforeEach
  void create() {
    HikariDataSource pool = new HikariDataSource();
    pool.setJdbcUrl("jdbc:h2:file:" + folder + "/database;WRITE_DELAY=0;DB_CLOSE_ON_EXIT=FALSE");
    pool.setMaximumPoolSize(4);
    database = new GuardedDataSource(pool, this::fullReason, this::beforeEnd);
    jdbc = JdbcClient.create(database);
    jdbc.sql("CREATE TABLE \"flyway_schema_history\" (no INT PRIMARY KEY)").update();
    insert(1);
  }

  @AfterEach
  void close() {
    database.close();
  }

  private void insert(int no) {
    jdbc.sql("INSERT INTO \"flyway_schema_history\" (no) VALUES (?)").param(no).update();
  }

  private void shutDown() {
    try (Connection connection = database.getConnection();
        Statement statement = connection.createStatement()) {
      statement.execute("SHUTDOWN IMMEDIATELY");
    } catch (SQLException e) {
      assertThat(StorageFailure.of(e)).contains(StorageFailure.DATABASE_UNAVAILABLE);
    }
  }

  private void insertWhenAvailable(int no) {
    while (true) {
      try {
        insert(no);
        return;
      } catch (DataAccessException e) {
        assertThat(StorageFailure.of(e)).contains(StorageFailure.DATABASE_UNAVAILABLE);
      }
    }
  }

  private List<Integer> stored() {
    return jdbc.sql("SELECT no FROM \"flyway_schema_history\" ORDER BY no")
        .query(Integer.class)
        .list();
  }

  @Test
  void databaseIsReadOnlyWhileTheDiskIsFull() {
    fullReason = Optional.of("the disk is full");
    assertThat(stored()).containsExactly(1);
    assertThatThrownBy(() -> insert(2))
        .isInstanceOf(DataAccessException.class)
        .satisfies(e -> assertThat(StorageFailure.of(e)).contains(StorageFailure.DISK_FULL))
        .hasRootCauseMessage("the disk is full");
    fullReason = Optional.empty();
    insert(3);
    assertThat(stored()).containsExactly(1, 3);
  }

  @Test
  void eachEndOfTransactionIsAnnounced() throws SQLException {
    try (Connection connection = database.getConnection()) {
      connection.setAutoCommit(false);
      connection.rollback();
      connection.commit();
    }
    assertThat(ends).isEqualTo(2);
  }

  @Test
  void statementsThatLockRowsCountAsWrites() {
    assertThat(GuardedDataSource.writes("select a from b where c = 'x' for update")).isTrue();
    assertThat(GuardedDataSource.writes("SELECT * FROM QRTZ_LOCKS WHERE x = ? FOR UPDATE"))
        .isTrue();
    assertThat(GuardedDataSource.writes("select a from b for no key update skip locked")).isTrue();
    assertThat(GuardedDataSource.writes(" \n update b set a = 1")).isTrue();
    assertThat(GuardedDataSource.writes("MERGE INTO b VALUES (1)")).isTrue();
    assertThat(GuardedDataSource.writes("select a from b where updated > 1")).isFalse();
    assertThat(GuardedDataSource.writes("(select 1) union (select 2)")).isFalse();
    assertThat(GuardedDataSource.writes("WITH x AS (SELECT 1) SELECT * FROM x")).isFalse();
  }

  @Test
  void closedDatabaseIsReopened() throws SQLException {
    List<Connection> idle = new ArrayList<>();
    for (int i = 0; i < 4; i++) {
      idle.add(database.getConnection());
    }
    for (Connection connection : idle) {
      connection.close();
    }
    for (int round = 2; round < 5; round++) {
      shutDown();
      insertWhenAvailable(round);
    }
    assertThat(stored()).containsExactly(1, 2, 3, 4);
  }

  @Test
  void threadWithAConnectionDoesNotDelayTheReopening() throws SQLException {
    try (Connection held = database.getConnection()) {
      opening = new CountDownLatch(1);
      shutDown();
      assertThatThrownBy(() -> held.prepareStatement("VALUES 1").execute())
          .isInstanceOf(SQLException.class);
      assertThatThrownBy(database::getConnection)
          .isInstanceOf(SQLTransientConnectionException.class)
          .hasMessage("the database is being reopened");
    } finally {
      opening.countDown();
    }
    insertWhenAvailable(2);
    assertThat(stored()).containsExactly(1, 2);
  }

  @Test
  void onlyStorageFailuresAreRecognized() {
    assertThatThrownBy(() -> insert(1)).satisfies(e -> assertThat(StorageFailure.of(e)).isEmpty());
    assertThat(StorageFailure.of(new IOException("write failed: No space left on device")))
        .contains(StorageFailure.DISK_FULL);
    assertThat(
            StorageFailure.of(
                new IllegalStateException(
                    new SQLException(
                        "General error",
                        "HY000",
                        50000,
                        new IOException("No space left on device")))))
        .contains(StorageFailure.DISK_FULL);
  }
}
