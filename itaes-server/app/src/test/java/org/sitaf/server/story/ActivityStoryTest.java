package org.sitaf.server.story;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.Api;
import org.sitaf.server.support.ServerTest;
import org.springframework.beans.factory.annotation.Autowired;
import org.springframework.jdbc.core.simple.JdbcClient;
import tools.jackson.databind.JsonNode;

/** Activities and suites in the REST interface. */
@Tag("slow")
class ActivityStoryTest extends ServerTest {
  private static final String ZIP = "application/zip";
  private static final String XML = "application/xml";

  @Autowired private JdbcClient jdbc;

  @Test
  void activityIsDownloadedUnchanged() {
    byte[] zip = Activities.zip();
    Api.Answer created = api.post("/api/v1/activities", ZIP, zip).expect(201);
    JsonNode activity = created.json();
    assertThat(activity.get("name").asString()).isEqualTo("ir-sensor");
    assertThat(activity.get("models").get(0).get("method").asString()).isEqualTo("GetInfraredData");
    assertThat(activity.get("interfaces").get(0).get("methods"))
        .extracting(JsonNode::asString)
        .contains("Enable()", "GetInfraredData(int32,int32)");
    String path = "/api/v1/activities/" + created.id();
    assertThat(created.headers().firstValue("Location")).contains(path);
    assertThat(api.get(path + "/content").expect(200).bytes()).isEqualTo(zip);
    String world = "world/ir.world.yaml";
    Api.Answer file = api.get(path + "/files/" + world).expect(200);
    assertThat(file.bytes()).isEqualTo(Activities.files().get(world));
    assertThat(file.headers().firstValue("Content-Disposition").orElse(""))
        .startsWith("attachment");
    assertThat(api.get("/api/v1/activities?name=ir-sensor&size=500").json().get("items"))
        .extracting(a -> a.get("id").asString())
        .contains(created.id());
    for (String part : new String[] {"R-SENS", "infraredSENSOR"}) {
      assertThat(api.get("/api/v1/activities?search=" + part + "&size=500").json().get("items"))
          .as(part)
          .extracting(a -> a.get("id").asString())
          .contains(created.id());
    }
    assertThat(api.get("/api/v1/activities?search=_").json().get("items"))
        .as("no wildcard")
        .isEmpty();
    api.delete(path).expect(204);
    api.get(path).expect(404);
  }

  @Test
  void modelIsReplacedOnlyByAValidOne() {
    String path = "/api/v1/activities/" + api.upload(Activities.zip());
    String modelPath = path + "/models/" + Activities.MODEL;
    String model = api.get(modelPath).expect(200).text();
    byte[] invalid =
        model
            .replace("min=\"1\" max=\"7\"", "min=\"8\" max=\"7\"")
            .replace("offset=\"0.5\"", "offset=\"-0.5\"")
            .getBytes(StandardCharsets.UTF_8);
    Api.Answer rejected = api.put(modelPath, XML, invalid, "*").expect(422);
    assertThat(rejected.headers().firstValue("Content-Type").orElse(""))
        .isEqualTo("application/problem+json");
    assertThat(rejected.json().get("diagnostics").size()).isGreaterThanOrEqualTo(3);
    assertThat(rejected.json().get("diagnostics").get(0).get("line").asInt()).isPositive();
    assertThat(api.get(modelPath).text()).isEqualTo(model);

    String version = api.get(modelPath).headers().firstValue("ETag").orElseThrow();
    byte[] changed = model.replace("max=\"10.0\"", "max=\"9.0\"").getBytes(StandardCharsets.UTF_8);
    JsonNode activity = api.put(modelPath, XML, changed, version).expect(200).json();
    assertThat(api.get(path).json()).isEqualTo(activity);
    assertThat(api.get(modelPath).bytes()).isEqualTo(changed);
    api.put(modelPath, XML, changed, version).expect(412);
  }

  @Test
  void invalidUploadsAreRejectedAndNotStored() {
    long before = total("/api/v1/activities");
    Map<String, byte[]> files = Activities.files();
    byte[] yaml = files.get("activity.yaml");
    assertRejected(new byte[0], "ZIP");
    assertRejected("no zip".getBytes(StandardCharsets.UTF_8), "ZIP");
    assertRejected(Activities.rawZip(List.of("activity.yaml", "../../etc/x"), yaml), "../../etc/x");
    assertRejected(Activities.rawZip(List.of("/etc/x"), yaml), "/etc/x");
    assertRejected(Activities.rawZip(List.of("a", "a/b"), yaml), "a");
    assertRejected(Activities.rawZip(List.of("readme.txt"), yaml), "activity.yaml");
    assertRejected(Activities.rawZip(List.of("zeros"), new byte[300 << 20]), "100 times its size");
    String model = new String(files.get("GetInfraredData.xml"), StandardCharsets.UTF_8);
    files.put(
        "GetInfraredData.xml",
        model
            .replace(
                "<test_model>",
                "<!DOCTYPE test_model [<!ENTITY x SYSTEM \"file:///etc/passwd\">]><test_model>")
            .getBytes(StandardCharsets.UTF_8));
    assertRejected(Activities.zip(files), "DOCTYPE");
    assertThat(total("/api/v1/activities")).isEqualTo(before);
  }

  @Test
  void suiteHasTheCasesOfThePaper() {
    String activityId = api.upload(Activities.zip());
    String suites = "/api/v1/activities/" + activityId + "/models/" + Activities.MODEL + "/suites";
    JsonNode suite = api.post(suites, "{}").expect(201).json();
    assertThat(suite.get("total").asInt()).isEqualTo(55);
    assertThat(suite.get("valid").asInt()).isEqualTo(25);
    assertThat(suite.get("parameters").get(2).get("type").asString()).isEqualTo("TDSD");
    JsonNode combined = api.post(suites, "{\"invalidValues\":\"combine\"}").expect(201).json();
    assertThat(combined.get("total").asInt()).isEqualTo(49);
    String id = suite.get("id").asString();
    JsonNode cases = api.get("/api/v1/suites/" + id + "/cases?page=1&size=30").json();
    assertThat(cases.get("items").size()).isEqualTo(25);
    assertThat(cases.get("items").get(0).get("no").asInt()).isEqualTo(31);
    assertThat(cases.get("items").get(0).get("expected").get("return").asString())
        .isEqualTo("-1.0");
    assertThat(total("/api/v1/activities/" + activityId + "/suites")).isEqualTo(2);
    api.post(suites, "{\"orderOfCombinations\":\"7\"}").expect(400);
    JsonNode bounded = api.post(suites, "{\"maxCases\":40}").expect(201).json();
    assertThat(bounded.get("total").asInt()).isBetween(20, 40);
    api.post(suites, "{\"maxCases\":0}").expect(400);
    api.post(suites.replace(Activities.MODEL, "Nothing"), "{}").expect(404);
    assertThat(api.get("/api/v1/suites/" + id + "/harness").expect(200).json())
        .filteredOn(f -> f.get("editable").asBoolean())
        .extracting(f -> f.get("path").asString())
        .singleElement()
        .asString()
        .endsWith("ConcreteTestDriver.java");
  }

  @Test
  void expectedValuesAreEditedInTheDocument() {
    String id = api.suite(api.upload(Activities.zip()));
    String path = "/api/v1/suites/" + id + "/document";
    Api.Answer document = api.get(path).expect(200);
    String version = document.headers().firstValue("ETag").orElseThrow();
    String edited =
        document.text().replaceFirst("<expected>[^<]*</expected>", "<expected>77.0</expected>");
    JsonNode suite =
        api.put(path, XML, edited.getBytes(StandardCharsets.UTF_8), version).expect(200).json();
    assertThat(suite.get("version").asLong()).isPositive();
    assertThat(
            api.get("/api/v1/suites/" + id + "/cases")
                .json()
                .get("items")
                .get(0)
                .get("expected")
                .get("return")
                .asString())
        .isEqualTo("77.0");
    api.put(path, XML, document.bytes(), version).expect(412);
    byte[] foreign =
        edited
            .replace("name=\"Distance\"", "name=\"Temperature\"")
            .getBytes(StandardCharsets.UTF_8);
    api.put(path, XML, foreign, "*").expect(409);
  }

  @Test
  void suitesAreListedWithoutReadingTheirDocuments() {
    String activity = api.upload(Activities.zip());
    String id = api.suite(activity);
    JsonNode suite = api.get("/api/v1/suites/" + id).expect(200).json();
    assertThat(suite.get("parameters"))
        .extracting(p -> p.get("name").asString())
        .containsExactly("IndexOfSensor", "NumOfSensor", "Distance");
    jdbc.sql("UPDATE suite_document SET document = ? WHERE suite_id = ?")
        .params("no XML".getBytes(StandardCharsets.UTF_8), id)
        .update();
    JsonNode list = api.get("/api/v1/activities/" + activity + "/suites").expect(200).json();
    assertThat(list.get("items").get(0)).isEqualTo(suite);
  }

  @Test
  void missingResourcesReturnProblemDetails() {
    for (String path :
        List.of(
            "/api/v1/activities/none",
            "/api/v1/suites/none",
            "/api/v1/builds/none",
            "/api/v1/builds/none/log",
            "/api/v1/builds/none/result",
            "/api/v1/schedules/none",
            "/api/v1/nonsense",
            "/api/nonsense")) {
      Api.Answer answer = api.get(path).expect(404);
      assertThat(answer.headers().firstValue("Content-Type").orElse(""))
          .as(path)
          .isEqualTo("application/problem+json");
    }
    api.get("/api/v1/builds?size=501").expect(400);
    api.get("/api/v1/builds?state=NONSENSE").expect(400);
    api.post("/api/v1/builds", "{").expect(400);
    api.post("/api/v1/builds", "{}").expect(400);
    api.post("/api/v1/activities", "text/plain", new byte[0]).expect(415);
  }

  private void assertRejected(byte[] upload, String word) {
    Api.Answer answer = api.post("/api/v1/activities", ZIP, upload);
    assertThat(answer.status()).as(answer.text()).isEqualTo(422);
    assertThat(
            answer.json().get("diagnostics").get(0).get("message").asString()
                + answer.json().get("diagnostics").get(0).get("file").asString())
        .contains(word);
  }

  private long total(String path) {
    return api.get(path).expect(200).json().get("total").asLong();
  }
}
