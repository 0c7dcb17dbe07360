package org.sitaf.cli.debug;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.HexFormat;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.simulation.LiveMotion;
import org.sitaf.agent.simulation.SimulatorException;
import tools.jackson.databind.json.JsonMapper;

/**
 * Serves a page with the scene of the case that runs, for a browser on this machine. The address
 * contains a secret, so other users of the machine cannot read it.
 */
public final class SceneServer implements AutoCloseable {
  private static final String PAGE = "/org/sitaf/webapp/live/";
  private static final Pattern FILE =
      Pattern.compile("(?:assets/)?[A-Za-z0-9_-]+\\.(js|css|html|svg)");
  private static final Map<String, String> TYPES =
      Map.of(
          "js", "text/javascript; charset=utf-8",
          "css", "text/css; charset=utf-8",
          "html", "text/html; charset=utf-8",
          "svg", "image/svg+xml");
  private static final String POLICY =
      "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self'"
          + " data:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors"
          + " 'none'";
  private static final int SECRET_BYTES = 16;
  private static final int OK = 200;
  private static final int NO_CONTENT = 204;
  private static final int NOT_MODIFIED = 304;
  private static final int NOT_FOUND = 404;
  private static final int UNAVAILABLE = 503;

  private final WatchedCase watched;
  private final HttpServer server;
  private final ExecutorService threads =
      Executors.newCachedThreadPool(
          work -> {
            Thread thread = new Thread(work, "sitaf-scene");
            thread.setDaemon(true);
            return thread;
          });
  private final URI address;
  private LiveMotion source = known -> Optional.empty();
  private LiveMotion.@Nullable Motion last;
  private boolean ended;

  /** Starts to serve the page of a case on a free port of the loopback interface. */
  public SceneServer(WatchedCase watched) throws IOException {
    this.watched = watched;
    byte[] secret = new byte[SECRET_BYTES];
    new SecureRandom().nextBytes(secret);
    InetAddress loopback = InetAddress.getByAddress(new byte[] {127, 0, 0, 1});
    server = HttpServer.create(new InetSocketAddress(loopback, 0), 0);
    address =
        URI.create(
            "http://127.0.0.1:"
                + server.getAddress().getPort()
                + "/"
                + HexFormat.of().formatHex(secret)
                + "/");
    server.createContext("/", this::answer);
    server.setExecutor(threads);
    server.start();
  }

  /** The page. */
  public URI address() {
    return address;
  }

  /** Shows the motion of a simulation from now on. */
  public synchronized void show(LiveMotion motion) {
    source = motion;
  }

  /** Shows the recording of the case, which has ended. */
  public void end(Path recording) throws IOException {
    byte[] glb = Files.readAllBytes(recording);
    synchronized (this) {
      last = new LiveMotion.Motion(glb, last == null ? 1 : last.version() + 1);
      ended = true;
    }
  }

  private void answer(HttpExchange exchange) throws IOException {
    try (exchange) {
      exchange.getResponseHeaders().set("Content-Security-Policy", POLICY);
      exchange.getResponseHeaders().set("X-Content-Type-Options", "nosniff");
      exchange.getResponseHeaders().set("Referrer-Policy", "no-referrer");
      exchange.getResponseHeaders().set("Cache-Control", "no-store");
      String path = exchange.getRequestURI().getPath();
      // Another host name of this address would be a page of somebody else.
      if (!exchange.getRequestMethod().equals("GET")
          || !address.getAuthority().equals(exchange.getRequestHeaders().getFirst("Host"))
          || !path.startsWith(address.getPath())) {
        exchange.sendResponseHeaders(NOT_FOUND, -1);
        return;
      }
      String name = path.substring(address.getPath().length());
      switch (name) {
        case "case.json" ->
            send(
                exchange,
                "application/json",
                JsonMapper.shared().writeValueAsBytes(watched.document(hasEnded())));
        case "motion.glb" -> sendMotion(exchange);
        default -> sendFile(exchange, name.isEmpty() ? "live.html" : name);
      }
    }
  }

  private synchronized boolean hasEnded() {
    return ended;
  }

  private void sendMotion(HttpExchange exchange) throws IOException {
    LiveMotion.Motion shown;
    try {
      shown = newest();
    } catch (SimulatorException e) {
      exchange.sendResponseHeaders(UNAVAILABLE, -1);
      return;
    }
    if (shown == null) {
      exchange.sendResponseHeaders(NO_CONTENT, -1);
      return;
    }
    String tag = "\"" + shown.version() + "\"";
    exchange.getResponseHeaders().set("ETag", tag);
    if (tag.equals(exchange.getRequestHeaders().getFirst("If-None-Match"))) {
      exchange.sendResponseHeaders(NOT_MODIFIED, -1);
    } else {
      send(exchange, "model/gltf-binary", shown.glb());
    }
  }

  private synchronized LiveMotion.@Nullable Motion newest() throws SimulatorException {
    if (!ended) {
      source.since(last == null ? 0 : last.version()).ifPresent(motion -> last = motion);
    }
    return last;
  }

  private static void sendFile(HttpExchange exchange, String name) throws IOException {
    var matched = FILE.matcher(name);
    try (InputStream file =
        matched.matches() ? SceneServer.class.getResourceAsStream(PAGE + name) : null) {
      if (file == null) {
        exchange.sendResponseHeaders(NOT_FOUND, -1);
      } else {
        send(exchange, TYPES.get(matched.group(1)), file.readAllBytes());
      }
    }
  }

  private static void send(HttpExchange exchange, String type, byte[] content) throws IOException {
    exchange.getResponseHeaders().set("Content-Type", type);
    exchange.sendResponseHeaders(OK, content.length == 0 ? -1 : content.length);
    exchange.getResponseBody().write(content);
  }

  @Override
  public void close() {
    server.stop(0);
    threads.shutdownNow();
  }
}
