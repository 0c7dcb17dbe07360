package org.sitaf.server.git.remote;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.time.Duration;
import java.util.concurrent.atomic.AtomicLong;
import org.eclipse.jgit.lib.EmptyProgressMonitor;
import org.eclipse.jgit.lib.ProgressMonitor;

/**
 * Counts what one fetch reads, and stops it beyond its limits. Every byte of the transport passes
 * here, also of an object that never ends.
 */
final class FetchLimits {
  /** The list of the repository's branches; it is held in memory. */
  private static final long MAX_ADVERTISEMENT = 32L << 20;

  private final long deadline;
  private final String time;
  private final long maxBytes;
  private final long maxObject;
  private final AtomicLong advertised = new AtomicLong();
  private final AtomicLong received = new AtomicLong();

  /**
   * Creates the limits of a fetch that begins now.
   *
   * @param maxBytes of the objects together
   */
  FetchLimits(Duration time, long maxBytes, long maxObject) {
    this.deadline = System.nanoTime() + time.toNanos();
    this.time = time.toSeconds() + " s";
    this.maxBytes = maxBytes;
    this.maxObject = maxObject;
  }

  /** A limit was exceeded; the message is for the user. */
  static final class LimitException extends IOException {
    private static final long serialVersionUID = 1L;

    LimitException(String message) {
      super(message);
    }
  }

  long maxObject() {
    return maxObject;
  }

  ProgressMonitor monitor() {
    return new EmptyProgressMonitor() {
      @Override
      public boolean isCancelled() {
        return isLate();
      }
    };
  }

  boolean isLate() {
    return System.nanoTime() - deadline > 0;
  }

  /** Guards a connection before objects are received. */
  InputStream advertisement(InputStream in) {
    return new Counted(in) {
      @Override
      void count(int bytes) throws IOException {
        if (received.get() > 0) {
          return;
        }
        if (advertised.addAndGet(bytes) > MAX_ADVERTISEMENT) {
          throw new LimitException(
              "The repository has too many branches and tags: their list is larger than "
                  + (MAX_ADVERTISEMENT >> 20)
                  + " MiB.");
        }
      }
    };
  }

  /** Guards the stream of objects. */
  InputStream objects(InputStream in) {
    received.incrementAndGet();
    return new Counted(in) {
      @Override
      void count(int bytes) throws IOException {
        if (received.addAndGet(bytes) > maxBytes) {
          throw new LimitException(
              "The repository is larger than "
                  + (maxBytes >> 20)
                  + " MiB. Move the activity to a smaller repository, or ask the administrator to"
                  + " raise sitaf.git.max-repository.");
        }
      }
    };
  }

  LimitException late() {
    return new LimitException(
        "The fetch took longer than "
            + time
            + ". Try again later, use a smaller repository, or ask the administrator to raise"
            + " sitaf.git.fetch-time.");
  }

  private abstract class Counted extends FilterInputStream {
    Counted(InputStream in) {
      super(in);
    }

    abstract void count(int bytes) throws IOException;

    @Override
    public int read() throws IOException {
      int read = in.read();
      check(read < 0 ? 0 : 1);
      return read;
    }

    @Override
    public int read(byte[] buffer, int offset, int length) throws IOException {
      int read = in.read(buffer, offset, length);
      check(Math.max(read, 0));
      return read;
    }

    private void check(int bytes) throws IOException {
      if (isLate()) {
        throw late();
      }
      count(bytes);
    }
  }
}
