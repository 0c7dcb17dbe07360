package org.sitaf.agent.manager;

import io.grpc.Metadata;
import io.grpc.ServerCall;
import io.grpc.ServerCallHandler;
import io.grpc.ServerInterceptor;
import io.grpc.Status;
import io.grpc.stub.StreamObserver;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.v1.AgentServiceGrpc;
import org.sitaf.agent.v1.EnrolRequest;
import org.sitaf.agent.v1.EnrolResponse;

/**
 * Authentication of the fake server: rejects every call except enrolment without a key that it has
 * issued.
 */
final class FakeAuthentication implements ServerInterceptor {
  static final String ENROLMENT = "enrolment of the tests";

  private static final Metadata.Key<String> AUTHORIZATION =
      Metadata.Key.of("authorization", Metadata.ASCII_STRING_MARSHALLER);

  /** The issued keys, as clients send them. */
  private final List<String> keys = new ArrayList<>();

  private boolean open;

  @Override
  public <Q, A> ServerCall.Listener<Q> interceptCall(
      ServerCall<Q, A> call, Metadata headers, ServerCallHandler<Q, A> next) {
    boolean enrols = call.getMethodDescriptor() == (Object) AgentServiceGrpc.getEnrolMethod();
    if (!enrols && !isKnownKey(headers.get(AUTHORIZATION))) {
      call.close(Status.UNAUTHENTICATED, new Metadata());
      return new ServerCall.Listener<>() {};
    }
    return next.startCall(call, headers);
  }

  private synchronized boolean isKnownKey(@Nullable String key) {
    return open || keys.contains(String.valueOf(key));
  }

  /** Accepts calls without a key. */
  synchronized void disableAuthentication() {
    open = true;
  }

  synchronized void enrol(EnrolRequest request, StreamObserver<EnrolResponse> answers) {
    if (!request.getToken().equals(ENROLMENT)) {
      answers.onError(Status.UNAUTHENTICATED.asRuntimeException());
      return;
    }
    String key = "key-" + request.getName() + "-" + keys.size();
    keys.add("Bearer " + key);
    answers.onNext(EnrolResponse.newBuilder().setKey(key).build());
    answers.onCompleted();
  }
}
