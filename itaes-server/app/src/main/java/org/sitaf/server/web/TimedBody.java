package org.sitaf.server.web;

import jakarta.servlet.ReadListener;
import jakarta.servlet.ServletInputStream;
import java.io.IOException;
import java.net.SocketTimeoutException;
import java.time.Duration;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.settings.LimitSettings;

/**
 * A request body with a deadline. Reading throws a {@link RequestException} if the body is too slow
 * or incomplete, or if too many other requests are waiting for their bodies.
 */
final class TimedBody extends ServletInputStream {
  /** The slowest connection that is supported. */
  private static final int MIN_BYTES_PER_SECOND = 16 << 10;

  private final ServletInputStream in;
  private final LimitSettings limits;
  private final BodyPermits permits;
  private final Supplier<BodyPermits.Client> client;
  private BodyPermits.@Nullable Client permitHolder;
  private long startNanos;
  private long count;
  private boolean ended;

  TimedBody(
      ServletInputStream in,
      LimitSettings limits,
      BodyPermits permits,
      Supplier<BodyPermits.Client> client) {
    this.in = in;
    this.limits = limits;
    this.permits = permits;
    this.client = client;
  }

  @Override
  public int read() throws IOException {
    byte[] one = new byte[1];
    int read = read(one, 0, 1);
    return read < 0 ? read : one[0] & 0xff;
  }

  @Override
  public int read(byte[] buffer, int offset, int length) {
    if (ended || length == 0) {
      return ended ? -1 : 0;
    }
    BodyPermits.Client sender = client.get();
    int read;
    try {
      acquirePermit(sender);
      read = in.read(buffer, offset, length);
    } catch (IOException e) {
      end();
      throw isTimeout(e)
          ? timeout()
          : RequestException.malformed(
              "The request body is incomplete: it ended after %d bytes; send it again."
                  .formatted(count));
    }
    if (read < 0) {
      end();
      return read;
    }
    count += read;
    if (System.nanoTime() - startNanos > timeLimit(sender).toNanos()) {
      end();
      throw timeout();
    }
    return read;
  }

  /** Acquires a permit unless data is available, so that reading does not block. */
  private void acquirePermit(BodyPermits.Client sender) throws IOException {
    if (startNanos == 0) {
      startNanos = System.nanoTime();
    }
    if (permitHolder == null && in.available() == 0) {
      if (!permits.tryAcquire(sender)) {
        throw RequestException.busy(
            "Too many requests are waiting for their bodies; try again in some seconds.");
      }
      permitHolder = sender;
    }
  }

  private Duration timeLimit(BodyPermits.Client sender) {
    return sender.anonymous()
        ? limits.signInBodyTime()
        : limits.bodyTime().plusSeconds(count / MIN_BYTES_PER_SECOND);
  }

  private RequestException timeout() {
    return RequestException.timeout(
        "The request body arrived too slowly: %d bytes in %d s."
            .formatted(count, Duration.ofNanos(System.nanoTime() - startNanos).toSeconds()));
  }

  private static boolean isTimeout(IOException e) {
    for (Throwable cause = e; cause != null; cause = cause.getCause()) {
      if (cause instanceof SocketTimeoutException) {
        return true;
      }
    }
    return false;
  }

  /** Stops reading and releases the permit. */
  void end() {
    ended = true;
    if (permitHolder != null) {
      permits.release(permitHolder);
      permitHolder = null;
    }
  }

  @Override
  public int available() throws IOException {
    return ended ? 0 : in.available();
  }

  @Override
  public boolean isFinished() {
    return ended || in.isFinished();
  }

  @Override
  public boolean isReady() {
    return in.isReady();
  }

  @Override
  public void setReadListener(ReadListener listener) {
    in.setReadListener(listener);
  }
}
