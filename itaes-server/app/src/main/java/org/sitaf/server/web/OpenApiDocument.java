package org.sitaf.server.web;

import io.swagger.v3.core.converter.ModelConverters;
import io.swagger.v3.oas.models.Components;
import io.swagger.v3.oas.models.OpenAPI;
import io.swagger.v3.oas.models.Operation;
import io.swagger.v3.oas.models.info.Info;
import io.swagger.v3.oas.models.info.License;
import io.swagger.v3.oas.models.media.MediaType;
import io.swagger.v3.oas.models.media.Schema;
import io.swagger.v3.oas.models.responses.ApiResponses;
import io.swagger.v3.oas.models.security.SecurityRequirement;
import io.swagger.v3.oas.models.security.SecurityScheme;
import io.swagger.v3.oas.models.servers.Server;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.springdoc.core.customizers.OpenApiCustomizer;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Lazy;

/**
 * The OpenAPI document at /v3/api-docs. It does not depend on where the server runs; clients are
 * generated from it.
 */
@Configuration(proxyBeanMethods = false)
class OpenApiDocument {
  private static final String REFERENCE = "#/components/schemas/";
  private static final String LISTING = "Listing";

  @Bean
  @Lazy
  OpenAPI description() {
    return new OpenAPI()
        .info(
            new Info()
                .title("SITAF")
                .version("v1")
                .license(
                    new License()
                        .name("Apache-2.0")
                        .url("https://www.apache.org/licenses/LICENSE-2.0"))
                .description(
                    "Automated interface testing of robot software components. Errors are problem"
                        + " details (RFC 9457): 401 without a session or token, 403 if the caller's"
                        + " role does not allow the operation. Reading requires the role VIEWER,"
                        + " changing TESTER, and a build with real devices OPERATOR; users, the"
                        + " audit log, webhooks and agents' keys require ADMINISTRATOR."))
        .components(
            new Components()
                .addSecuritySchemes(
                    "token",
                    new SecurityScheme()
                        .type(SecurityScheme.Type.HTTP)
                        .scheme("bearer")
                        .description("for scripts; created in the portal"))
                .addSecuritySchemes(
                    "session",
                    new SecurityScheme()
                        .type(SecurityScheme.Type.APIKEY)
                        .in(SecurityScheme.In.COOKIE)
                        .name("SITAF_SESSION")
                        .description(
                            "for browsers; changes also require the value of the cookie XSRF-TOKEN"
                                + " in the header X-XSRF-TOKEN")))
        .security(
            List.of(
                new SecurityRequirement().addList("token"),
                new SecurityRequirement().addList("session")))
        .servers(List.of(new Server().url("/")));
  }

  @Bean
  @Lazy
  OpenApiCustomizer customizer() {
    return document -> {
      Components components = document.getComponents();
      for (Class<?> view : Problems.views()) {
        ModelConverters.getInstance(true).readAll(view).forEach(components::addSchemas);
      }
      renamePages(components);
      ErrorAnswers.addTo(components);
      document
          .getPaths()
          .forEach(
              (path, item) ->
                  item.readOperationsMap()
                      .forEach(
                          (method, operation) -> {
                            customize(operation);
                            ErrorAnswers.addTo(path, method, operation);
                          }));
    };
  }

  /** Renames {@code ListingActivity} to {@code ActivityPage}. */
  private static void renamePages(Components components) {
    Map<String, Schema> renamed = new LinkedHashMap<>();
    components.getSchemas().forEach((name, schema) -> renamed.put(pageName(name), schema));
    components.setSchemas(renamed);
  }

  private static void customize(Operation operation) {
    ApiResponses responses = operation.getResponses();
    responses
        .values()
        .forEach(
            response -> {
              if (response.getContent() != null) {
                response.getContent().values().forEach(OpenApiDocument::renameReference);
                response.getContent().forEach(OpenApiDocument::correctFormat);
              }
            });
  }

  private static void renameReference(MediaType content) {
    Schema<?> schema = content.getSchema();
    if (schema != null && schema.get$ref() != null && schema.get$ref().startsWith(REFERENCE)) {
      schema.set$ref(REFERENCE + pageName(schema.get$ref().substring(REFERENCE.length())));
    }
  }

  /** Java's byte arrays are base64 in JSON only; other media types contain text or binary data. */
  private static void correctFormat(String type, MediaType content) {
    Schema<?> schema = content.getSchema();
    if (schema != null && "byte".equals(schema.getFormat()) && !type.contains("json")) {
      schema.setFormat(type.contains("xml") ? null : "binary");
    }
  }

  private static String pageName(String name) {
    return name.startsWith(LISTING) ? name.substring(LISTING.length()) + "Page" : name;
  }
}
