package org.sitaf.server.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.server.support.ServerTest;
import tools.jackson.databind.JsonNode;

/** The portal's API types are generated from the committed copy of the OpenAPI document. */
@Tag("slow")
class OpenApiDocumentTest extends ServerTest {
  private static final Path COPY = Path.of("../../webapp/openapi.json");

  @Test
  void committedCopyIsUpToDate() throws IOException {
    byte[] document =
        (api.get("/v3/api-docs").expect(200).text().strip() + "\n")
            .getBytes(StandardCharsets.UTF_8);
    if (Boolean.getBoolean("sitaf.write-openapi")) {
      Files.write(COPY, document);
    }
    assertThat(new String(document, StandardCharsets.UTF_8))
        .as("webapp/openapi.json is outdated; update it with -Dsitaf.write-openapi=true")
        .isEqualTo(Files.readString(COPY));
  }

  @Test
  void everyOperationDeclaresItsProblemDetails() {
    JsonNode document = api.get("/v3/api-docs").expect(200).json();
    document
        .get("paths")
        .forEach(
            path ->
                path.forEach(
                    operation -> {
                      JsonNode responses = operation.get("responses");
                      assertThat(responses.propertyNames())
                          .as(operation.get("operationId").asString())
                          .contains("401", "default");
                      if (operation.has("requestBody")) {
                        assertThat(responses.propertyNames()).contains("400", "403", "413", "422");
                      }
                    }));
    document
        .get("components")
        .get("responses")
        .forEach(
            answer ->
                assertThat(answer.at("/content/application~1problem+json/schema/$ref").asString())
                    .isEqualTo("#/components/schemas/Problem"));
  }
}
