package org.sitaf.cli.system;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.ActivityArchive;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;
import tools.jackson.databind.JsonNode;

/** An activity on a server that has the files of this machine. */
final class RemoteActivity {
  private static final String ZIP = "application/zip";
  private static final int MAX_ATTEMPTS = 5;

  private final ServerClient server;
  private final FileTree files;
  private final String id;
  private long version;

  private RemoteActivity(ServerClient server, FileTree files, JsonNode stored) {
    this.server = server;
    this.files = files;
    this.id = stored.path("id").asString();
    this.version = stored.path("version").asLong();
  }

  /**
   * Updates an activity, or creates one if there is none of this name.
   *
   * @param id of the activity; null for the newest one of the name
   * @throws InvalidInputException if the server rejects it; contains the server's diagnostics
   */
  static RemoteActivity upload(
      ServerClient server, @Nullable String id, String name, FileTree files)
      throws IOException, InterruptedException {
    JsonNode stored =
        id != null
            ? server.get("activities/" + encoded(id))
            : server.get("activities?size=1&name=" + encoded(name)).path("items").path(0);
    if (stored.isMissingNode()) {
      return new RemoteActivity(server, files, server.post("activities", ZIP, zip(files)));
    }
    RemoteActivity activity = new RemoteActivity(server, files, stored);
    activity.update(stored);
    return activity;
  }

  String id() {
    return id;
  }

  /**
   * Whether the activity still has these files, or has them again. What was made of it in the
   * meantime may not be made of them.
   */
  boolean isUnchanged() throws IOException, InterruptedException {
    JsonNode stored = server.get(path());
    if (stored.path("version").asLong() == version) {
      return true;
    }
    update(stored);
    return false;
  }

  private void update(JsonNode known) throws IOException, InterruptedException {
    JsonNode stored = known;
    for (int attempt = 1; attempt <= MAX_ATTEMPTS; attempt++) {
      version = stored.path("version").asLong();
      if (hasFiles(stored)) {
        return;
      }
      JsonNode updated = server.put(path() + "/content", ZIP, zip(files), version);
      if (updated != null) {
        version = updated.path("version").asLong();
        return;
      }
      stored = server.get(path());
    }
    throw InvalidInputException.of(
        "activity " + id,
        "others update it at the same time; run again, or name another one with --activity");
  }

  private String path() {
    return "activities/" + encoded(id);
  }

  private boolean hasFiles(JsonNode stored) {
    Map<String, String> there = new HashMap<>();
    stored
        .path("files")
        .forEach(f -> there.put(f.path("path").asString(""), f.path("sha256").asString("")));
    Map<String, String> here = new HashMap<>();
    files.paths().forEach(p -> here.put(p, sha256(files.content(p).orElseThrow())));
    return here.equals(there);
  }

  private static String sha256(byte[] content) {
    try {
      return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(content));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java has SHA-256", e);
    }
  }

  private static byte[] zip(FileTree files) throws IOException {
    ByteArrayOutputStream zip = new ByteArrayOutputStream();
    ActivityArchive.write(files, zip);
    return zip.toByteArray();
  }

  private static String encoded(String text) {
    return URLEncoder.encode(text, StandardCharsets.UTF_8).replace("+", "%20");
  }
}
