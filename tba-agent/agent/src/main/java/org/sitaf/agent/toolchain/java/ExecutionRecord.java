package org.sitaf.agent.toolchain.java;

import java.io.IOException;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.HashSet;
import java.util.Set;
import java.util.function.Predicate;
import org.jacoco.core.data.ExecutionData;
import org.jacoco.core.data.ExecutionDataStore;

/**
 * What JaCoCo recorded, out of files that the component could write as well. JaCoCo's own reader
 * believes every length that a file names and keeps whatever it holds; this one makes nothing
 * larger than what is there, and only of the component's classes.
 */
final class ExecutionRecord {
  private static final byte HEADER = 0x01;
  private static final byte SESSION = 0x10;
  private static final byte EXECUTION = 0x11;
  private static final int MAGIC_AND_VERSION = 0xC0C0_1007;
  private static final int SESSION_TIMES = 2 * Long.BYTES;
  private static final int CONTINUES = 0x80;
  private static final int MOST_CLASSES = 50_000;

  /** A class of 64 KiB methods does not come near. */
  private static final int MOST_PROBES = 1 << 20;

  private final ExecutionDataStore store = new ExecutionDataStore();
  private final Set<Long> known = new HashSet<>();
  private final Predicate<String> wanted;

  /**
   * Nothing yet.
   *
   * @param wanted tells by the name of a class, with slashes, whether it is the component's
   */
  ExecutionRecord(Predicate<String> wanted) {
    this.wanted = wanted;
  }

  ExecutionDataStore store() {
    return store;
  }

  /**
   * Adds what a process recorded. One that was killed may leave half a record behind; what comes
   * before the half still counts.
   */
  void add(byte[] file) {
    ByteBuffer in = ByteBuffer.wrap(file);
    try {
      while (in.hasRemaining()) {
        addBlock(in);
      }
    } catch (BufferUnderflowException | IOException e) {
      // See above.
    }
  }

  private void addBlock(ByteBuffer in) throws IOException {
    switch (in.get()) {
      case HEADER -> {
        if (in.getInt() != MAGIC_AND_VERSION) {
          throw new IOException("another format");
        }
      }
      case SESSION -> {
        text(in);
        skip(in, SESSION_TIMES);
      }
      case EXECUTION -> addExecution(in);
      default -> throw new IOException("another format");
    }
  }

  private void addExecution(ByteBuffer in) throws IOException {
    long id = in.getLong();
    String name = text(in);
    int probes = number(in);
    int bytes = (probes + Byte.SIZE - 1) / Byte.SIZE;
    if (probes < 0 || probes > MOST_PROBES || bytes > in.remaining()) {
      throw new IOException("not that many probes");
    }
    if (!wanted.test(name) || (known.size() >= MOST_CLASSES && !known.contains(id))) {
      skip(in, bytes);
      return;
    }
    boolean[] reached = new boolean[probes];
    int eight = 0;
    for (int i = 0; i < probes; i++) {
      eight = i % Byte.SIZE == 0 ? in.get() : eight >>> 1;
      reached[i] = (eight & 1) != 0;
    }
    known.add(id);
    try {
      store.put(new ExecutionData(id, name, reached));
    } catch (IllegalStateException e) {
      // It contradicts what another process recorded of the class.
    }
  }

  private static String text(ByteBuffer in) {
    byte[] text = new byte[Short.toUnsignedInt(in.getShort())];
    in.get(text);
    // Names of classes beyond ASCII are written in almost the same way.
    return new String(text, StandardCharsets.UTF_8);
  }

  private static int number(ByteBuffer in) {
    int value = 0;
    int shift = 0;
    int next;
    do {
      next = Byte.toUnsignedInt(in.get());
      value |= shift < Integer.SIZE ? (next & ~CONTINUES) << shift : 0;
      shift += 7;
    } while ((next & CONTINUES) != 0);
    return value;
  }

  private static void skip(ByteBuffer in, int bytes) throws IOException {
    if (bytes > in.remaining()) {
      throw new IOException("it ends too early");
    }
    in.position(in.position() + bytes);
  }
}
