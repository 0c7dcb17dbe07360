package org.sitaf.agent.toolchain.python.environment;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.time.Duration;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.spool.SharedCache;
import org.sitaf.agent.testing.EchoActivity;

/** A package index on this machine. */
final class LocalIndex implements AutoCloseable {
  private final HttpServer server;
  private final Map<String, Map<String, byte[]>> packages = new TreeMap<>();
  private final List<String> requests = new CopyOnWriteArrayList<>();

  LocalIndex() throws IOException {
    server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    server.createContext("/", this::answer);
    server.start();
  }

  /** Environments with an empty cache, whose pip uses this index in addition to its own. */
  Environments environments(Path directory, Sandbox sandbox) throws Exception {
    Path runtime = EchoActivity.places().runtimes().resolve("runtime-python");
    Path shared = EchoActivity.places().cache().resolve("python");
    Interpreter interpreter = Interpreter.find().orElseThrow();
    new Environments(interpreter, runtime, new SharedCache(shared), PipSettings.ofThisMachine())
        .with(
            Requirements.NONE,
            Files.createTempDirectory(directory, "base"),
            Duration.ofMinutes(4),
            sandbox);
    SharedCache cache =
        new SharedCache(Files.createDirectories(directory.resolve("cache")), shared);
    Map<String, String> variables = new HashMap<>(System.getenv());
    variables.put("PIP_EXTRA_INDEX_URL", url());
    return new Environments(interpreter, runtime, cache, PipSettings.of(variables, directory));
  }

  String url() {
    return "http://127.0.0.1:" + server.getAddress().getPort() + "/simple/";
  }

  int port() {
    return server.getAddress().getPort();
  }

  /** The requests, by path. */
  List<String> requests() {
    return requests;
  }

  void add(String name, String file, byte[] content) {
    packages.computeIfAbsent(name, unused -> new TreeMap<>()).put(file, content);
  }

  private void answer(HttpExchange exchange) throws IOException {
    String path = exchange.getRequestURI().getPath();
    requests.add(path);
    String[] parts = path.split("/");
    Map<String, byte[]> files = parts.length > 2 ? packages.get(parts[2]) : null;
    byte[] body = null;
    if (files != null && parts.length == 3) {
      StringBuilder page = new StringBuilder("<!DOCTYPE html><html><body>");
      for (Map.Entry<String, byte[]> file : files.entrySet()) {
        page.append(
            "<a href=\"%s#sha256=%s\">%s</a>"
                .formatted(file.getKey(), sha256(file.getValue()), file.getKey()));
      }
      body = page.append("</body></html>").toString().getBytes(StandardCharsets.UTF_8);
      exchange.getResponseHeaders().add("Content-Type", "text/html");
    } else if (files != null && parts.length == 4) {
      body = files.get(parts[3]);
    }
    try (exchange) {
      exchange.sendResponseHeaders(body == null ? 404 : 200, body == null ? -1 : body.length);
      if (body != null) {
        exchange.getResponseBody().write(body);
      }
    }
  }

  private static String sha256(byte[] content) {
    try {
      return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(content));
    } catch (java.security.NoSuchAlgorithmException e) {
      throw new AssertionError(e);
    }
  }

  /** An archive of texts by name. */
  static byte[] zip(Map<String, String> files) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
      for (Map.Entry<String, String> file : files.entrySet()) {
        zip.putNextEntry(new ZipEntry(file.getKey()));
        zip.write(file.getValue().getBytes(StandardCharsets.UTF_8));
      }
    }
    return bytes.toByteArray();
  }

  /** A wheel with a module and what it requires. */
  static byte[] wheel(String name, String module, String... requires) throws IOException {
    return release(name, "1.0", module, requires);
  }

  /** A wheel of another release. */
  static byte[] release(String name, String version, String module, String... requires)
      throws IOException {
    return zip(files(name, version, module, requires));
  }

  /** The files of a wheel. */
  static Map<String, String> files(String name, String version, String module, String... requires) {
    StringBuilder metadata = new StringBuilder("Metadata-Version: 2.1\nName: " + name);
    metadata.append("\nVersion: ").append(version).append('\n');
    for (String required : requires) {
      metadata.append("Requires-Dist: ").append(required).append('\n');
    }
    String info = name.replace('-', '_') + "-" + version + ".dist-info/";
    String file = name.replace('-', '_') + ".py";
    return Map.of(
        file,
        module,
        info + "METADATA",
        metadata.toString(),
        info + "WHEEL",
        "Wheel-Version: 1.0\nGenerator: test\nRoot-Is-Purelib: true\nTag: py3-none-any\n",
        info + "RECORD",
        file + ",,\n" + info + "METADATA,,\n" + info + "WHEEL,,\n" + info + "RECORD,,\n");
  }

  @Override
  public void close() {
    server.stop(0);
  }
}
