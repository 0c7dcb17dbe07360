package org.sitaf.cli.debug;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.simulation.LiveMotion.Motion;
import org.sitaf.agent.simulation.SimulatorException;

class SceneServerTest {
  @TempDir private Path directory;

  private final HttpClient client = HttpClient.newHttpClient();
  private SceneServer server;

  @BeforeEach
  void start() throws Exception {
    Map<String, String> inputs = new LinkedHashMap<>();
    inputs.put("Name", "\"</script>\"");
    inputs.put("Index", "2");
    server = new SceneServer(new WatchedCase("sensor", "Read", 7, inputs));
  }

  @AfterEach
  void stop() {
    server.close();
  }

  private HttpResponse<byte[]> get(URI address, String... headers) throws Exception {
    HttpRequest.Builder request = HttpRequest.newBuilder(address);
    if (headers.length > 0) {
      request.headers(headers);
    }
    return client.send(request.build(), BodyHandlers.ofByteArray());
  }

  private HttpResponse<byte[]> get(String path, String... headers) throws Exception {
    return get(server.address().resolve(path), headers);
  }

  @Test
  void thePageAndItsFilesAreServedWithAStrictPolicy() throws Exception {
    HttpResponse<byte[]> page = get("");
    assertThat(page.statusCode()).isEqualTo(200);
    String html = new String(page.body());
    assertThat(html).contains("<div id=\"root\">");
    assertThat(page.headers().firstValue("Content-Security-Policy").orElseThrow())
        .startsWith("default-src 'none'; script-src 'self';");
    String script = html.replaceAll("(?s).*src=\"\\./(assets/[^\"]+\\.js)\".*", "$1");
    HttpResponse<byte[]> code = get(script);
    assertThat(code.statusCode()).isEqualTo(200);
    assertThat(code.headers().firstValue("Content-Type").orElseThrow())
        .startsWith("text/javascript");
  }

  @Test
  void theCaseIsDescribed() throws Exception {
    assertThat(new String(get("case.json").body()))
        .contains("\"no\":7", "\"model\":\"Read\"", "\"ended\":false");
  }

  @Test
  void aMotionIsSentOnceAndTheRecordingIsTheLast() throws Exception {
    assertThat(get("motion.glb").statusCode()).isEqualTo(204);
    server.show(
        known -> known == 4 ? Optional.empty() : Optional.of(new Motion(new byte[] {1, 2}, 4)));
    HttpResponse<byte[]> first = get("motion.glb");
    assertThat(first.body()).containsExactly(1, 2);
    String tag = first.headers().firstValue("ETag").orElseThrow();
    assertThat(get("motion.glb", "If-None-Match", tag).statusCode()).isEqualTo(304);
    assertThat(get("motion.glb").body()).as("another browser").containsExactly(1, 2);

    Path recording = Files.write(directory.resolve("7.glb"), new byte[] {3});
    server.end(recording);
    assertThat(get("motion.glb", "If-None-Match", tag).body()).containsExactly(3);
    assertThat(new String(get("case.json").body())).contains("\"ended\":true");
  }

  @Test
  void aSimulatorThatDoesNotAnswerIsNoMotion() throws Exception {
    server.show(
        known -> {
          throw new SimulatorException("it has ended");
        });
    assertThat(get("motion.glb").statusCode()).isEqualTo(503);
  }

  @Test
  void whoDoesNotKnowTheAddressGetsNothing() throws Exception {
    URI root = server.address().resolve("/");
    assertThat(get(root).statusCode()).isEqualTo(404);
    assertThat(get(root.resolve("/case.json")).statusCode()).isEqualTo(404);
    assertThat(get(root.resolve("/" + "0".repeat(32) + "/case.json")).statusCode()).isEqualTo(404);
    assertThat(get(URI.create(server.address() + "assets/%2e%2e/live.html")).statusCode())
        .isEqualTo(404);
    assertThat(get(URI.create(server.address() + "no.html")).statusCode()).isEqualTo(404);
    HttpRequest post =
        HttpRequest.newBuilder(server.address()).POST(HttpRequest.BodyPublishers.noBody()).build();
    assertThat(client.send(post, BodyHandlers.discarding()).statusCode()).isEqualTo(404);
    URI other =
        URI.create("http://localhost:" + server.address().getPort() + server.address().getPath());
    assertThat(get(other).statusCode()).as("another host name").isEqualTo(404);
  }
}
