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
 * A database in a file on a disk of ours. Of a statement that writes on a full disk the database
 * never hears, as it would close itself, for those who only read, too; if it does so nevertheless,
 * it is opened anew.
 */
final class GuardedDataSource extends DelegatingDataSource implements AutoCloseable {
  private static final String OWN_FILE = "jdbc:h2:file:";
  private static final Duration REOPENED_WITHIN = Duration.ofSeconds(5);
  private static final Set<String> READING =
      Set.of("SELECT", "WITH", "VALUES", "SHOW", "EXPLAIN", "SET", "CALL");
  private static final Pattern FIRST_WORD = Pattern.compile("[\\s(]*([A-Za-z]+)");
  private static final Pattern LOCKS =
      Pattern.compile("\\bFOR\\s+(NO\\s+KEY\\s+)?UPDATE\\b", Pattern.CASE_INSENSITIVE);

  private final HikariDataSource pool;
  private final Supplier<Optional<String>> whyFull;
  private final Reopening reopening;

  /** Whether the database of these settings is a file on a disk of ours. */
  static boolean guards(Environment environment) {
    return environment.getProperty("spring.datasource.url", "").startsWith(OWN_FILE);
  }

  /**
   * Guards a pool that has not begun its work.
   *
   * @param whyFull why nothing can be written at present; empty when it can
   */
  GuardedDataSource(HikariDataSource pool, Supplier<Optional<String>> whyFull) {
    super(pool);
    this.pool = pool;
    this.whyFull = whyFull;
    this.reopening = new Reopening(pool);
  }

  @Override
  public Connection getConnection() throws SQLException {
    try {
      if (!reopening.await(REOPENED_WITHIN)) {
        throw new SQLTransientConnectionException("the database is being opened anew");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new SQLTransientConnectionException("interrupted while the database was opened", e);
    }
    return guarded(pool.getConnection());
  }

  private Connection guarded(Connection connection) {
    return (Connection)
        Proxy.newProxyInstance(
            GuardedDataSource.class.getClassLoader(),
            new Class<?>[] {Connection.class},
            new Guard(connection));
  }

  /** Lets a connection prepare what it may. */
  private final class Guard implements InvocationHandler {
    private final Connection connection;

    Guard(Connection connection) {
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
            requireRoom();
          }
        }
        default -> {
          // Nothing else writes: what the server executes, it prepares.
        }
      }
      try {
        return method.invoke(connection, arguments);
      } catch (InvocationTargetException e) {
        throw e.getTargetException();
      }
    }
  }

  private void requireRoom() throws NoRoomException {
    Optional<String> why = whyFull.get();
    if (why.isPresent()) {
      throw new NoRoomException(why.get());
    }
  }

  /** Whether a statement changes anything; rows that are locked are changed for H2. */
  static boolean writes(String sql) {
    Matcher first = FIRST_WORD.matcher(sql);
    boolean reads = first.lookingAt() && READING.contains(first.group(1).toUpperCase(Locale.ROOT));
    return !reads || LOCKS.matcher(sql).find();
  }

  @Override
  public void close() {
    pool.close();
  }
}
