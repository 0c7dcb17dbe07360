package org.sitaf.server.support;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Base64;
import java.util.Map;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/** Serves repositories by smart HTTP with {@code git http-backend}, for one user. */
public final class GitHttpServer implements AutoCloseable {
  private final HttpServer server;
  private final ExecutorService threads = Executors.newCachedThreadPool();
  private final Path root;
  private volatile String authorization;

  /** Serves the repositories of a folder on a free port of the loopback. */
  public GitHttpServer(Path root, String user, String token) {
    this.root = root;
    this.authorization = basic(user, token);
    try {
      server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    server.setExecutor(threads);
    server.createContext("/", this::handle);
    server.start();
  }

  private static String basic(String user, String token) {
    return "Basic "
        + Base64.getEncoder().encodeToString((user + ":" + token).getBytes(StandardCharsets.UTF_8));
  }

  public String url(String path) {
    return "http://localhost:" + server.getAddress().getPort() + "/" + path;
  }

  /** Lets the former token expire. */
  public void expect(String user, String token) {
    authorization = basic(user, token);
  }

  private void handle(HttpExchange exchange) throws IOException {
    try (exchange) {
      if (!authorization.equals(exchange.getRequestHeaders().getFirst("Authorization"))) {
        exchange.getResponseHeaders().add("WWW-Authenticate", "Basic realm=\"git\"");
        exchange.sendResponseHeaders(401, -1);
        return;
      }
      answer(exchange, run(exchange));
    }
  }

  private byte[] run(HttpExchange exchange) throws IOException {
    ProcessBuilder builder = new ProcessBuilder("git", "http-backend");
    Map<String, String> environment = builder.environment();
    environment.put("GIT_PROJECT_ROOT", root.toString());
    environment.put("GIT_HTTP_EXPORT_ALL", "1");
    environment.put("GIT_CONFIG_GLOBAL", "/dev/null");
    environment.put("PATH_INFO", exchange.getRequestURI().getPath());
    environment.put("REQUEST_METHOD", exchange.getRequestMethod());
    environment.put("REMOTE_USER", "tester");
    String query = exchange.getRequestURI().getQuery();
    environment.put("QUERY_STRING", query == null ? "" : query);
    putHeader(exchange, environment, "Content-Type", "CONTENT_TYPE");
    putHeader(exchange, environment, "Content-Encoding", "HTTP_CONTENT_ENCODING");
    putHeader(exchange, environment, "Git-Protocol", "GIT_PROTOCOL");
    byte[] body = exchange.getRequestBody().readAllBytes();
    environment.put("CONTENT_LENGTH", Integer.toString(body.length));
    Process process = builder.redirectError(ProcessBuilder.Redirect.DISCARD).start();
    try (var in = process.getOutputStream()) {
      in.write(body);
    }
    try (InputStream out = process.getInputStream()) {
      return out.readAllBytes();
    }
  }

  private static void putHeader(
      HttpExchange exchange, Map<String, String> environment, String header, String variable) {
    String value = exchange.getRequestHeaders().getFirst(header);
    if (value != null) {
      environment.put(variable, value);
    }
  }

  /** Sends what a CGI program wrote: headers, an empty line, the body. */
  private static void answer(HttpExchange exchange, byte[] written) throws IOException {
    int status = 200;
    int at = 0;
    while (at < written.length) {
      ByteArrayOutputStream line = new ByteArrayOutputStream();
      while (written[at] != '\n') {
        line.write(written[at++]);
      }
      at++;
      String header = line.toString(StandardCharsets.UTF_8).strip();
      if (header.isEmpty()) {
        break;
      }
      int colon = header.indexOf(':');
      String value = header.substring(colon + 1).strip();
      if (header.startsWith("Status:")) {
        status = Integer.parseInt(value.substring(0, 3));
      } else {
        exchange.getResponseHeaders().add(header.substring(0, colon), value);
      }
    }
    int length = written.length - at;
    exchange.sendResponseHeaders(status, length == 0 ? -1 : length);
    if (length > 0) {
      exchange.getResponseBody().write(written, at, length);
    }
  }

  @Override
  public void close() {
    server.stop(0);
    threads.shutdownNow();
  }
}
