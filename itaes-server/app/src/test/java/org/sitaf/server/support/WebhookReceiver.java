package org.sitaf.server.support;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.security.GeneralSecurityException;
import java.util.HexFormat;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import javax.crypto.Mac;
import javax.crypto.spec.SecretKeySpec;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Another system that the server's webhooks call. */
public final class WebhookReceiver implements AutoCloseable {
  private static final int CONFIRMED = 204;

  private final Queue<Message> messages = new ConcurrentLinkedQueue<>();
  private final Queue<Integer> answers = new ConcurrentLinkedQueue<>();
  private final HttpServer server;

  /** What was received, each attempt for itself. */
  public record Message(String path, String delivery, String signature, String body) {
    /** The body. */
    public JsonNode json() {
      return JsonMapper.shared().readTree(body);
    }

    /** Whether the signature was made with a secret. */
    public boolean isSignedBy(String secret) {
      String[] parts = signature.split("[=,]");
      try {
        Mac mac = Mac.getInstance("HmacSHA256");
        mac.init(new SecretKeySpec(secret.getBytes(StandardCharsets.UTF_8), "HmacSHA256"));
        String signed = parts[1] + "." + body;
        return HexFormat.of()
            .formatHex(mac.doFinal(signed.getBytes(StandardCharsets.UTF_8)))
            .equals(parts[3]);
      } catch (GeneralSecurityException e) {
        throw new IllegalStateException(e);
      }
    }
  }

  /** Starts it on a free port of the loopback. */
  public WebhookReceiver() {
    try {
      server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    server.createContext("/", this::handle);
    server.start();
  }

  private void handle(HttpExchange exchange) throws IOException {
    String body = new String(exchange.getRequestBody().readAllBytes(), StandardCharsets.UTF_8);
    Integer status = answers.poll();
    messages.add(
        new Message(
            exchange.getRequestURI().getPath(),
            exchange.getRequestHeaders().getFirst("Sitaf-Delivery"),
            exchange.getRequestHeaders().getFirst("Sitaf-Signature"),
            body));
    exchange.getResponseHeaders().set("Location", "/elsewhere");
    exchange.sendResponseHeaders(status == null ? CONFIRMED : status, -1);
    exchange.close();
  }

  /** The URL for the webhook. */
  public String url() {
    return "http://localhost:%d/hook".formatted(server.getAddress().getPort());
  }

  /** The status of the next answer that has none yet; the others confirm. */
  public void answer(int status) {
    answers.add(status);
  }

  /** What was received so far. */
  public List<Message> messages() {
    return List.copyOf(messages);
  }

  @Override
  public void close() {
    server.stop(0);
  }
}
