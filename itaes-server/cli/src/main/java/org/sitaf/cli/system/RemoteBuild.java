package org.sitaf.cli.system;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.cli.terminal.Printable;
import org.sitaf.cli.terminal.ProgressLine;
import org.sitaf.core.activity.ros.RosImplementation;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.suite.CaseNumbers;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.document.TestResultXml;
import tools.jackson.databind.JsonNode;

/** Runs a build on a server and follows it until it ends. */
final class RemoteBuild {
  private static final int LONG_POLL_S = 20;

  /** Poll interval while the log is printed. */
  private static final int SHORT_POLL_S = 1;

  private final ServerClient server;
  private final ProgressLine progress;
  private @Nullable PrintStream log;
  private long logEnd;
  private String id = "";
  private @Nullable JsonNode requested;

  RemoteBuild(ServerClient server, ProgressLine progress) {
    this.server = server;
    this.progress = progress;
  }

  /** Also prints the build's log while it grows. */
  RemoteBuild followedBy(PrintStream out) {
    log = out;
    return this;
  }

  /** The id of the build. */
  String id() {
    return id;
  }

  /**
   * Builds a suite and waits for its result document.
   *
   * @param cases the cases that are executed; null for all
   * @throws InvalidInputException if the build has no result; contains the reason
   * @throws InterruptedException if this thread is interrupted; the build is cancelled
   */
  byte[] build(String suiteId) throws IOException, InterruptedException {
    request(suiteId, null, new RemoteRun.Source("", Map.of()), RosImplementation.INCLUDED);
    return await();
  }

  /**
   * Requests the build of a suite.
   *
   * @param cases null for all
   * @param ros what a ROS 2 node runs with
   */
  void request(
      String suiteId, @Nullable CaseNumbers cases, RemoteRun.Source source, RosImplementation ros)
      throws IOException, InterruptedException {
    Map<String, Object> request = new LinkedHashMap<>();
    request.put("suiteId", suiteId);
    if (cases != null) {
      request.put("cases", cases.merged().toString());
    }
    if (!source.commit().isEmpty()) {
      request.put("commit", source.commit());
    }
    if (!source.labels().isEmpty()) {
      request.put("buildLabels", source.labels());
    }
    if (ros != RosImplementation.INCLUDED) {
      request.put("ros", ros.name());
    }
    requested = server.post("builds", request);
    id = requested.path("id").asString();
  }

  /** Cancels the requested build; one that has ended stays as it is. */
  void cancel() throws IOException, InterruptedException {
    try {
      server.post("builds/" + id + "/cancel", Map.of());
    } catch (InvalidInputException e) {
      if (!hasEnded(server.get("builds/" + id))) {
        throw e;
      }
    }
  }

  /**
   * Waits for the result document of the requested build.
   *
   * @throws InvalidInputException if the build has no result; contains the reason
   * @throws InterruptedException if this thread is interrupted; the build is cancelled
   */
  byte[] await() throws IOException, InterruptedException {
    try {
      return await(Objects.requireNonNull(requested));
    } catch (InterruptedException e) {
      server.post("builds/" + id + "/cancel", Map.of());
      throw e;
    }
  }

  private byte[] await(JsonNode first) throws IOException, InterruptedException {
    JsonNode build = first;
    String path = "builds/" + id;
    String shown = "";
    while (!hasEnded(build)) {
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
                  + (log == null ? LONG_POLL_S : SHORT_POLL_S));
      copyLog(build, path);
    }
    if (!build.path("state").asString().equals("DONE")) {
      throw failure(build);
    }
    return server.document(path + "/result/document");
  }

  private void copyLog(JsonNode build, String path) throws IOException, InterruptedException {
    PrintStream out = log;
    if (out == null) {
      return;
    }
    byte[] fresh = server.log(path, logEnd);
    int whole = hasEnded(build) ? fresh.length : lastLineEnd(fresh);
    if (whole > 0) {
      progress.close();
      new String(fresh, 0, whole, StandardCharsets.UTF_8)
          .lines()
          .forEach(line -> out.println(Printable.line(line)));
      out.flush();
      logEnd += whole;
    }
  }

  /** The end of the last complete line; a later character may be incomplete. */
  private static int lastLineEnd(byte[] text) {
    int end = text.length;
    while (end > 0 && text[end - 1] != '\n') {
      end--;
    }
    return end;
  }

  /** Reads a result document. */
  static TestResult parse(byte[] document) {
    return TestResultXml.read(new ByteArrayInputStream(document), "result");
  }

  static boolean hasEnded(JsonNode build) {
    return switch (build.path("state").asString()) {
      case "DONE", "FAILED", "CANCELLED" -> true;
      default -> false;
    };
  }

  /** Why a build has no result. */
  static InvalidInputException failure(JsonNode build) {
    JsonNode failure = build.path("failure");
    List<Diagnostic> diagnostics = new ArrayList<>();
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
