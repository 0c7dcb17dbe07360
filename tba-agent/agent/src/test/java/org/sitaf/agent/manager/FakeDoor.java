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
 * Lets agents into the server at the rim: refuses every call but enrolment that does not show a key
 * it has given.
 */
final class FakeDoor implements ServerInterceptor {
  static final String ENROLMENT = "enrolment of the tests";

  private static final Metadata.Key<String> AUTHORIZATION =
      Metadata.Key.of("authorization", Metadata.ASCII_STRING_MARSHALLER);

  /** As they are shown. */
  private final List<String> keys = new ArrayList<>();

  private boolean open;

  @Override
  public <Q, A> ServerCall.Listener<Q> interceptCall(
      ServerCall<Q, A> call, Metadata headers, ServerCallHandler<Q, A> next) {
    boolean enrols = call.getMethodDescriptor() == (Object) AgentServiceGrpc.getEnrolMethod();
    if (!enrols && !letsIn(headers.get(AUTHORIZATION))) {
      call.close(Status.UNAUTHENTICATED, new Metadata());
      return new ServerCall.Listener<>() {};
    }
    return next.startCall(call, headers);
  }

  private synchronized boolean letsIn(@Nullable String key) {
    return open || keys.contains(String.valueOf(key));
  }

  /** Asks for no keys any more. */
  synchronized void letAllIn() {
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
