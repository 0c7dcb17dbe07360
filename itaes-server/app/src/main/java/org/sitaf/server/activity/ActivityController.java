package org.sitaf.server.activity;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.media.Content;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.parameters.RequestBody;
import io.swagger.v3.oas.annotations.tags.Tag;
import jakarta.servlet.http.HttpServletRequest;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.ActivityArchive;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.web.Listing;
import org.sitaf.server.web.Requests;
import org.sitaf.server.web.Sorting;
import org.sitaf.server.web.Uploads;
import org.springframework.http.ContentDisposition;
import org.springframework.http.HttpHeaders;
import org.springframework.http.HttpStatus;
import org.springframework.http.MediaType;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.PutMapping;
import org.springframework.web.bind.annotation.RequestHeader;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1/activities")
@Tag(name = "activities")
class ActivityController {
  private static final Sorting SORTING = Sorting.by("created", "name", "updated");
  private static final String SORT =
      "one of created, name, updated; a leading minus means descending order; default -created";

  private static final String ZIP = "application/zip";

  private final StoredActivities activities;
  private final Requests requests;
  private final Uploads uploads;

  ActivityController(StoredActivities activities, Requests requests, Uploads uploads) {
    this.activities = activities;
    this.requests = requests;
    this.uploads = uploads;
  }

  @GetMapping
  @Operation(operationId = "listActivities", summary = "Lists activities, newest first")
  Listing<ActivityView> list(
      @RequestParam(required = false) @Nullable String name,
      @Parameter(
              description =
                  "a part of the name, the description or the component's class; case is ignored")
          @RequestParam(required = false)
          @Nullable String search,
      @Parameter(description = "a tag of the activities; of several, they have all")
          @RequestParam(required = false)
          @Nullable Set<String> tag,
      @RequestParam(defaultValue = "0") int page,
      @RequestParam(defaultValue = "50") int size,
      @Parameter(description = SORT) @RequestParam(required = false) @Nullable String sort) {
    return Listing.of(
        activities.list(
            name,
            search,
            tag == null ? Set.of() : tag,
            Listing.request(page, size, SORTING.order(sort)),
            ActivityView::of),
        view -> view);
  }

  @PostMapping(consumes = ZIP)
  @Operation(
      operationId = "createActivity",
      summary = "Creates an activity",
      description =
          "The body is the zip of an activity directory. Nothing is stored if it has errors.",
      requestBody =
          @RequestBody(
              required = true,
              content =
                  @Content(mediaType = ZIP, schema = @Schema(type = "string", format = "binary"))))
  @ResponseStatus(HttpStatus.CREATED)
  ResponseEntity<ActivityView> create(@Parameter(hidden = true) HttpServletRequest request)
      throws IOException {
    String id = uploads.unpack(request, activities::create);
    return ResponseEntity.created(URI.create("/api/v1/activities/" + id)).body(get(id));
  }

  @GetMapping("/{id}")
  @Operation(operationId = "getActivity", summary = "Returns an activity")
  ActivityView get(@PathVariable String id) {
    return activities.inspect(id, ActivityView::of);
  }

  @DeleteMapping("/{id}")
  @Operation(
      operationId = "deleteActivity",
      summary = "Deletes an activity with its suites, builds and results",
      description = "Fails with 409 while a build of it is running.")
  @ResponseStatus(HttpStatus.NO_CONTENT)
  void delete(@PathVariable String id) {
    activities.delete(id);
  }

  @GetMapping(path = "/{id}/content", produces = ZIP)
  @Operation(
      operationId = "downloadActivity",
      summary = "Downloads the files of an activity as a zip, unchanged")
  ResponseEntity<byte[]> download(@PathVariable String id) throws IOException {
    ByteArrayOutputStream zip = new ByteArrayOutputStream();
    ActivityArchive.write(activities.tree(id), zip);
    return attachment(get(id).name() + ".zip", ZIP, zip.toByteArray());
  }

  @PutMapping(path = "/{id}/content", consumes = ZIP)
  @Operation(
      operationId = "replaceActivity",
      summary = "Replaces the files of an activity",
      requestBody =
          @RequestBody(
              required = true,
              content =
                  @Content(mediaType = ZIP, schema = @Schema(type = "string", format = "binary"))))
  ActivityView replace(
      @PathVariable String id,
      @RequestHeader(HttpHeaders.IF_MATCH) String ifMatch,
      @Parameter(hidden = true) HttpServletRequest request)
      throws IOException {
    activities.require(id);
    Requests.Expected version = Requests.expected(ifMatch);
    return uploads.unpack(
        request,
        files -> {
          activities.replace(id, files, version);
          return get(id);
        });
  }

  @GetMapping(path = "/{id}/files/{*path}", produces = MediaType.APPLICATION_OCTET_STREAM_VALUE)
  @Operation(operationId = "downloadFile", summary = "Downloads a file of an activity")
  ResponseEntity<byte[]> file(@PathVariable String id, @PathVariable String path) {
    if (path.length() < 2) {
      throw RequestException.notFound("file", path);
    }
    String relative = path.substring(1);
    String name =
        relative.substring(
            relative.lastIndexOf('/')
                + 1); // The file comes from a user: never send a media type that a browser would
    // execute.
    return attachment(
        name, MediaType.APPLICATION_OCTET_STREAM_VALUE, activities.content(id, relative));
  }

  @GetMapping(path = "/{id}/models/{name}", produces = MediaType.APPLICATION_XML_VALUE)
  @Operation(operationId = "getModel", summary = "Returns the document of a test model")
  ResponseEntity<byte[]> model(@PathVariable String id, @PathVariable String name) {
    return ResponseEntity.ok()
        .contentType(MediaType.APPLICATION_XML)
        .eTag(Long.toString(get(id).version()))
        .body(activities.modelDocument(id, name));
  }

  @PutMapping(path = "/{id}/models/{name}", consumes = MediaType.APPLICATION_XML_VALUE)
  @Operation(
      operationId = "replaceModel",
      summary = "Replaces the document of a test model",
      requestBody =
          @RequestBody(
              required = true,
              content =
                  @Content(
                      mediaType = MediaType.APPLICATION_XML_VALUE,
                      schema = @Schema(type = "string"))))
  ActivityView replaceModel(
      @PathVariable String id,
      @PathVariable String name,
      @RequestHeader(HttpHeaders.IF_MATCH) String ifMatch,
      @Parameter(hidden = true) HttpServletRequest request)
      throws IOException {
    try (InputStream body = requests.body(request)) {
      activities.replaceModel(id, name, body.readAllBytes(), Requests.expected(ifMatch));
    }
    return get(id);
  }

  private static ResponseEntity<byte[]> attachment(String name, String type, byte[] content) {
    return ResponseEntity.ok()
        .contentType(MediaType.parseMediaType(type))
        .header(
            HttpHeaders.CONTENT_DISPOSITION,
            ContentDisposition.attachment()
                .filename(name, StandardCharsets.UTF_8)
                .build()
                .toString())
        .body(content);
  }
}
