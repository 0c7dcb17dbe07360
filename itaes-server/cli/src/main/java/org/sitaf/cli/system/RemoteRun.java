package org.sitaf.cli.system;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.net.URI;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.cli.terminal.ProgressLine;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.activity.ros.RosImplementation;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.flaky.FlakyCase;
import org.sitaf.core.suite.CaseNumbers;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.suite.document.TestSuiteXml;
import org.sitaf.core.verdict.TestResult;
import tools.jackson.databind.JsonNode;

/** Tests an activity on a server's agents. The activity stays on the server with its results. */
public final class RemoteRun {
  private static final String TOKEN = "SITAF_TOKEN";
  private static final Pattern LOOPBACK = Pattern.compile("localhost|127(\\.\\d+){3}|\\[::1]");

  /** Others may change the activity while its suite is generated and its build is requested. */
  private static final int MAX_ATTEMPTS = 5;

  private final URI address;
  private final ServerClient server;
  private final RemoteActivity activity;
  private final Source source;
  private final RosImplementation ros;
  private final PrintStream err;

  private RemoteRun(
      URI address,
      ServerClient server,
      RemoteActivity activity,
      Source source,
      RosImplementation ros,
      PrintStream err) {
    this.address = address;
    this.server = server;
    this.activity = activity;
    this.source = source;
    this.ros = ros;
    this.err = err;
  }

  /**
   * Where an activity is tested.
   *
   * @param token API token of the server; null for none
   * @param plaintext whether the token may be sent without TLS to other machines
   * @param activity id of the activity that is updated; null for the newest one of the same name
   */
  public record Target(
      URI address, @Nullable String token, boolean plaintext, @Nullable String activity) {}

  /**
   * What is stored with the builds.
   *
   * @param commit empty if it is not known
   * @param labels values by key
   */
  public record Source(String commit, Map<String, String> labels) {}

  /**
   * Uploads an activity.
   *
   * @param name of the activity
   * @param ros what ROS 2 nodes run with
   * @param err for progress and build logs
   * @throws InvalidInputException if the server rejects the activity; contains the server's
   *     diagnostics
   */
  public static RemoteRun upload(
      Target target,
      String name,
      FileTree files,
      Source source,
      RosImplementation ros,
      PrintStream err)
      throws IOException, InterruptedException {
    URI address = target.address();
    verify(address, target.plaintext());
    String token = target.token();
    if (token == null || token.isBlank()) {
      throw InvalidInputException.of(
          TOKEN,
          "is not set; create a token in the portal of " + address + " and set the variable to it");
    }
    ServerClient server = new ServerClient(address, token.strip());
    return new RemoteRun(
        address,
        server,
        RemoteActivity.upload(server, target.activity(), name, files),
        source,
        ros,
        err);
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
   * The result of a build.
   *
   * @param whole whether the whole suite was executed
   * @param flaky the cases that differ between the runs; at most 1,000
   */
  public record Ended(TestResult result, boolean whole, List<FlakyCase> flaky) {
    public Ended {
      flaky = List.copyOf(flaky);
    }
  }

  /**
   * Tests one model; cancels its build if this thread is interrupted.
   *
   * @param selection selects the cases of the server's suite that are executed
   * @param runs how often they are executed
   * @return empty if no case was selected
   * @throws InvalidInputException if the build has no result; contains the reason
   */
  public Optional<Ended> test(String model, long seed, UnaryOperator<TestSuite> selection, int runs)
      throws IOException, InterruptedException {
    try (ProgressLine progress = new ProgressLine(err)) {
      RemoteBuild build = new RemoteBuild(server, progress).followedBy(err);
      Optional<Boolean> whole = request(build, model, seed, selection, progress);
      if (whole.isEmpty()) {
        return Optional.empty();
      }
      byte[] document = build.await();
      progress.step(model + ": " + address.resolve("/builds/" + build.id()));
      List<FlakyCase> flaky =
          runs == 1 ? List.of() : new RemoteRepetition(server, progress).run(build.id(), runs - 1);
      return Optional.of(new Ended(RemoteBuild.parse(document), whole.get(), flaky));
    }
  }

  /**
   * Requests a build of the files of this machine, whatever others do with the activity.
   *
   * @return whether it has all cases; empty if no case was selected
   */
  private Optional<Boolean> request(
      RemoteBuild build,
      String model,
      long seed,
      UnaryOperator<TestSuite> selection,
      ProgressLine progress)
      throws IOException, InterruptedException {
    for (int attempt = 1; attempt <= MAX_ATTEMPTS; attempt++) {
      progress.step(model + ": generating test cases");
      JsonNode suite =
          server.post(
              "activities/" + activity.id() + "/models/" + model + "/suites", Map.of("seed", seed));
      String suiteId = suite.path("id").asString();
      TestSuite all =
          TestSuiteXml.read(
              new ByteArrayInputStream(server.document("suites/" + suiteId + "/document")), model);
      TestSuite selected = selection.apply(all);
      if (selected.cases().isEmpty() && !all.cases().isEmpty()) {
        return Optional.empty();
      }
      boolean whole = selected.cases().size() == all.cases().size();
      build.request(suiteId, whole ? null : CaseNumbers.of(numbers(selected)), source, ros);
      try {
        if (activity.isUnchanged()) {
          return Optional.of(whole);
        }
      } catch (InterruptedException e) {
        build.cancel();
        throw e;
      }
      build.cancel();
    }
    throw InvalidInputException.of(
        "activity " + activity.id(),
        "others update it at the same time; run again, or name another one with --activity");
  }

  private static Set<Integer> numbers(TestSuite suite) {
    return suite.cases().stream().map(TestCase::no).collect(Collectors.toSet());
  }
}
