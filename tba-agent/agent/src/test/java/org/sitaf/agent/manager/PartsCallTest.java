package org.sitaf.agent.manager;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.google.protobuf.ByteString;
import io.grpc.ManagedChannel;
import io.grpc.Status;
import io.grpc.StatusRuntimeException;
import io.grpc.netty.shaded.io.grpc.netty.NettyChannelBuilder;
import java.io.IOException;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.v1.SubmitResultRequest;
import org.sitaf.core.digest.Sha256;

/** Large messages are sent in parts if the server supports them. */
class PartsCallTest {
  private static final int LARGE = (6 << 20) + 123;

  private FakeServer server;
  private ManagedChannel channel;

  @BeforeEach
  void start() throws IOException {
    server = FakeServer.start();
    server.door().disableAuthentication();
    channel = NettyChannelBuilder.forTarget(server.address()).usePlaintext().build();
  }

  @AfterEach
  void end() {
    channel.shutdownNow();
    server.close();
  }

  @Test
  void sendsALargeResultInParts() {
    SubmitResultRequest request = request(LARGE);
    new ServerCalls(channel).submit(request);
    assertThat(server.parts()).isEqualTo(7);
    assertThat(server.submitted()).containsExactly(request);
  }

  @Test
  void sendsASmallResultInOneMessage() {
    SubmitResultRequest request = request(1000);
    new ServerCalls(channel).submit(request);
    assertThat(server.parts()).isZero();
    assertThat(server.submitted()).containsExactly(request);
  }

  @Test
  void sendsOneMessageToAServerWithoutParts() {
    server.disableParts();
    SubmitResultRequest request = request(LARGE);
    new ServerCalls(channel).submit(request);
    assertThat(server.submitted()).containsExactly(request);
  }

  @Test
  void reportsTheStatusOfRejectedParts() {
    server.refuseSubmit(Status.FAILED_PRECONDITION.withDescription("the attempt was given up"));
    assertThatThrownBy(() -> new ServerCalls(channel).submit(request(LARGE)))
        .isInstanceOf(StatusRuntimeException.class)
        .hasMessageContaining("the attempt was given up");
  }

  private static SubmitResultRequest request(int size) {
    byte[] document = new byte[size];
    new Random(1).nextBytes(document);
    return SubmitResultRequest.newBuilder()
        .setAttempt(FakeServer.attempt("b", 1, 1))
        .setResultDescriptor(ByteString.copyFrom(document))
        .setSha256(Sha256.hex(document))
        .build();
  }
}
