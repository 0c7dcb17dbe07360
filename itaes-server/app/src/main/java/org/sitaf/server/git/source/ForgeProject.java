package org.sitaf.server.git.source;

import java.net.URI;
import java.net.URISyntaxException;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.git.GitSettings;
import org.sitaf.server.git.remote.GitAddress;

/**
 * A repository at a forge.
 *
 * @param api root of the forge's HTTP interface, without a slash at its end
 * @param path such as {@code owner/name}
 */
public record ForgeProject(Forge forge, String api, String path) {
  private static final int MAX_LENGTH = 400;
  private static final Pattern PATH = Pattern.compile("[A-Za-z0-9_.-]+(/[A-Za-z0-9_.-]+)+");

  /**
   * Finds the project of a repository.
   *
   * @param apiUrl null for the usual one of the repository's host
   * @param project null for the path of the repository
   * @throws RequestException if it is missing or not allowed
   */
  static ForgeProject of(
      Forge forge,
      GitAddress address,
      @Nullable String apiUrl,
      @Nullable String project,
      GitSettings settings) {
    String path =
        project == null || project.isBlank()
            ? address.path().replaceAll("^/+|/+$", "").replaceFirst("\\.git$", "")
            : project.strip();
    if (path.length() > MAX_LENGTH
        || !PATH.matcher(path).matches()
        || ("/" + path + "/").contains("/../")) {
      throw RequestException.malformed(
          "project: must be the repository's path at the forge, such as owner/name.");
    }
    return new ForgeProject(forge, api(forge, address, apiUrl, settings), path);
  }

  private static String api(
      Forge forge, GitAddress address, @Nullable String apiUrl, GitSettings settings) {
    String text =
        apiUrl == null || apiUrl.isBlank() ? usual(forge, address.host()) : apiUrl.strip();
    URI api;
    try {
      api = new URI(text);
    } catch (URISyntaxException e) {
      throw RequestException.malformed("apiUrl: " + e.getReason() + ".");
    }
    String host = api.getHost();
    boolean plain =
        "http".equals(api.getScheme()) && host != null && settings.plainHttpHosts().contains(host);
    if (host == null
        || api.getUserInfo() != null
        || api.getRawQuery() != null
        || api.getRawFragment() != null
        || !("https".equals(api.getScheme()) || plain)
        || !GitAddress.hosts(settings).isAllowed(host)) {
      throw RequestException.malformed(
          "apiUrl: must be the https URL of the forge's interface, such as"
              + " https://git.example.org/api/v4, on a host that sitaf.git.allowed-hosts allows.");
    }
    return text.replaceAll("/+$", "");
  }

  private static String usual(Forge forge, String host) {
    if (host.isEmpty()) {
      throw RequestException.malformed("apiUrl: must be given, since the repository has no host.");
    }
    return switch (forge) {
      case GITHUB ->
          host.equals("github.com") ? "https://api.github.com" : "https://" + host + "/api/v3";
      case GITLAB -> "https://" + host + "/api/v4";
      case GITEA -> "https://" + host + "/api/v1";
      case NONE -> throw new IllegalArgumentException("no forge");
    };
  }
}
