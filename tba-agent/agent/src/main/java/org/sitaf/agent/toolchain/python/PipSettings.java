package org.sitaf.agent.toolchain.python;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * How this machine reaches its package index: as pip is configured for the agent's user. Only what
 * fetches packages gets it, and no code of a package runs there.
 *
 * @param environment variables of pip and of what it reaches the network with
 * @param readable files and folders that they name
 */
record PipSettings(Map<String, String> environment, List<Path> readable) {
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
          "PIP_CONFIG_FILE",
          "HTTP_PROXY",
          "HTTPS_PROXY",
          "NO_PROXY",
          "http_proxy",
          "https_proxy",
          "no_proxy",
          "SSL_CERT_FILE",
          "REQUESTS_CA_BUNDLE");

  PipSettings {
    environment = Map.copyOf(environment);
    readable = List.copyOf(readable);
  }

  /** Those of the agent's user. */
  static PipSettings ofThisMachine() {
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
    for (String file : List.of(".config/pip/pip.conf", ".pip/pip.conf")) {
      Path own = home.resolve(file);
      if (Files.isRegularFile(own)) {
        environment.putIfAbsent("PIP_CONFIG_FILE", own.toString());
      }
    }
    List<Path> readable = new ArrayList<>();
    for (String value : environment.values()) {
      for (String word : value.split("\\s+")) {
        Path path = word.startsWith("/") ? Path.of(word) : null;
        if (path != null && Files.exists(path) && path.getNameCount() > 1) {
          readable.add(path.normalize());
        }
      }
    }
    return new PipSettings(environment, readable);
  }
}
