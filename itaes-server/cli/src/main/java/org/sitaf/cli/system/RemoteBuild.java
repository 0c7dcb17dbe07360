package org.sitaf.cli.system;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.List;
import java.util.Locale;
import org.sitaf.cli.ProgressLine;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.TestResultXml;
import tools.jackson.databind.JsonNode;

/** A build on a server, followed to its end. */
final class RemoteBuild {
  private static final int LONG_POLL_S = 20;

  private final ServerClient server;
  private final ProgressLine progress;

  RemoteBuild(ServerClient server, ProgressLine progress) {
    this.server = server;
    this.progress = progress;
  }

  /**
   * Builds a suite now and waits for its result document.
   *
   * @throws InvalidInputException when the build brought no result; holds the reason
   */
  byte[] build(String suiteId) throws IOException, InterruptedException {
    JsonNode build = server.post("builds", java.util.Map.of("suiteId", suiteId));
    String path = "builds/" + build.path("id").asString();
    String shown = "";
    while (!isOver(build)) {
      String state = build.path("state").asString();
      if (!state.equals(shown)) {
        progress.step("Build: " + state.toLowerCase(Locale.ROOT));
        shown = state;
      }
      if (state.equals("RUNNING")) {
        progress.detail(build.path("casesDone").asInt(0) + "/" + build.path("casesTotal").asInt(0));
      }
      build =
          server.get(
              path
                  + "?waitForChangeSince="
                  + build.path("version").asLong()
                  + "&timeoutS="
                  + LONG_POLL_S);
    }
    if (!build.path("state").asString().equals("DONE")) {
      throw failure(build);
    }
    return server.document(path + "/result/document");
  }

  /** Reads a result document. */
  static TestResult parse(byte[] document) {
    return TestResultXml.read(new ByteArrayInputStream(document), "result");
  }

  private static boolean isOver(JsonNode build) {
    return switch (build.path("state").asString()) {
      case "DONE", "FAILED", "CANCELLED" -> true;
      default -> false;
    };
  }

  private static InvalidInputException failure(JsonNode build) {
    JsonNode failure = build.path("failure");
    List<Diagnostic> diagnostics = new java.util.ArrayList<>();
    for (JsonNode d : failure.path("diagnostics")) {
      diagnostics.add(
          Diagnostic.error(
              d.path("file").asString(""),
              d.path("line").asInt(0),
              "",
              d.path("message").asString("")));
    }
    diagnostics.add(
        Diagnostic.error(
            "build " + build.path("id").asString(),
            0,
            "",
            build.path("state").asString().toLowerCase(Locale.ROOT)
                + ": "
                + failure.path("message").asString("no reason was given")));
    return new InvalidInputException(diagnostics);
  }
}
