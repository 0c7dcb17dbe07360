package org.sitaf.agent.toolchain.python.environment;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * The pip configuration of the agent's user. Only processes that download packages get it; they
 * execute no code of a package.
 *
 * @param environment variables for pip and for network access
 * @param readable files and folders that they refer to
 * @param configuration the user's configuration file, which may be private; null for none
 */
public record PipSettings(
    Map<String, String> environment, List<Path> readable, @Nullable Path configuration) {
  private static final List<String> VARIABLES =
      List.of(
          "PIP_INDEX_URL",
          "PIP_EXTRA_INDEX_URL",
          "PIP_TRUSTED_HOST",
          "PIP_PROXY",
          "PIP_CERT",
          "PIP_CLIENT_CERT",
          "PIP_DEFAULT_TIMEOUT",
          "PIP_TIMEOUT",
          "PIP_RETRIES",
          "PIP_FIND_LINKS",
          "PIP_NO_INDEX",
          "HTTP_PROXY",
          "HTTPS_PROXY",
          "NO_PROXY",
          "http_proxy",
          "https_proxy",
          "no_proxy",
          "SSL_CERT_FILE",
          "REQUESTS_CA_BUNDLE");

  public PipSettings {
    environment = Map.copyOf(environment);
    readable = List.copyOf(readable);
  }

  /** The settings of the agent's user. */
  public static PipSettings ofThisMachine() {
    return of(System.getenv(), Path.of(System.getProperty("user.home")));
  }

  static PipSettings of(Map<String, String> variables, Path home) {
    Map<String, String> environment = new TreeMap<>();
    for (String name : VARIABLES) {
      String value = variables.get(name);
      if (value != null) {
        environment.put(name, value);
      }
    }
    Path configuration =
        Stream.of(
                variables.getOrDefault("PIP_CONFIG_FILE", ""),
                home.resolve(".config/pip/pip.conf").toString(),
                home.resolve(".pip/pip.conf").toString())
            .filter(file -> !file.isEmpty())
            .map(Path::of)
            .filter(Files::isRegularFile)
            .findFirst()
            .orElse(null);
    List<Path> readable = new ArrayList<>();
    for (String value : environment.values()) {
      for (String word : value.split("\\s+")) {
        Path path = word.startsWith("/") ? Path.of(word) : null;
        if (path != null && Files.exists(path) && path.getNameCount() > 1) {
          readable.add(path.normalize());
        }
      }
    }
    return new PipSettings(environment, readable, configuration);
  }
}
