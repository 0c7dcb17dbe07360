package org.sitaf.server.git.forge;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.URI;
import java.net.URLEncoder;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import org.apache.hc.client5.http.DnsResolver;
import org.apache.hc.client5.http.classic.methods.HttpGet;
import org.apache.hc.client5.http.classic.methods.HttpPost;
import org.apache.hc.client5.http.classic.methods.HttpUriRequestBase;
import org.apache.hc.client5.http.config.ConnectionConfig;
import org.apache.hc.client5.http.config.RequestConfig;
import org.apache.hc.client5.http.impl.classic.CloseableHttpClient;
import org.apache.hc.client5.http.impl.classic.HttpClients;
import org.apache.hc.client5.http.impl.io.PoolingHttpClientConnectionManagerBuilder;
import org.apache.hc.core5.http.ClassicHttpResponse;
import org.apache.hc.core5.http.ContentType;
import org.apache.hc.core5.http.io.entity.StringEntity;
import org.apache.hc.core5.util.Timeout;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.git.GitSettings;
import org.sitaf.server.git.remote.GitAddress;
import org.sitaf.server.git.source.Forge;
import org.sitaf.server.git.source.ForgeProject;
import org.sitaf.server.network.OutboundHosts;
import org.springframework.stereotype.Component;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Calls the HTTP interfaces of GitHub, GitLab and Gitea. Redirects are not followed. */
@Component
class ForgeClient implements AutoCloseable {
  private static final Timeout TIMEOUT = Timeout.ofSeconds(10);
  private static final int MAX_RESPONSE = 4 << 20;
  private static final int MAX_SHOWN = 200;
  private static final int MAX_DESCRIPTION = 140;

  private final CloseableHttpClient client;
  private final JsonMapper json;

  ForgeClient(GitSettings settings, JsonMapper json) {
    this.json = json;
    this.client =
        HttpClients.custom()
            .setConnectionManager(
                PoolingHttpClientConnectionManagerBuilder.create()
                    .setDnsResolver(new Resolver(GitAddress.hosts(settings)))
                    .setDefaultConnectionConfig(
                        ConnectionConfig.custom()
                            .setConnectTimeout(TIMEOUT)
                            .setSocketTimeout(TIMEOUT)
                            .build())
                    .build())
            .setDefaultRequestConfig(
                RequestConfig.custom()
                    .setResponseTimeout(TIMEOUT)
                    .setConnectionRequestTimeout(TIMEOUT)
                    .build())
            .disableRedirectHandling()
            .disableAutomaticRetries()
            .disableCookieManagement()
            .disableAuthCaching()
            .setUserAgent("sitaf-git")
            .build();
  }

  private record Resolver(OutboundHosts hosts) implements DnsResolver {
    @Override
    public InetAddress[] resolve(String host) throws UnknownHostException {
      return hosts.resolve(host);
    }

    @Override
    public String resolveCanonicalHostname(String host) {
      return host;
    }
  }

  /** The forge has refused a request; the message says how. */
  static final class ForgeException extends IOException {
    private static final long serialVersionUID = 1L;

    ForgeException(String message) {
      super(message);
    }
  }

  /** Sends a status. */
  void send(ForgeProject project, String token, CommitStatus status) throws IOException {
    Map<String, String> body = new LinkedHashMap<>();
    boolean gitLab = project.forge() == Forge.GITLAB;
    body.put("state", gitLab ? status.result().gitLabText() : status.result().text());
    body.put("target_url", status.targetUrl());
    body.put("description", shortened(status.description(), MAX_DESCRIPTION));
    body.put(gitLab ? "name" : "context", status.context());
    HttpPost request = new HttpPost(URI.create(root(project) + "/statuses/" + status.sha()));
    request.setEntity(
        new StringEntity(json.writeValueAsString(body), ContentType.APPLICATION_JSON));
    JsonNode unused = execute(request, project, token);
  }

  /** Whether the forge has a status already, such as after an answer that was lost. */
  boolean has(ForgeProject project, String token, CommitStatus status) throws IOException {
    String path =
        project.forge() == Forge.GITLAB
            ? "/repository/commits/"
                + status.sha()
                + "/statuses?all=true&per_page=100&name="
                + URLEncoder.encode(status.context(), StandardCharsets.UTF_8)
            : "/commits/" + status.sha() + "/statuses?per_page=100&limit=50";
    JsonNode shown = execute(new HttpGet(URI.create(root(project) + path)), project, token);
    for (JsonNode entry : shown) {
      // Gitea calls the state "status".
      String result = text(entry, entry.has("state") ? "state" : "status");
      if (project.forge() == Forge.GITLAB) {
        result = text(entry, "status");
      }
      if (status.isShown(
          result, text(entry, project.forge() == Forge.GITLAB ? "name" : "context"))) {
        return true;
      }
    }
    return false;
  }

  private static @Nullable String text(JsonNode entry, String name) {
    JsonNode value = entry.get(name);
    return value == null || !value.isString() ? null : value.asString();
  }

  private static String root(ForgeProject project) {
    return project.forge() == Forge.GITLAB
        ? project.api() + "/projects/" + URLEncoder.encode(project.path(), StandardCharsets.UTF_8)
        : project.api() + "/repos/" + project.path();
  }

  private JsonNode execute(HttpUriRequestBase request, ForgeProject project, String token)
      throws IOException {
    switch (project.forge()) {
      case GITLAB -> request.setHeader("PRIVATE-TOKEN", token);
      case GITEA -> request.setHeader("Authorization", "token " + token);
      case GITHUB, NONE -> request.setHeader("Authorization", "Bearer " + token);
    }
    request.setHeader("Accept", "application/json");
    return client.execute(
        request,
        response -> {
          String body = body(response, request);
          if (response.getCode() / 100 != 2) {
            throw new ForgeException(
                "HTTP " + response.getCode() + ": " + shortened(body, MAX_SHOWN));
          }
          return body.isBlank() ? json.createArrayNode() : json.readTree(body);
        });
  }

  private static String body(ClassicHttpResponse response, HttpUriRequestBase request)
      throws IOException {
    if (response.getEntity() == null) {
      return "";
    }
    try (InputStream in = response.getEntity().getContent()) {
      byte[] bytes = in.readNBytes(MAX_RESPONSE);
      if (bytes.length == MAX_RESPONSE) {
        request.abort();
        throw new ForgeException("the answer is larger than " + (MAX_RESPONSE >> 20) + " MiB");
      }
      return new String(bytes, StandardCharsets.UTF_8);
    }
  }

  private static String shortened(String text, int length) {
    String plain = text.replaceAll("[\\p{Cc}\\p{Cf}]+", " ").strip();
    return plain.length() <= length ? plain : plain.substring(0, length - 1) + "…";
  }

  @Override
  public void close() throws IOException {
    client.close();
  }
}
