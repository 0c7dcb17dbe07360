package org.sitaf.server.storage;

import com.zaxxer.hikari.HikariDataSource;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.sql.Connection;
import java.sql.SQLException;
import java.sql.SQLTransientConnectionException;
import java.time.Duration;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.springframework.core.env.Environment;
import org.springframework.jdbc.datasource.DelegatingDataSource;

/**
 * The data source of an H2 database in a local file. H2 closes the database after a failed write,
 * also for readers. So statements that write are rejected while the disk is full; if the database
 * is closed nevertheless, {@link DatabaseReopener} opens it again.
 */
final class GuardedDataSource extends DelegatingDataSource implements AutoCloseable {
  private static final String LOCAL_FILE = "jdbc:h2:file:";
  private static final Duration REOPEN_TIMEOUT = Duration.ofSeconds(20);

  /** The pool cannot be emptied while a thread waits for one of its connections. */
  private static final Duration CONNECTION_TIMEOUT = Duration.ofSeconds(10);

  private static final Set<String> READ_ONLY =
      Set.of("SELECT", "WITH", "VALUES", "SHOW", "EXPLAIN", "SET", "CALL");
  private static final Pattern FIRST_WORD = Pattern.compile("[\\s(]*([A-Za-z]+)");
  private static final Pattern LOCKS =
      Pattern.compile("\\bFOR\\s+(NO\\s+KEY\\s+)?UPDATE\\b", Pattern.CASE_INSENSITIVE);

  private final HikariDataSource pool;
  private final Supplier<Optional<String>> whyFull;
  private final Runnable beforeEnd;
  private final DatabaseReopener reopener;

  /** Connections that the current thread holds. */
  private final ThreadLocal<Integer> held = ThreadLocal.withInitial(() -> 0);

  /** Whether the configured database is a local file. */
  static boolean guards(Environment environment) {
    return environment.getProperty("spring.datasource.url", "").startsWith(LOCAL_FILE);
  }

  /**
   * Wraps a pool that is not in use yet.
   *
   * @param whyFull why nothing can be written; empty if the disk has enough space
   * @param beforeEnd called before a transaction ends or the database is opened again, for which H2
   *     may need space
   */
  GuardedDataSource(HikariDataSource pool, Supplier<Optional<String>> whyFull, Runnable beforeEnd) {
    super(pool);
    this.pool = pool;
    this.whyFull = whyFull;
    this.beforeEnd = beforeEnd;
    pool.setConnectionTimeout(CONNECTION_TIMEOUT.toMillis());
    this.reopener = new DatabaseReopener(pool, beforeEnd);
  }

  @Override
  public Connection getConnection() throws SQLException {
    try {
      // The database is opened only after the connection that the thread already holds is closed.
      if (!reopener.await(held.get() > 0 ? Duration.ZERO : REOPEN_TIMEOUT)) {
        throw new SQLTransientConnectionException("the database is being reopened");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new SQLTransientConnectionException("interrupted while waiting for the database", e);
    }
    Connection connection = guarded(pool.getConnection());
    held.set(held.get() + 1);
    return connection;
  }

  private Connection guarded(Connection connection) {
    return (Connection)
        Proxy.newProxyInstance(
            GuardedDataSource.class.getClassLoader(),
            new Class<?>[] {Connection.class},
            new ConnectionHandler(connection));
  }

  /** Rejects statements that write while the disk is full. */
  private final class ConnectionHandler implements InvocationHandler {
    private final Connection connection;
    private boolean hasWritten;
    private boolean isClosed;

    ConnectionHandler(Connection connection) {
      this.connection = connection;
    }

    @Override
    public @Nullable Object invoke(Object proxy, Method method, Object @Nullable [] arguments)
        throws Throwable {
      switch (method.getName()) {
        case "equals" -> {
          return arguments != null && proxy == arguments[0];
        }
        case "hashCode" -> {
          return System.identityHashCode(proxy);
        }
        case "prepareStatement", "prepareCall" -> {
          if (arguments != null && writes(String.valueOf(arguments[0]))) {
            requireSpace();
            hasWritten = true;
          }
        }
        case "commit", "rollback" -> {
          end(method, arguments);
          return null;
        }
        case "close" -> {
          if (!isClosed) {
            isClosed = true;
            held.set(held.get() - 1);
          }
        }
        default -> {
          // The server only executes prepared statements.
        }
      }
      return call(method, arguments);
    }

    /**
     * Ends a transaction. H2 then also writes earlier changes of others. If that fails, a
     * transaction that has only read has lost nothing.
     */
    private void end(Method method, Object @Nullable [] arguments) throws Throwable {
      beforeEnd.run();
      try {
        var unused = call(method, arguments);
      } catch (SQLException e) {
        if (hasWritten || !StorageFailure.isClosedH2(e)) {
          throw e;
        }
      }
      hasWritten = false;
    }

    private @Nullable Object call(Method method, Object @Nullable [] arguments) throws Throwable {
      try {
        return method.invoke(connection, arguments);
      } catch (InvocationTargetException e) {
        throw e.getTargetException();
      }
    }
  }

  private void requireSpace() throws DiskFullException {
    Optional<String> why = whyFull.get();
    if (why.isPresent()) {
      throw new DiskFullException(why.get());
    }
  }

  /** Whether a statement writes; H2 also writes when it locks rows. */
  static boolean writes(String sql) {
    Matcher first = FIRST_WORD.matcher(sql);
    boolean reads =
        first.lookingAt() && READ_ONLY.contains(first.group(1).toUpperCase(Locale.ROOT));
    return !reads || LOCKS.matcher(sql).find();
  }

  @Override
  public void close() {
    pool.close();
  }
}
