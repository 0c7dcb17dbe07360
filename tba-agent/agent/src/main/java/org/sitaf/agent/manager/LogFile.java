package org.sitaf.agent.manager;

import com.google.protobuf.ByteString;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * Splits a log into chunks of at most 64 KiB that end at UTF-8 character boundaries, as the
 * protocol requires.
 */
final class LogFile {
  private static final int CONTINUATION_MASK = 0xC0;
  private static final int CONTINUATION = 0x80;

  private LogFile() {}

  /** The chunk at an offset; empty at the end of the file or if the file does not exist yet. */
  static ByteString chunk(Path file, long offset) throws IOException {
    if (!Files.isRegularFile(file)) {
      return ByteString.EMPTY;
    }
    ByteBuffer buffer = ByteBuffer.allocate(ServerCalls.MAX_LOG_CHUNK);
    try (FileChannel channel = FileChannel.open(file, StandardOpenOption.READ)) {
      while (buffer.hasRemaining() && channel.read(buffer, offset + buffer.position()) > 0) {
        // Read until the chunk is full or the file ends.
      }
    }
    boolean full = !buffer.hasRemaining();
    buffer.flip();
    byte[] bytes = buffer.array();
    int length = buffer.limit();
    if (full) {
      int lead = length - 1;
      while (lead > 0 && (bytes[lead] & CONTINUATION_MASK) == CONTINUATION) {
        lead--;
      }
      if (lead > 0 && lead + sequenceLength(bytes[lead]) > length) {
        length = lead;
      }
    }
    return ByteString.copyFrom(bytes, 0, length);
  }

  private static int sequenceLength(byte lead) {
    int ones = Integer.numberOfLeadingZeros(~(lead << 24));
    return ones == 0 ? 1 : ones;
  }
}
