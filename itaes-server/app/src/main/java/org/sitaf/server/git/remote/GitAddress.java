package org.sitaf.server.git.remote;

import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.git.GitSettings;
import org.sitaf.server.network.OutboundHosts;

/**
 * The address of a repository. Only the transports https, ssh and, where an administrator allows
 * them, file and http are known; anything else, such as {@code ext::}, is refused.
 *
 * @param text as the user wrote it
 * @param host empty for a file
 */
public record GitAddress(String text, Transport transport, String host, String path) {
  private static final int MAX_LENGTH = 2000;
  private static final Pattern HOST = Pattern.compile("[A-Za-z0-9]([A-Za-z0-9.-]*[A-Za-z0-9])?");
  private static final Pattern USER = Pattern.compile("[A-Za-z0-9_][A-Za-z0-9._-]{0,63}");
  private static final Pattern PATH = Pattern.compile("[A-Za-z0-9._~/@+%-]+");

  /** The short form of ssh addresses, {@code git@host:path}. */
  private static final Pattern SHORT = Pattern.compile("([^@:/]+)@([^@:/]+):([^:]+)");

  private static final String FORMS =
      "url: must be https://HOST/PATH, ssh://USER@HOST/PATH or USER@HOST:PATH";

  /** How a repository is reached. */
  public enum Transport {
    HTTPS,
    HTTP,
    SSH,
    FILE
  }

  /**
   * Parses and checks an address.
   *
   * @throws RequestException if it has another form or is not allowed
   */
  public static GitAddress parse(String text, GitSettings settings) {
    if (text.length() > MAX_LENGTH || text.chars().anyMatch(c -> c <= ' ' || c > '~')) {
      throw RequestException.malformed(
          FORMS + ", at most " + MAX_LENGTH + " printable ASCII characters without spaces.");
    }
    Matcher matcher = SHORT.matcher(text);
    GitAddress address =
        !text.contains("://") && matcher.matches()
            ? ssh(text, matcher.group(1), matcher.group(2), matcher.group(3))
            : url(text);
    address.requireAllowed(settings);
    return address;
  }

  private static GitAddress url(String text) {
    URI uri;
    try {
      uri = new URI(text);
    } catch (URISyntaxException e) {
      throw RequestException.malformed(FORMS + ": " + e.getReason() + ".");
    }
    String scheme = String.valueOf(uri.getScheme()).toLowerCase(Locale.ROOT);
    String path = uri.getPath();
    if (path == null || uri.getRawQuery() != null || uri.getRawFragment() != null) {
      throw RequestException.malformed(FORMS + ", without '?' and '#'.");
    }
    String host = uri.getHost();
    String user = uri.getUserInfo();
    switch (scheme) {
      case "https", "http" -> {
        if (user != null) {
          throw RequestException.malformed(
              "url: must not hold a user or a password; enter them as the credential.");
        }
        return new GitAddress(
            text,
            scheme.equals("https") ? Transport.HTTPS : Transport.HTTP,
            requireHost(host),
            requirePath(path));
      }
      case "ssh" -> {
        return ssh(text, user, host, path);
      }
      case "file" -> {
        if (host != null) {
          throw RequestException.malformed("url: a file URL must be file:///PATH.");
        }
        return new GitAddress(text, Transport.FILE, "", requirePath(path));
      }
      default ->
          throw RequestException.malformed(
              FORMS + "; other transports are not known to this server.");
    }
  }

  private static GitAddress ssh(
      String text, @Nullable String user, @Nullable String host, String path) {
    if (user != null && !USER.matcher(user).matches()) {
      throw RequestException.malformed(
          "url: the user must be letters, digits and . _ -, without a password.");
    }
    return new GitAddress(text, Transport.SSH, requireHost(host), requirePath(path));
  }

  private static String requireHost(@Nullable String host) {
    if (host == null || !HOST.matcher(host).matches()) {
      throw RequestException.malformed(FORMS + "; the host is missing or has other characters.");
    }
    return host.toLowerCase(Locale.ROOT);
  }

  private static String requirePath(String path) {
    boolean plain =
        PATH.matcher(path).matches()
            && !path.startsWith("-")
            && !path.startsWith("/-")
            && List.of(path.split("/")).stream().noneMatch(part -> part.equals(".."));
    if (!plain || path.equals("/")) {
      throw RequestException.malformed(
          FORMS + "; PATH must be letters, digits and / . _ ~ @ + % -, without '..'.");
    }
    return path;
  }

  private void requireAllowed(GitSettings settings) {
    switch (transport) {
      case FILE -> {
        Path folder = Path.of(path).normalize();
        if (settings.fileFolders().stream()
            .noneMatch(allowed -> folder.startsWith(allowed.toAbsolutePath().normalize()))) {
          throw RequestException.malformed(
              "url: repositories of the server's own disk are not allowed there; the administrator"
                  + " can add a folder to sitaf.git.file-folders.");
        }
      }
      case HTTP -> {
        if (!settings.plainHttpHosts().contains(host)) {
          throw RequestException.malformed(
              "url: http is not encrypted; use https. The administrator can allow a host in"
                  + " sitaf.git.plain-http-hosts.");
        }
        requireHostAllowed(settings);
      }
      case HTTPS, SSH -> requireHostAllowed(settings);
    }
  }

  private void requireHostAllowed(GitSettings settings) {
    if (!hosts(settings).isAllowed(host)) {
      throw RequestException.malformed(
          "url: repositories of "
              + host
              + " are not allowed; the administrator can add hosts to sitaf.git.allowed-hosts.");
    }
  }

  /** The hosts that the settings allow. */
  public static OutboundHosts hosts(GitSettings settings) {
    return new OutboundHosts("repositories", settings.allowedHosts(), settings.privateAddresses());
  }

  /** Whether it is reached by http or https. */
  public boolean isWeb() {
    return transport == Transport.HTTPS || transport == Transport.HTTP;
  }

  @Override
  public String toString() {
    return text;
  }
}
