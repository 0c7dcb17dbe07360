package org.sitaf.server.story;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest.BodyPublishers;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.Api;
import org.sitaf.server.support.FakeAgent;
import org.sitaf.server.support.ServerTest;
import tools.jackson.databind.JsonNode;

/** Editing activities and suites, and viewing results, with the operations that the portal uses. */
@Tag("slow")
class AuthoringStoryTest extends ServerTest {
  private static final String XML = "application/xml";

  private String activityId = "";
  private String activity = "";

  @BeforeEach
  void upload() {
    activityId = api.upload(Activities.zip());
    activity = "/api/v1/activities/" + activityId;
  }

  @Test
  void descriptionContainsTypesAndWorld() {
    JsonNode description = api.get(activity + "/description").expect(200).json();
    JsonNode methods = description.get("provided").get(0).get("methods");
    JsonNode method =
        Stream.iterate(0, i -> i + 1)
            .limit(methods.size())
            .map(methods::get)
            .filter(m -> m.get("name").asString().equals(Activities.MODEL))
            .findFirst()
            .orElseThrow();
    assertThat(method.get("returnType").get("spelling").asString()).isEqualTo("double");
    assertThat(method.get("parameters"))
        .extracting(p -> p.get("name").asString())
        .containsExactly("IndexOfSensor", "NumOfSensor");
    JsonNode distance = description.get("world").get("parameters").get(0);
    assertThat(distance.get("name").asString()).isEqualTo("Distance");
    assertThat(distance.get("unit").asString()).isEqualTo("m");
    assertThat(distance.get("min").asDouble()).isLessThan(distance.get("max").asDouble());
  }

  @Test
  void fileChangesAreAtomic() {
    String version = version(activity);
    String yaml = api.get(activity + "/files/activity.yaml").expect(200).text();
    String model = api.get(activity + "/models/" + Activities.MODEL).text();
    String second = model.replace("<name>GetInfraredData</name>", "<name>Second</name>");
    String both =
        changes(
            Map.of(
                "Second.xml",
                second,
                "activity.yaml",
                yaml.replace(
                    "models: [GetInfraredData.xml]", "models: [GetInfraredData.xml, Second.xml]")));
    patch(activity + "/files", changes(Map.of("activity.yaml", "name: ir")), version).expect(422);
    assertThat(api.get(activity + "/files/activity.yaml").text()).isEqualTo(yaml);
    JsonNode changed = patch(activity + "/files", both, version).expect(200).json();
    assertThat(changed.get("models"))
        .extracting(m -> m.get("name").asString())
        .containsExactly("GetInfraredData", "Second");
    patch(activity + "/files", both, version).expect(412);
    patch(activity + "/files", changes(Map.of("../x", "")), "*").expect(422);
  }

  private Api.Answer add(Map<String, byte[]> files, String version) {
    return api.send(
        api.request(activity + "/files")
            .header("Content-Type", "application/zip")
            .header("If-Match", version)
            .POST(BodyPublishers.ofByteArray(Activities.zip(files))));
  }

  @Test
  void filesAreAddedTogetherOrNotAtAll() {
    String version = version(activity);
    byte[] mesh = {0, 1, (byte) 0xff};
    JsonNode added = add(Map.of("world/meshes/arm.stl", mesh), version).expect(200).json();
    assertThat(added.get("files"))
        .extracting(file -> file.get("path").asString())
        .as("a folder that contains all of them stays")
        .contains("world/meshes/arm.stl", "activity.yaml");
    assertThat(api.get(activity + "/files/world/meshes/arm.stl").bytes()).isEqualTo(mesh);
    add(Map.of("x", mesh), version).expect(412);
    byte[] bad = "name: ir".getBytes(StandardCharsets.UTF_8);
    add(Map.of("y", mesh, "activity.yaml", bad), "*").expect(422);
    assertThat(add(Map.of("activity.yaml/y", mesh), "*").expect(422).text())
        .contains("the added files");
    assertThat(api.get(activity).json().get("files"))
        .extracting(file -> file.get("path").asString())
        .doesNotContain("x", "y", "activity.yaml/y");
    api.post("/api/v1/activities/none/files", "application/zip", Activities.zip()).expect(428);
  }

  @Test
  void filesAreCheckedWithoutBeingStored() {
    Map<String, byte[]> files = Activities.files();
    Api.Answer good =
        api.post("/api/v1/activity-checks", "application/zip", Activities.zip(files)).expect(200);
    assertThat(good.json().get("diagnostics").size()).isZero();
    assertThat(good.json().get("description").get("provided").size()).isPositive();
    files.remove("InfraredSensorService.xml");
    JsonNode bad =
        api.post("/api/v1/activity-checks", "application/zip", Activities.zip(files))
            .expect(200)
            .json();
    assertThat(bad.has("description")).isFalse();
    assertThat(bad.get("diagnostics").get(0).get("message").asString())
        .contains("InfraredSensorService.xml");
  }

  @Test
  void previewContainsValuesAndNumberOfCases() {
    String model = api.get(activity + "/models/" + Activities.MODEL).text();
    String path = activity + "/model-previews?cases=true";
    JsonNode preview = api.post(path, XML, bytes(model)).expect(200).json();
    assertThat(preview.get("counts").get("total").asInt()).isEqualTo(55);
    assertThat(preview.get("counts").get("valid").asInt()).isEqualTo(25);
    JsonNode index = preview.get("inputs").get(0);
    assertThat(index.get("values"))
        .extracting(v -> v.get("literal").asString())
        .containsExactly("0", "1", "2", "4", "6", "7", "8");
    assertThat(index.get("values"))
        .extracting(v -> v.get("valid").asBoolean())
        .containsExactly(false, true, true, true, true, true, false);

    JsonNode wide =
        api.post(path, XML, bytes(model.replace("max=\"10.0\"", "max=\"1e6\""))).expect(200).json();
    assertThat(wide.has("counts")).isFalse();
    assertThat(wide.get("inputs").size()).as("values are shown despite the error").isEqualTo(3);
    assertThat(wide.get("diagnostics").get(0).get("element").asString()).contains("Distance");
    JsonNode unreadable = api.post(path, XML, bytes("<test_model/>")).expect(200).json();
    assertThat(unreadable.get("diagnostics").size()).isPositive();
    assertThat(api.get(activity + "/models/" + Activities.MODEL).text()).isEqualTo(model);
  }

  @Test
  void previewOfSequencesContainsTheStatesAndTheValuesOfCalls() {
    String id = api.upload(Activities.zip(Activities.files("ir-sensor-states")));
    String states = "/api/v1/activities/" + id;
    String model = api.get(states + "/models/LifeCycle").text();
    JsonNode preview = api.post(states + "/model-previews", XML, bytes(model)).expect(200).json();
    JsonNode read = preview.get("calls").get(2);
    assertThat(read.get("name").asString()).isEqualTo("Read");
    assertThat(read.get("inputs").get(0).get("values"))
        .extracting(v -> v.get("literal").asString())
        .containsExactly("1", "2");
    JsonNode diagram = preview.get("states");
    assertThat(diagram.get("states").size()).as("three booleans").isEqualTo(8);
    assertThat(diagram.get("transitions"))
        .filteredOn(t -> t.get("from").asInt() == 0)
        .extracting(t -> t.get("step").asString() + " " + t.get("kind").asString())
        .containsExactlyInAnyOrder(
            "Enable VALID",
            "Disable VALID",
            "Read FORBIDDEN",
            "ObstacleNears VALID",
            "DropsOut VALID");

    String wrong = model.replace("<guard>enabled</guard>", "<guard>enabeld</guard>");
    JsonNode refused = api.post(states + "/model-previews", XML, bytes(wrong)).expect(200).json();
    assertThat(refused.has("states")).isFalse();
    assertThat(refused.get("calls").size()).as("values are shown despite the error").isEqualTo(3);
    assertThat(refused.get("diagnostics").get(0).get("element").asString())
        .isEqualTo("call Read/guard");
  }

  @Test
  void aSuiteOfSequencesShowsItsStepsAndSurvivesAnImport() {
    String id = api.upload(Activities.zip(Activities.files("ir-sensor-states")));
    String suites = "/api/v1/activities/" + id + "/models/LifeCycle/suites";
    String suite =
        "/api/v1/suites/" + api.post(suites, "{}").expect(201).json().get("id").asString();
    JsonNode cases = api.get(suite + "/cases?size=500").expect(200).json().get("items");
    JsonNode forbidden =
        IntStream.range(0, cases.size())
            .mapToObj(cases::get)
            .filter(c -> !c.get("valid").asBoolean())
            .flatMap(c -> IntStream.range(0, c.get("steps").size()).mapToObj(c.get("steps")::get))
            .filter(s -> s.get("name").asString().equals("Read") && !s.get("valid").asBoolean())
            .findFirst()
            .orElseThrow();
    assertThat(forbidden.get("expected").get("return").asString()).isEqualTo("-1.0");
    assertThat(forbidden.get("inputs").has("NumOfSensor")).isTrue();

    String json = api.get(suite + "/cases.json").expect(200).text();
    String document = api.get(suite + "/document").expect(200).text();
    String binary = "application/octet-stream";
    api.put(suite + "/cases.json", binary, bytes(json), version(suite)).expect(200);
    assertThat(api.get(suite + "/document").text()).as("nothing was lost").isEqualTo(document);
    String changed =
        json.replaceFirst("\"expected\":\\{\"return\":\"5.0\"", "\"expected\":{\"return\":\"6.0\"");
    api.put(suite + "/cases.json", binary, bytes(changed), version(suite)).expect(200);
    assertThat(api.get(suite + "/document").text()).contains("<expected>6.0</expected>");
    String without = "{\"cases\":[{\"no\":1,\"values\":[\"5.0\"]}]}";
    assertThat(
            api.put(suite + "/cases.json", binary, bytes(without), version(suite))
                .expect(422)
                .text())
        .contains("case 1 has no steps");

    String next =
        "/api/v1/suites/" + api.post(suites, "{}").expect(201).json().get("id").asString();
    JsonNode changes = api.get(next + "/changes").expect(200).json();
    assertThat(changes.get("expectedChanged").asInt()).isEqualTo(1);
    assertThat(changes.get("kept").asInt()).isEqualTo(cases.size() - 1);
    assertThat(changes.get("added").asInt()).isZero();
  }

  @Test
  void aModelOfSequencesIsProposedForAnInterface() {
    String id = api.upload(Activities.zip(Activities.files("ir-sensor-states")));
    String path = "/api/v1/activities/" + id + "/proposals/sequences?interface=";
    String model = api.get(path + "InfraredSensorService&name=Mine").expect(200).text();
    assertThat(model)
        .contains("<name>Mine</name>", "<state name=\"enabled\" type=\"boolean\"", "A guess");
    String previews = "/api/v1/activities/" + id + "/model-previews?cases=true";
    JsonNode preview = api.post(previews, XML, bytes(model)).expect(200).json();
    assertThat(preview.get("counts").get("valid").asInt()).isPositive();
    assertThat(api.get(path + "Nothing").expect(400).text()).contains("Nothing");
  }

  @Test
  void previewOfTooLargeModelFailsImmediately() {
    String model = api.get(activity + "/models/" + Activities.MODEL).text();
    String path = activity + "/model-previews?cases=true";
    String digits = "[0,1,2,3,4,5,6,7,8,9].all(i, ".repeat(14) + "true" + ")".repeat(14);
    String nested =
        model.replace(
            "<input_spec_list>",
            "<pre_condition_spec_list><pre_condition>"
                + digits
                + "</pre_condition></pre_condition_spec_list><input_spec_list>");
    JsonNode preview = api.post(path, XML, bytes(nested)).expect(200).json();
    assertThat(preview.has("counts")).isFalse();
    assertThat(preview.get("diagnostics").get(0).get("message").asString())
        .contains("steps", "5,000,000");
    JsonNode next = api.post(path, XML, bytes(model)).expect(200).json();
    assertThat(next.get("counts").get("total").asInt()).isEqualTo(55);
    api.put(activity + "/models/" + Activities.MODEL, XML, bytes(nested), "*").expect(422);
  }

  @Test
  void expectedValuesCanBeSetFilledImportedAndUndone() {
    String suite = "/api/v1/suites/" + api.suite(activityId);
    String version = version(suite);
    String one = "{\"changes\":[{\"no\":3,\"literal\":\"7\"},{\"no\":4}]}";
    JsonNode changed = patch(suite + "/expected", one, version).expect(200).json();
    assertThat(changed.get("undoable").asInt()).isEqualTo(1);
    assertThat(expected(suite, 3)).isEqualTo("7.0");
    assertThat(expected(suite, 4)).isEmpty();
    patch(suite + "/expected", one, version).expect(412);
    assertThat(
            patch(suite + "/expected", "{\"changes\":[{\"no\":3,\"literal\":\"far\"}]}", "*")
                .expect(422)
                .text())
        .contains("case 3");

    api.change(suite + "/expected/fill", "{\"expression\":\"Distance * 2.0\"}", "*").expect(200);
    assertThat(expected(suite, 3)).as("is kept").isEqualTo("7.0");
    assertThat(Double.valueOf(expected(suite, 4)))
        .isEqualTo(2 * Double.parseDouble(value(suite, 4, 2)));
    api.change(suite + "/expected/fill", "{\"expression\":\"Nothing + 1\"}", "*").expect(422);

    String csv = api.get(suite + "/cases.csv").expect(200).text();
    assertThat(csv).startsWith("no,class,IndexOfSensor,NumOfSensor,Distance,expected\r\n");
    byte[] json = api.get(suite + "/cases.json").expect(200).bytes();
    String edited = csv.replaceFirst("(?m)^3,(.*),7\\.0$", "3,$1,9.0");
    api.put(suite + "/cases.csv", "text/csv", bytes(edited), "*").expect(200);
    assertThat(expected(suite, 3)).isEqualTo("9.0");
    api.put(suite + "/cases.json", "application/octet-stream", json, "*").expect(200);
    assertThat(expected(suite, 3)).isEqualTo("7.0");
    api.put(suite + "/cases.csv", "text/csv", bytes("no\r\n"), "*").expect(422);

    api.change(suite + "/undo", "", "*").expect(200);
    assertThat(expected(suite, 3)).isEqualTo("9.0");
    for (int left = 3; left > 0; left--) {
      assertThat(api.change(suite + "/undo", "", "*").expect(200).json().get("undoable").asInt())
          .isEqualTo(left - 1);
    }
    api.change(suite + "/undo", "", "*").expect(409);
    assertThat(expected(suite, 3)).isNotEqualTo("7.0");
  }

  @Test
  void customDriverIsShownWithTheGeneratedOne() {
    String suite = api.suite(activityId);
    JsonNode generated = driver(suite);
    assertThat(generated.has("generated")).isFalse();
    String path = generated.get("keptPath").asString();
    String own = "// mine\n" + generated.get("content").asString();
    patch(activity + "/files", changes(Map.of(path, own)), "*").expect(200);
    JsonNode kept = driver(suite);
    assertThat(kept.get("content").asString()).isEqualTo(own);
    assertThat(kept.get("generated")).isEqualTo(generated.get("content"));
    patch(activity + "/files", "{\"changes\":[{\"path\":\"" + path + "\"}]}", "*").expect(200);
    assertThat(driver(suite)).isEqualTo(generated);
  }

  @Test
  void changeWithoutIfMatchIsRejected() {
    String id = api.upload(Activities.zip());
    String activity = "/api/v1/activities/" + id;
    String suite = "/api/v1/suites/" + api.suite(id);
    byte[] model = api.get(activity + "/models/" + Activities.MODEL).bytes();
    String change = changes(Map.of("notes.txt", "one"));
    assertThat(patch(activity + "/files", change, null).expect(428).text()).contains("If-Match");
    api.put(activity + "/models/" + Activities.MODEL, XML, model, null).expect(428);
    api.put(activity + "/content", "application/zip", Activities.zip(), null).expect(428);
    patch(suite + "/expected", "{\"changes\":[]}", null).expect(428);
    api.post(suite + "/undo", "").expect(428);
    patch(activity + "/files", change, "three").expect(400);
  }

  @Test
  void concurrentChangesOfDifferentFilesAreMerged() {
    String activity = "/api/v1/activities/" + api.upload(Activities.zip());
    List<String> paths = IntStream.range(0, 4).mapToObj("note-%d.txt"::formatted).toList();
    List<CompletableFuture<Api.Answer>> answers =
        paths.stream()
            .map(
                path ->
                    CompletableFuture.supplyAsync(
                        () -> patch(activity + "/files", changes(Map.of(path, "text")), "*")))
            .toList();
    answers.forEach(answer -> answer.join().expect(200));
    assertThat(api.get(activity).json().get("files"))
        .extracting(f -> f.get("path").asString())
        .containsAll(paths);
  }

  private JsonNode driver(String suiteId) {
    for (JsonNode file : api.get("/api/v1/suites/" + suiteId + "/harness").expect(200).json()) {
      if (file.get("editable").asBoolean()) {
        return file;
      }
    }
    throw new AssertionError("no file is editable");
  }

  @Test
  void combinationsAndChangesOfASuite() {
    String first = api.suite(activityId);
    assertThat(api.get("/api/v1/suites/" + first + "/changes").json().has("previousId")).isFalse();
    String combined =
        api.post(
                activity + "/models/" + Activities.MODEL + "/suites",
                "{\"invalidValues\":\"combine\"}")
            .expect(201)
            .id();
    JsonNode combinations =
        api.get("/api/v1/suites/" + combined + "/combinations?first=0&second=2").json();
    assertThat(combinations.get("pairs"))
        .allSatisfy(
            pair ->
                assertThat(pair.get("covered").asInt()).isEqualTo(pair.get("possible").asInt()));
    assertThat(combinations.get("counts").get("cases").size()).isEqualTo(7);
    JsonNode changes = api.get("/api/v1/suites/" + combined + "/changes").expect(200).json();
    assertThat(changes.get("previousId").asString()).isEqualTo(first);
    assertThat(
            changes.get("kept").asInt()
                + changes.get("added").asInt()
                + changes.get("expectedChanged").asInt())
        .isEqualTo(49);
    assertThat(
            changes.get("kept").asInt()
                + changes.get("removed").asInt()
                + changes.get("expectedChanged").asInt())
        .isEqualTo(55);
  }

  @Test
  void resultIsAnalysedComparedAndExported() {
    String suite = api.suite(activityId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "analyst", "java")) {
      String before = build(agent, suite, List.of(7, 8));
      String now = build(agent, suite, List.of(8, 9));
      String result = "/api/v1/builds/" + now + "/result";
      JsonNode statistics = api.get(result + "/statistics").expect(200).json();
      JsonNode times = statistics.get("times");
      assertThat(times.get("count").asInt()).isEqualTo(55);
      assertThat(times.get("p50").asDouble()).isEqualTo(28);
      assertThat(times.get("p99").asDouble()).isEqualTo(55);
      assertThat(sum(times.get("histogram"), "count")).isEqualTo(55);
      assertThat(times.get("overCases").size()).isEqualTo(55);
      JsonNode distance = statistics.get("parameters").get(2);
      assertThat(distance.get("name").asString()).isEqualTo("Distance");
      assertThat(sum(distance.get("values"), "pass")).isEqualTo(53);
      assertThat(sum(distance.get("values"), "fail")).isEqualTo(2);

      JsonNode failures = api.get(result + "/failures").expect(200).json();
      assertThat(failures.get("groups")).hasSize(1);
      assertThat(failures.get("groups").get(0).get("cases").asInt()).isEqualTo(2);
      assertThat(failures.get("groups").get(0).get("newlyFailing").asInt()).isEqualTo(1);
      assertThat(failures.get("firstFailing").asInt()).isEqualTo(8);
      assertThat(failures.get("before").get("buildId").asString()).isEqualTo(before);
      assertThat(failures.get("before").get("fixed").asInt()).isEqualTo(1);
      assertThat(failures.get("since").get("buildId").asString()).isEqualTo(before);
      assertThat(failures.get("since").get("results").asInt()).isEqualTo(2);
      JsonNode first = api.get("/api/v1/builds/" + before + "/result/failures").json();
      assertThat(first.has("before")).isFalse();
      api.get("/api/v1/builds/none/result/failures").expect(404);

      JsonNode comparison = api.get(result + "/comparison?with=" + before).expect(200).json();
      assertThat(comparison.get("common").asInt()).isEqualTo(55);
      assertThat(comparison.get("items"))
          .extracting(i -> i.get("change").asString() + " " + i.get("no").asInt())
          .containsExactly("newlyFailing 9", "fixed 7");
      assertThat(comparison.get("slower").asInt()).isZero();
      assertThat(comparison.get("notTimed").asString())
          .startsWith("Times are not compared, because the results have no repeated calls.");

      JsonNode far =
          api.get(result + "/cases?parameter=Distance&value=10.0&size=500").expect(200).json();
      assertThat(far.get("total").asInt()).isPositive();
      assertThat(far.get("items"))
          .allSatisfy(c -> assertThat(c.get("values").get(2).asString()).isEqualTo("10.0"));
      api.get(result + "/cases?parameter=Nothing&value=1").expect(400);

      assertThat(api.get(result + "/cases.csv").expect(200).text().lines()).hasSize(56);
      assertThat(api.get(result + "/report").expect(200).text())
          .startsWith("<!doctype html>")
          .contains("GetInfraredData", "Std deviation")
          .doesNotContain("<script");
      assertThat(api.get("/api/v1/builds?search=IR-SENS&size=500").expect(200).json().get("items"))
          .extracting(b -> b.get("id").asString())
          .contains(now, before);
      assertThat(api.get("/api/v1/builds?search=getinfraRED").json().get("total").asInt())
          .isPositive();
      assertThat(api.get("/api/v1/builds?search=%25").json().get("total").asInt()).isZero();
      JsonNode history = api.get(activity + "/results?model=" + Activities.MODEL).json();
      assertThat(history.get("items"))
          .extracting(r -> r.get("buildId").asString())
          .containsExactly(now, before);
      assertThat(history.get("items").get(0).get("summary").get("fail").asInt()).isEqualTo(2);
    }
  }

  private String build(FakeAgent agent, String suiteId, List<Integer> failing) {
    String id = api.build(suiteId);
    // A build that another test left in the queue, or an attempt that took too long, is not it.
    while (true) {
      var assignment = agent.nextAssignment();
      TestApplication application = agent.download(assignment);
      boolean stored =
          agent.submit(assignment.getAttempt(), FakeAgent.result(application, failing));
      if (stored && assignment.getAttempt().getBuildId().equals(id)) {
        return id;
      }
    }
  }

  private static int sum(JsonNode items, String field) {
    int sum = 0;
    for (JsonNode item : items) {
      sum += item.get(field).asInt();
    }
    return sum;
  }

  private String expected(String suite, int no) {
    JsonNode expected = testCase(suite, no).get("expected");
    return expected.has("return") ? expected.get("return").asString() : "";
  }

  private String value(String suite, int no, int parameter) {
    return testCase(suite, no).get("values").get(parameter).asString();
  }

  private JsonNode testCase(String suite, int no) {
    return api.get(suite + "/cases?size=500").expect(200).json().get("items").get(no - 1);
  }

  private String version(String path) {
    return api.get(path).expect(200).json().get("version").asString();
  }

  private Api.Answer patch(String path, String json, @Nullable String version) {
    var request =
        api.request(path)
            .header("Content-Type", "application/json")
            .method("PATCH", BodyPublishers.ofString(json));
    return api.send(version == null ? request : request.header("If-Match", version));
  }

  private static String changes(Map<String, String> files) {
    return tools.jackson.databind.json.JsonMapper.builder()
        .build()
        .writeValueAsString(
            Map.of(
                "changes",
                files.entrySet().stream()
                    .map(f -> Map.of("path", f.getKey(), "content", f.getValue()))
                    .toList()));
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }
}
