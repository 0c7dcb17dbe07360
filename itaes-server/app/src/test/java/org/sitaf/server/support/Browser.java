package org.sitaf.server.support;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.CookieManager;
import java.net.HttpCookie;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.util.Optional;

/** A browser that stores cookies and sends the CSRF token like the portal. */
public final class Browser {
  private final CookieManager cookies = new CookieManager();
  private final HttpClient client =
      HttpClient.newBuilder().version(HttpClient.Version.HTTP_1_1).cookieHandler(cookies).build();
  private final String root;

  public Browser(int port) {
    root = "http://localhost:" + port;
  }

  /** Opens the portal and signs in. */
  public Api.Answer signIn(String name, String password) {
    get("/api/v1/session");
    return send(
        "POST",
        "/api/v1/session",
        "{\"name\":\"%s\",\"password\":\"%s\"}".formatted(name, password));
  }

  public Api.Answer get(String path) {
    return send(HttpRequest.newBuilder(URI.create(root + path)).GET());
  }

  /** Sends a request like the portal, with the CSRF token. */
  public Api.Answer send(String method, String path, String json) {
    HttpRequest.Builder request = change(method, path, json);
    cookie("XSRF-TOKEN").ifPresent(token -> request.header("X-XSRF-TOKEN", token));
    return send(request);
  }

  /** Sends a request like a page of another site, without the CSRF token. */
  public Api.Answer sendForged(String method, String path, String json) {
    return send(change(method, path, json));
  }

  public Optional<String> cookie(String name) {
    return cookies.getCookieStore().getCookies().stream()
        .filter(c -> c.getName().equals(name))
        .map(HttpCookie::getValue)
        .findFirst();
  }

  private HttpRequest.Builder change(String method, String path, String json) {
    return HttpRequest.newBuilder(URI.create(root + path))
        .header("Content-Type", "application/json")
        .method(method, BodyPublishers.ofString(json));
  }

  private Api.Answer send(HttpRequest.Builder request) {
    try {
      HttpResponse<byte[]> answer = client.send(request.build(), BodyHandlers.ofByteArray());
      return new Api.Answer(answer.statusCode(), answer.body(), answer.headers());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(e);
    }
  }
}
