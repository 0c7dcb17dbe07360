package org.sitaf.runtime.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import io.grpc.Status;
import io.grpc.StatusRuntimeException;
import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.Channels;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.sim.v1.OperateRequest;
import org.sitaf.sim.v1.OperateResponse;
import org.sitaf.sim.v1.Refusal;
import org.sitaf.sim.v1.StepSimulationRequest;
import org.sitaf.sim.v1.WorldState;

/** The client of the socket of operations with a server that answers with the number of steps. */
@Timeout(60)
class OperationSocketTest {
  private static final int REFUSED = 13;
  private static final int UNANSWERED = 14;
  private static final int LAST = 15;

  @TempDir Path folder;
  private final CountDownLatch unanswered = new CountDownLatch(1);
  private ServerSocketChannel server;
  private Thread accepting;
  private String path;

  @BeforeEach
  void listen() throws IOException {
    path = folder.resolve("s.ops").toString();
    server = ServerSocketChannel.open(StandardProtocolFamily.UNIX);
    server.bind(UnixDomainSocketAddress.of(path));
    accepting = new Thread(this::accept, "server");
    accepting.setDaemon(true);
    accepting.start();
  }

  @AfterEach
  void end() throws Exception {
    server.close();
    // A thread that waits in accept() takes one more connection until it has been woken.
    accepting.join();
  }

  private void accept() {
    while (true) {
      try {
        SocketChannel connection = server.accept();
        Thread thread = new Thread(() -> serve(connection), "connection");
        thread.setDaemon(true);
        thread.start();
      } catch (IOException e) {
        return;
      }
    }
  }

  private void serve(SocketChannel connection) {
    try (connection) {
      while (true) {
        OperateRequest request = OperateRequest.parseFrom(read(connection, read(connection)));
        long steps = request.getStep().getSteps();
        if (steps == UNANSWERED) {
          unanswered.countDown();
          continue;
        }
        if (steps == LAST) {
          return;
        }
        OperateResponse response =
            steps == REFUSED
                ? OperateResponse.newBuilder()
                    .setRefusal(
                        Refusal.newBuilder()
                            .setCode(Status.Code.OUT_OF_RANGE.value())
                            .setMessage("too far"))
                    .build()
                : OperateResponse.newBuilder()
                    .setState(WorldState.newBuilder().setStep(steps))
                    .build();
        ByteBuffer frame =
            ByteBuffer.allocate(4 + response.getSerializedSize()).order(ByteOrder.LITTLE_ENDIAN);
        frame.putInt(response.getSerializedSize()).put(response.toByteArray()).flip();
        // One byte at a time.
        while (frame.hasRemaining()) {
          connection.write(frame.slice(frame.position(), 1));
          frame.get();
        }
      }
    } catch (IOException e) {
      // The client has gone.
    }
  }

  private static int read(SocketChannel connection) throws IOException {
    return ByteBuffer.wrap(read(connection, 4)).order(ByteOrder.LITTLE_ENDIAN).getInt();
  }

  private static byte[] read(SocketChannel connection, int length) throws IOException {
    byte[] bytes = Channels.newInputStream(connection).readNBytes(length);
    if (bytes.length < length) {
      throw new IOException("end of stream");
    }
    return bytes;
  }

  private static OperateRequest step(long steps) {
    return OperateRequest.newBuilder()
        .setStep(StepSimulationRequest.newBuilder().setSteps(steps))
        .build();
  }

  @Test
  void operationsAreAnsweredAndRefusalsHaveTheStatusOfACall() {
    try (OperationSocket socket = OperationSocket.open(path).orElseThrow()) {
      assertThat(socket.operate(step(1)).getStep()).isEqualTo(1);
      assertThatExceptionOfType(StatusRuntimeException.class)
          .isThrownBy(() -> socket.operate(step(REFUSED)))
          .satisfies(
              e -> assertThat(e.getStatus().getCode()).isEqualTo(Status.Code.OUT_OF_RANGE),
              e -> assertThat(e.getStatus().getDescription()).isEqualTo("too far"));
      assertThat(socket.operate(step(2)).getStep()).isEqualTo(2);
    }
  }

  @Test
  void aRequestLargerThanTheBufferIsSent() {
    try (OperationSocket socket = OperationSocket.open(path).orElseThrow()) {
      OperateRequest large =
          OperateRequest.newBuilder()
              .setStep(
                  StepSimulationRequest.newBuilder()
                      .setSteps(3)
                      .setSessionId("s".repeat(1_000_000)))
              .build();
      assertThat(socket.operate(large).getStep()).isEqualTo(3);
    }
  }

  @Test
  void anInterruptCancelsOneOperationOnly() throws InterruptedException {
    try (OperationSocket socket = OperationSocket.open(path).orElseThrow()) {
      Status[] status = new Status[1];
      boolean[] interrupted = new boolean[1];
      Thread component =
          new Thread(
              () -> {
                try {
                  socket.operate(step(UNANSWERED));
                } catch (StatusRuntimeException e) {
                  status[0] = e.getStatus();
                  interrupted[0] = Thread.currentThread().isInterrupted();
                }
              });
      component.start();
      unanswered.await();
      component.interrupt();
      component.join();
      assertThat(status[0].getCode()).isEqualTo(Status.Code.CANCELLED);
      assertThat(status[0].getCause()).isInstanceOf(InterruptedException.class);
      assertThat(interrupted[0]).isTrue();
      assertThat(socket.operate(step(4)).getStep()).isEqualTo(4);
    }
  }

  @Test
  void aSimulatorThatHasGoneIsUnavailable() throws Exception {
    try (OperationSocket socket = OperationSocket.open(path).orElseThrow()) {
      end();
      for (int attempt = 0; attempt < 2; attempt++) {
        assertThatExceptionOfType(StatusRuntimeException.class)
            .isThrownBy(() -> socket.operate(step(LAST)))
            .satisfies(e -> assertThat(e.getStatus().getCode()).isEqualTo(Status.Code.UNAVAILABLE));
      }
    }
  }

  @Test
  void withoutAServerThereIsNone() throws Exception {
    end();
    Optional<OperationSocket> opened = OperationSocket.open(path);
    assertThat(opened).isEmpty();
    assertThat(OperationSocket.open(folder.resolve("x".repeat(200)).toString())).isEmpty();
  }
}
