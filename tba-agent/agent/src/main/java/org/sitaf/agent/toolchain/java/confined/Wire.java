package org.sitaf.agent.toolchain.java.confined;

import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/**
 * Messages between the agent and a confined process: a header line with a word and the lengths of
 * the parts, then the bytes of the parts. The reader limits the total size, because the process is
 * not trusted.
 */
public final class Wire {
  /** The process has started and waits for its request. */
  public static final String READY = "ready";

  /** Path below the working folder and content of a jar. */
  public static final String JAR = "jar";

  /**
   * Class path entry: path of a jar that was sent, or absolute path of a jar that the process can
   * read.
   */
  public static final String CLASS_PATH = "classpath";

  /** Number and text of a source. */
  public static final String SOURCE = "source";

  /** Name of the class under test, and the prefix of generated classes. */
  public static final String COMPONENT = "component";

  /** The request is complete. */
  public static final String COMPILE = "compile";

  /** Path of a class file below the output folder, and its bytes. */
  public static final String CLASS = "class";

  /** Number of the source or -1, line and column or 0, and message of an error. */
  public static final String ERROR = "error";

  /**
   * No source or library defines the class under test; names of the classes that the sources
   * define.
   */
  public static final String ABSENT = "absent";

  /** Path of a library that is not a jar, and the reason. */
  public static final String NOT_A_JAR = "notajar";

  /** The compiler failed with this exception. */
  public static final String GAVE_UP = "gaveup";

  /** The answer is complete; the number of errors. */
  public static final String DONE = "done";

  /** Exit code of the JVM after an OutOfMemoryError. */
  public static final int OUT_OF_MEMORY = 3;

  private static final Pattern HEAD = Pattern.compile("([a-z]{1,12})((?: [0-9]{1,10}){0,4})");
  private static final int MAX_HEAD = 80;
  private static final int BUFFER = 1 << 16;

  private Wire() {}

  /** Writes a message. */
  public static void write(OutputStream output, String word, byte[]... parts) throws IOException {
    StringBuilder head = new StringBuilder(word);
    for (byte[] part : parts) {
      head.append(' ').append(part.length);
    }
    output.write(head.append('\n').toString().getBytes(StandardCharsets.US_ASCII));
    for (byte[] part : parts) {
      output.write(part);
    }
  }

  /** Writes a message of text parts. */
  public static void write(OutputStream output, String word, String... parts) throws IOException {
    byte[][] bytes = new byte[parts.length][];
    for (int i = 0; i < parts.length; i++) {
      bytes[i] = parts[i].getBytes(StandardCharsets.UTF_8);
    }
    write(output, word, bytes);
  }

  /** A violation of the protocol. */
  public static final class ProtocolException extends IOException {
    private static final long serialVersionUID = 1L;

    ProtocolException(String message) {
      super(message);
    }
  }

  /**
   * A message.
   *
   * @param word type of the message
   * @param parts number and meaning depend on the type
   */
  public record Message(String word, List<byte[]> parts) {
    public Message {
      parts = List.copyOf(parts);
    }

    /** A part as bytes. */
    public byte[] bytes(int part) throws ProtocolException {
      if (part >= parts.size()) {
        throw new ProtocolException("a message '" + word + "' lacks a part");
      }
      return parts.get(part);
    }

    /** A part as text. */
    public String text(int part) throws ProtocolException {
      return new String(bytes(part), StandardCharsets.UTF_8);
    }

    /** A part as a number, at least -1. */
    public int number(int part) throws ProtocolException {
      String text = text(part);
      if (!text.matches("-1|[0-9]{1,9}")) {
        throw new ProtocolException("message '" + word + "' has an invalid number");
      }
      return Integer.parseInt(text);
    }
  }

  /** Reads messages up to a total size. */
  public static final class Reader {
    private final InputStream input;
    private long left;

    /** Creates a reader; the limit covers everything that it reads. */
    public Reader(InputStream input, long maxBytes) {
      this.input = input;
      this.left = maxBytes;
    }

    /**
     * The next message.
     *
     * @throws EOFException at the end of the stream
     * @throws ProtocolException if the message is invalid or too long
     */
    public Message next() throws IOException {
      var head = HEAD.matcher(head());
      if (!head.matches()) {
        throw new ProtocolException("not a message");
      }
      List<byte[]> parts = new ArrayList<>();
      for (String length : head.group(2).strip().split(" ")) {
        if (!length.isEmpty()) {
          parts.add(bytes(Long.parseLong(length)));
        }
      }
      return new Message(head.group(1), parts);
    }

    private String head() throws IOException {
      StringBuilder head = new StringBuilder();
      for (int c = input.read(); c != '\n'; c = input.read()) {
        if (c < 0) {
          throw new EOFException("the stream ends");
        }
        if (head.length() == MAX_HEAD) {
          throw new ProtocolException("not a message");
        }
        head.append((char) c);
      }
      take(head.length() + 1L);
      return head.toString();
    }

    private byte[] bytes(long length) throws IOException {
      take(length);
      // Allocates memory as bytes arrive, not as announced.
      ByteArrayOutputStream bytes = new ByteArrayOutputStream((int) Math.min(length, BUFFER));
      byte[] buffer = new byte[(int) Math.min(length, BUFFER)];
      for (long missing = length; missing > 0; ) {
        int n = input.read(buffer, 0, (int) Math.min(missing, buffer.length));
        if (n < 0) {
          throw new EOFException("the stream ends");
        }
        bytes.write(buffer, 0, n);
        missing -= n;
      }
      return bytes.toByteArray();
    }

    private void take(long bytes) throws ProtocolException {
      left -= bytes;
      if (left < 0) {
        throw new ProtocolException("more bytes than allowed");
      }
    }
  }
}
