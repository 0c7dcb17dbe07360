package org.sitaf.server.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.sitaf.server.support.ServerTest;

class HostFilterTest extends ServerTest {
  @Test
  void unknownHostNameIsRejected() throws IOException {
    assertThat(statusOf("localhost:" + httpPort(), "")).isEqualTo(200);
    assertThat(statusOf("127.0.0.1", "")).isEqualTo(200);
    assertThat(statusOf("[::1]:8080", "")).isEqualTo(200);
    assertThat(statusOf("evil.example", "")).isEqualTo(421);
    assertThat(statusOf("localhost.evil.example:" + httpPort(), "")).isEqualTo(421);
  }

  @Test
  void foreignOriginIsRejected() throws IOException {
    String host = "localhost:" + httpPort();
    assertThat(statusOf(host, "Origin: http://" + host + "\r\n")).isEqualTo(200);
    assertThat(statusOf(host, "Origin: http://evil.example\r\n")).isEqualTo(403);
    assertThat(statusOf(host, "Origin: http://localhost:1\r\n")).isEqualTo(403);
    assertThat(statusOf(host, "Origin: null\r\n")).isEqualTo(403);
  }

  @Test
  void responsesHaveSecurityHeaders() {
    var portal = api.get("/").headers();
    assertThat(portal.firstValue("Content-Security-Policy").orElse(""))
        .contains("script-src 'self';")
        .contains("default-src 'none'");
    var data = api.get("/api/v1/builds").headers();
    assertThat(data.firstValue("Content-Security-Policy").orElse("")).contains("sandbox");
    assertThat(data.firstValue("X-Content-Type-Options")).contains("nosniff");
  }

  @Test
  void documentationSaysThatItIsNotBuilt() {
    var page = api.get("/docs/index.html").expect(200);
    assertThat(page.text()).contains("not built yet", "./sitaf docs");
    assertThat(page.headers().firstValue("Content-Security-Policy").orElse(""))
        .contains("worker-src 'self'", "default-src 'none'");
    api.get("/docs/assets/nothing.js").expect(404);
    api.get("/docs/..%2f..%2fapplication.properties").expect(400);
  }

  @Test
  void portalRoutesReturnIndexPage() {
    String page = api.get("/").expect(200).text();
    assertThat(page).contains("<html");
    assertThat(api.get("/builds/abc").expect(200).text()).isEqualTo(page);
    assertThat(api.get("/activities").expect(200).text()).isEqualTo(page);
    Matcher script = Pattern.compile("src=\"(/assets/[^\"]+\\.js)\"").matcher(page);
    assertThat(script.find()).as(page).isTrue();
    var headers = api.get(script.group(1)).expect(200).headers();
    assertThat(headers.firstValue("Content-Type").orElse("")).startsWith("text/javascript");
    assertThat(headers.firstValue("Cache-Control").orElse("")).contains("immutable");
    assertThat(api.get("/").headers().firstValue("Cache-Control")).contains("no-cache");
    api.get("/nothing.js").expect(404);
    api.get("/assets/nothing.js").expect(404);
    api.get("/actuator/health").expect(200);
    api.get("/actuator/env").expect(403);
  }

  private int statusOf(String host, String header) throws IOException {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), httpPort())) {
      String request =
          "GET /api/v1/builds HTTP/1.1\r\nHost: "
              + host
              + "\r\n"
              + header
              + "Authorization: Bearer "
              + TOKEN
              + "\r\nConnection: close\r\n\r\n";
      socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
      String answer =
          new String(socket.getInputStream().readAllBytes(), StandardCharsets.ISO_8859_1);
      return Integer.parseInt(answer.substring(9, 12));
    }
  }
}
