package org.sitaf.cli.system;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.net.URI;
import java.util.Map;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.cli.terminal.ProgressLine;
import org.sitaf.core.activity.ActivityArchive;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.verdict.TestResult;
import tools.jackson.databind.JsonNode;

/** Tests an activity on a server's agents. The activity stays on the server with its results. */
public final class RemoteRun {
  private static final String TOKEN = "SITAF_TOKEN";
  private static final Pattern LOOPBACK = Pattern.compile("localhost|127(\\.\\d+){3}|\\[::1]");

  private final URI address;
  private final ServerClient server;
  private final String activityId;
  private final PrintStream err;

  private RemoteRun(URI address, ServerClient server, String activityId, PrintStream err) {
    this.address = address;
    this.server = server;
    this.activityId = activityId;
    this.err = err;
  }

  /**
   * Uploads an activity.
   *
   * @param token API token of the server; null for none
   * @param plaintext whether the token may be sent without TLS to other machines
   * @param err for progress and build logs
   * @throws InvalidInputException if the server rejects the activity; contains the server's
   *     diagnostics
   */
  public static RemoteRun upload(
      URI address, @Nullable String token, boolean plaintext, FileTree files, PrintStream err)
      throws IOException, InterruptedException {
    verify(address, plaintext);
    if (token == null || token.isBlank()) {
      throw InvalidInputException.of(
          TOKEN,
          "is not set; create a token in the portal of " + address + " and set the variable to it");
    }
    ServerClient server = new ServerClient(address, token.strip());
    ByteArrayOutputStream zip = new ByteArrayOutputStream();
    ActivityArchive.write(files, zip);
    JsonNode activity = server.post("activities", "application/zip", zip.toByteArray());
    return new RemoteRun(address, server, activity.path("id").asString(), err);
  }

  private static void verify(URI address, boolean plaintext) {
    String host = address.getHost();
    boolean http = "http".equals(address.getScheme());
    if (host == null || !http && !"https".equals(address.getScheme())) {
      throw InvalidInputException.of(
          "--server " + address, "expected an address such as https://sitaf.example");
    }
    if (http && !plaintext && !LOOPBACK.matcher(host).matches()) {
      throw InvalidInputException.of(
          "--server " + address,
          "would send the token without TLS; use https, or --plaintext in a trusted network");
    }
  }

  /**
   * Tests one model; cancels its build if this thread is interrupted.
   *
   * @throws InvalidInputException if the build has no result; contains the reason
   */
  public TestResult test(String model, long seed) throws IOException, InterruptedException {
    try (ProgressLine progress = new ProgressLine(err)) {
      progress.step(model + ": generating test cases");
      JsonNode suite =
          server.post(
              "activities/" + activityId + "/models/" + model + "/suites", Map.of("seed", seed));
      RemoteBuild build = new RemoteBuild(server, progress).followedBy(err);
      byte[] document = build.build(suite.path("id").asString());
      progress.step(model + ": " + address.resolve("/builds/" + build.id()));
      return RemoteBuild.parse(document);
    }
  }
}
