package org.sitaf.server.access;

import static org.assertj.core.api.Assertions.assertThat;

import io.grpc.CallOptions;
import io.grpc.ClientCall;
import io.grpc.ManagedChannel;
import io.grpc.ManagedChannelBuilder;
import io.grpc.Metadata;
import io.grpc.MethodDescriptor;
import io.grpc.Status;
import io.grpc.StatusRuntimeException;
import io.grpc.stub.MetadataUtils;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.v1.AgentServiceGrpc;
import org.sitaf.agent.v1.EnrolRequest;
import org.sitaf.agent.v1.EnrolResponse;
import org.sitaf.server.support.ServerTest;
import org.springframework.test.annotation.DirtiesContext;
import org.springframework.test.context.TestPropertySource;

/** Unauthenticated clients can use little memory and database space. */
@DirtiesContext
@TestPropertySource(
    properties = {
      "sitaf.trusted-proxies=127.0.0.0/8,::1",
      ServerTest.OWN_SCHEDULER + "hostile-enrolments"
    })
class HostileEnrolmentsTest extends ServerTest {
  private static final Metadata.Key<String> FORWARDED =
      Metadata.Key.of("x-forwarded-for", Metadata.ASCII_STRING_MARSHALLER);

  /** As a client stream, so that the headers are sent before the message. */
  private static final MethodDescriptor<EnrolRequest, EnrolResponse> WITHOUT_MESSAGE =
      AgentServiceGrpc.getEnrolMethod().toBuilder()
          .setType(MethodDescriptor.MethodType.CLIENT_STREAMING)
          .build();

  @Test
  void largeMessagesAreRejected() throws Exception {
    ManagedChannel channel = channel("203.0.113.40");
    try {
      for (int mib : new int[] {5, 60}) {
        EnrolRequest large =
            EnrolRequest.newBuilder().setToken("x".repeat(mib << 20)).setName("a").build();
        assertThat(enrol(channel, large).getCode()).isEqualTo(Status.Code.RESOURCE_EXHAUSTED);
      }
      EnrolRequest longer = EnrolRequest.newBuilder().setToken("x".repeat(20_000)).build();
      assertThat(enrol(channel, longer).getCode()).isEqualTo(Status.Code.INVALID_ARGUMENT);
    } finally {
      end(channel);
    }
  }

  @Test
  void pendingEnrolmentsAreLimitedAndTimeOut() throws Exception {
    ManagedChannel channel = channel("203.0.113.41");
    ManagedChannel other = channel("203.0.113.42");
    try {
      List<CompletableFuture<Status>> ends = new ArrayList<>();
      for (int i = 0; i < 40; i++) {
        CompletableFuture<Status> end = new CompletableFuture<>();
        ends.add(end);
        ClientCall<EnrolRequest, EnrolResponse> call =
            channel.newCall(WITHOUT_MESSAGE, CallOptions.DEFAULT);
        call.start(
            new ClientCall.Listener<>() {
              @Override
              public void onClose(Status status, Metadata trailers) {
                end.complete(status);
              }
            },
            new Metadata());
        call.request(1);
      }
      EnrolRequest valid =
          EnrolRequest.newBuilder().setToken(ENROLMENT).setName("a-" + UUID.randomUUID()).build();
      assertThat(enrol(other, valid).isOk()).isTrue();
      List<Status.Code> codes = new ArrayList<>();
      for (CompletableFuture<Status> end : ends) {
        codes.add(end.get(60, TimeUnit.SECONDS).getCode());
      }
      assertThat(codes).containsOnly(Status.Code.RESOURCE_EXHAUSTED, Status.Code.DEADLINE_EXCEEDED);
      assertThat(codes).filteredOn(Status.Code.DEADLINE_EXCEEDED::equals).hasSizeLessThan(10);
    } finally {
      end(channel);
      end(other);
    }
  }

  @Test
  void failedEnrolmentsAreThrottledAndSummarizedInTheAuditLog() throws Exception {
    String address = "203.0.113.43";
    ManagedChannel channel = channel(address);
    try {
      List<Status.Code> codes = new ArrayList<>();
      for (int i = 0; i < 100; i++) {
        EnrolRequest wrong =
            EnrolRequest.newBuilder().setToken("guess " + i).setName("a" + i).build();
        codes.add(enrol(channel, wrong).getCode());
      }
      assertThat(codes).contains(Status.Code.UNAUTHENTICATED, Status.Code.UNAVAILABLE);
    } finally {
      end(channel);
    }
    long kept =
        api.get("/api/v1/audit?action=enrol&size=500")
            .expect(200)
            .json()
            .get("items")
            .valueStream()
            .filter(event -> event.get("address").asString().equals(address))
            .count();
    assertThat(kept).isBetween(1L, 5L);
  }

  private ManagedChannel channel(String address) {
    Metadata headers = new Metadata();
    headers.put(FORWARDED, address);
    return ManagedChannelBuilder.forAddress("localhost", grpcPort())
        .usePlaintext()
        .intercept(MetadataUtils.newAttachHeadersInterceptor(headers))
        .build();
  }

  private static Status enrol(ManagedChannel channel, EnrolRequest request) {
    try {
      AgentServiceGrpc.newBlockingStub(channel)
          .withDeadlineAfter(60, TimeUnit.SECONDS)
          .enrol(request);
      return Status.OK;
    } catch (StatusRuntimeException e) {
      return e.getStatus();
    }
  }

  private static void end(ManagedChannel channel) throws InterruptedException {
    channel.shutdownNow();
    channel.awaitTermination(10, TimeUnit.SECONDS);
  }
}
