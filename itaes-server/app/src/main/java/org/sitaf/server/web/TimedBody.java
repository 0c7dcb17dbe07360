package org.sitaf.server.web;

import jakarta.servlet.ReadListener;
import jakarta.servlet.ServletInputStream;
import java.io.IOException;
import java.net.SocketTimeoutException;
import java.time.Duration;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.settings.LimitSettings;

/**
 * A body that arrives in time, or is refused: reading it ends in a {@link Refusal} when it is too
 * slow, when it breaks off, and when too many others are waited for.
 */
final class TimedBody extends ServletInputStream {
  /** What a slow line brings in a second. */
  private static final int BYTES_A_SECOND = 16 << 10;

  private final ServletInputStream in;
  private final LimitSettings limits;
  private final BodyPlaces places;
  private final Supplier<BodyPlaces.Waiter> waiter;
  private BodyPlaces.@Nullable Waiter place;
  private long began;
  private long count;
  private boolean over;

  TimedBody(
      ServletInputStream in,
      LimitSettings limits,
      BodyPlaces places,
      Supplier<BodyPlaces.Waiter> waiter) {
    this.in = in;
    this.limits = limits;
    this.places = places;
    this.waiter = waiter;
  }

  @Override
  public int read() throws IOException {
    byte[] one = new byte[1];
    int read = read(one, 0, 1);
    return read < 0 ? read : one[0] & 0xff;
  }

  @Override
  public int read(byte[] buffer, int offset, int length) {
    if (over || length == 0) {
      return over ? -1 : 0;
    }
    BodyPlaces.Waiter who = waiter.get();
    int read;
    try {
      takePlace(who);
      read = in.read(buffer, offset, length);
    } catch (IOException e) {
      end();
      throw isTimeout(e)
          ? tooSlow()
          : Refusal.malformed(
              "The body ends before it is complete, after %d bytes; send it again."
                  .formatted(count));
    }
    if (read < 0) {
      end();
      return read;
    }
    count += read;
    if (System.nanoTime() - began > allowed(who).toNanos()) {
      end();
      throw tooSlow();
    }
    return read;
  }

  /** What is there already is not waited for. */
  private void takePlace(BodyPlaces.Waiter who) throws IOException {
    if (began == 0) {
      began = System.nanoTime();
    }
    if (place == null && in.available() == 0) {
      if (!places.take(who)) {
        throw Refusal.busy(
            "The server waits for as many bodies of requests as it can; try again in some seconds.");
      }
      place = who;
    }
  }

  private Duration allowed(BodyPlaces.Waiter who) {
    return who.stranger()
        ? limits.signInBodyTime()
        : limits.bodyTime().plusSeconds(count / BYTES_A_SECOND);
  }

  private Refusal tooSlow() {
    return Refusal.tooSlow(
        "The body arrives too slowly: %d bytes in %d s. Send it faster."
            .formatted(count, Duration.ofNanos(System.nanoTime() - began).toSeconds()));
  }

  private static boolean isTimeout(IOException e) {
    for (Throwable cause = e; cause != null; cause = cause.getCause()) {
      if (cause instanceof SocketTimeoutException) {
        return true;
      }
    }
    return false;
  }

  /** Nothing more is read. */
  void end() {
    over = true;
    if (place != null) {
      places.leave(place);
      place = null;
    }
  }

  @Override
  public int available() throws IOException {
    return over ? 0 : in.available();
  }

  @Override
  public boolean isFinished() {
    return over || in.isFinished();
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
