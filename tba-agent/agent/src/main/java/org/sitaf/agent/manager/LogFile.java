package org.sitaf.agent.manager;

import com.google.protobuf.ByteString;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * Cuts a log into chunks that the protocol takes: at most 64 KiB, each whole characters of UTF-8.
 */
final class LogFile {
  private static final int CONTINUATION_MASK = 0xC0;
  private static final int CONTINUATION = 0x80;

  private LogFile() {}

  /**
   * The chunk that begins at an offset; empty at the end of the file, or where there is no file
   * yet.
   */
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
