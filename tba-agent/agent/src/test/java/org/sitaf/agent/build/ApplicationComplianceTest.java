package org.sitaf.agent.build;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.sitaf.agent.build.BuildOutcome.Completed;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.agent.testing.Recording;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.StubCalls;
import org.sitaf.core.verdict.Verdict;

/** The applications of tests/compliance give the same results in every language. */
@Tag("slow")
@Timeout(300)
class ApplicationComplianceTest {
  private static final Path COMPLIANCE = Path.of("../../tests/compliance");
  private static final Map<Language, String> CLASSES =
      Map.of(
          Language.JAVA,
          "robot.Probe",
          Language.CPP,
          "robot::Probe",
          Language.PYTHON,
          "probe.Probe");

  @TempDir private Path directory;
  private final Recording recording = new Recording();

  private static Stream<Arguments> applications() {
    return Stream.of("application", "names")
        .flatMap(
            name -> Arrays.stream(Language.values()).map(language -> arguments(name, language)));
  }

  private static List<List<String>> rows(Path application) throws IOException {
    return Files.readAllLines(application.resolve("expected.tsv")).stream()
        .filter(line -> !line.startsWith("#"))
        .map(line -> List.of(line.split("\t", -1)))
        .toList();
  }

  private static TestApplication application(Path application, Language language, String timing)
      throws IOException {
    String name = language.name().toLowerCase(Locale.ROOT);
    Map<String, byte[]> files = new HashMap<>();
    try (Stream<Path> documents = Files.list(application)) {
      for (Path file : documents.filter(Files::isRegularFile).toList()) {
        files.put(file.getFileName().toString(), Files.readAllBytes(file));
      }
    }
    String profile =
        Files.readString(application.resolve("activity.yaml"))
                .replace("LANGUAGE", name)
                .replace("CLASS", CLASSES.get(language))
            + timing;
    files.put("activity.yaml", profile.getBytes(StandardCharsets.UTF_8));
    Path sources = application.resolve(name);
    try (Stream<Path> found = Files.walk(sources)) {
      for (Path source : found.filter(Files::isRegularFile).toList()) {
        files.put("component/" + sources.relativize(source), Files.readAllBytes(source));
      }
    }
    Activity activity = Activity.read(FileTree.of(files));
    TestModel model = activity.models().get(0);
    List<TestCase> cases = new ArrayList<>();
    for (List<String> row : rows(application)) {
      cases.add(
          new TestCase(
              cases.size() + 1,
              true,
              row.subList(0, 2),
              List.of(new ExpectedValue("", row.get(2)))));
    }
    return InterfaceTestApplicationGenerator.generate(
        activity,
        model,
        TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite().withCases(cases));
  }

  @ParameterizedTest
  @MethodSource("applications")
  void resultsAreThoseOfTheTable(String application, Language language) throws Exception {
    assertThat(resultsOf(application, language, "")).allMatch(result -> result.repeated() == null);
  }

  @ParameterizedTest
  @EnumSource(Language.class)
  void repeatedCallsDoNotChangeResults(Language language) throws Exception {
    List<CaseResult> results =
        resultsOf("application", language, "timing: {warm_up: 1, repeat: 7}\n");
    for (CaseResult result : results) {
      if (result.verdict() == Verdict.DONT) {
        assertThat(result.repeated()).isNull();
      } else {
        assertThat(result.repeated().calls()).as("case %d", result.no()).isEqualTo(7);
        assertThat(result.repeated().warmUp()).isEqualTo(1);
        assertThat(result.repeated().differs()).isEmpty();
      }
    }
    assertThat(results.get(0).time().cold()).isTrue();
    assertThat(results.subList(1, results.size()))
        .noneMatch(result -> result.time() != null && result.time().cold());
  }

  private List<CaseResult> resultsOf(String name, Language language, String timing)
      throws Exception {
    Path application = COMPLIANCE.resolve(name);
    assumeTrue(
        EchoActivity.toolchains().of(language).isPresent(),
        () -> "skipped: " + EchoActivity.toolchains().missingMessage(language));
    BuildOutcome outcome =
        new BuildRun(
                application(application, language, timing),
                directory.resolve("build"),
                EchoActivity.settings(SandboxMode.AUTO.open()),
                recording)
            .run();

    assertThat(outcome).as(recording.logText()).isInstanceOf(Completed.class);
    List<String> results = new ArrayList<>();
    List<CaseResult> cases = ((Completed) outcome).result().cases();
    cases.forEach(result -> results.add(described(result)));
    List<String> expected =
        rows(application).stream().map(row -> String.join("\t", row.subList(0, 7))).toList();
    assertThat(results).as(recording.logText()).isEqualTo(expected);
    return cases;
  }

  private static String described(CaseResult result) {
    return String.join(
        "\t",
        result.values().get(0),
        result.values().get(1),
        result.expected().get(0).literal(),
        result.verdict().name(),
        result.actual().isEmpty() ? "" : result.actual().get(0).literal(),
        result.calls().recorded().stream()
            .map(ApplicationComplianceTest::described)
            .collect(Collectors.joining(" ")),
        isOfLanguage(result) ? "*" : result.message());
  }

  /** Whether the message describes an exception, which each language does in its own way. */
  private static boolean isOfLanguage(CaseResult result) {
    return result.message().contains("NoEcho") && result.actual().isEmpty()
        || result.message().contains("Refused: ");
  }

  private static String described(StubCalls.Call call) {
    return call.arguments().stream()
        .map(argument -> argument.output() + "=" + argument.literal())
        .collect(Collectors.joining(",", call.method() + "(", ")"));
  }
}
