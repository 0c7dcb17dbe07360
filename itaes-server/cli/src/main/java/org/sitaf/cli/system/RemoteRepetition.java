package org.sitaf.cli.system;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.sitaf.cli.terminal.ProgressLine;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.flaky.FlakyCase;
import org.sitaf.core.flaky.FlakyCause;
import org.sitaf.core.verdict.Verdict;
import tools.jackson.databind.JsonNode;

/** Lets a server's agents execute the cases of a build again, and reads what differs. */
final class RemoteRepetition {
  private static final int POLL_S = 20;

  private final ServerClient server;
  private final ProgressLine progress;

  RemoteRepetition(ServerClient server, ProgressLine progress) {
    this.server = server;
    this.progress = progress;
  }

  /**
   * Executes the cases and waits until all runs have ended.
   *
   * @param runs number of runs beyond the build
   * @return the cases that differ; at most 1,000
   * @throws InvalidInputException if they could not be executed; contains the reason
   * @throws InterruptedException if this thread is interrupted; the repetition is cancelled
   */
  List<FlakyCase> run(String buildId, int runs) throws IOException, InterruptedException {
    String path = "builds/" + buildId + "/repetition";
    JsonNode repetition = server.post(path, Map.of("runs", runs));
    String id = repetition.path("id").asString();
    try {
      progress.step("Further runs");
      JsonNode build = server.get("builds/" + id);
      while (!RemoteBuild.hasEnded(build)) {
        progress.detail(build.path("casesDone").asInt(0) + "/" + build.path("casesTotal").asInt(0));
        build =
            server.get(
                "builds/"
                    + id
                    + "?waitForChangeSince="
                    + build.path("version").asLong()
                    + "&timeoutS="
                    + POLL_S);
      }
      if (!build.path("state").asString().equals("DONE")) {
        throw RemoteBuild.failure(build);
      }
    } catch (InterruptedException e) {
      server.post("builds/" + id + "/cancel", Map.of());
      throw e;
    }
    List<FlakyCase> flaky = new ArrayList<>();
    for (JsonNode each : server.get(path).path("repetition").path("cases")) {
      List<Verdict> verdicts = new ArrayList<>();
      each.path("verdicts").forEach(v -> verdicts.add(Verdict.valueOf(v.asString())));
      flaky.add(
          new FlakyCase(
              each.path("no").asInt(),
              FlakyCause.valueOf(each.path("cause").asString()),
              verdicts,
              each.path("reason").asString("")));
    }
    return flaky;
  }
}
