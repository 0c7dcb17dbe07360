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
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.ActivityArchive;
import org.sitaf.server.refusal.Refusal;
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
      "one of created, name, updated; with a minus before it the largest first; without it -created";

  private static final String ZIP = "application/zip";

  private final Workspaces workspaces;
  private final Requests requests;
  private final Uploads uploads;

  ActivityController(Workspaces workspaces, Requests requests, Uploads uploads) {
    this.workspaces = workspaces;
    this.requests = requests;
    this.uploads = uploads;
  }

  @GetMapping
  @Operation(operationId = "listActivities", summary = "Activities, the newest first")
  Listing<ActivityView> list(
      @RequestParam(required = false) @Nullable String name,
      @RequestParam(defaultValue = "0") int page,
      @RequestParam(defaultValue = "50") int size,
      @Parameter(description = SORT) @RequestParam(required = false) @Nullable String sort) {
    return Listing.of(
        workspaces.list(name, Listing.request(page, size, SORTING.order(sort)), ActivityView::of),
        view -> view);
  }

  @PostMapping(consumes = ZIP)
  @Operation(
      operationId = "createActivity",
      summary = "Stores an activity",
      description =
          "The zip of an activity directory. Nothing is stored when anything is wrong with it.",
      requestBody =
          @RequestBody(
              required = true,
              content =
                  @Content(mediaType = ZIP, schema = @Schema(type = "string", format = "binary"))))
  @ResponseStatus(HttpStatus.CREATED)
  ResponseEntity<ActivityView> create(@Parameter(hidden = true) HttpServletRequest request)
      throws IOException {
    String id = uploads.unpack(request, workspaces::create);
    return ResponseEntity.created(URI.create("/api/v1/activities/" + id)).body(get(id));
  }

  @GetMapping("/{id}")
  @Operation(operationId = "getActivity", summary = "An activity")
  ActivityView get(@PathVariable String id) {
    return workspaces.inspect(id, ActivityView::of);
  }

  @DeleteMapping("/{id}")
  @Operation(
      operationId = "deleteActivity",
      summary = "Deletes an activity with its suites, builds and results",
      description = "Refused (409) while a build of it is under way.")
  @ResponseStatus(HttpStatus.NO_CONTENT)
  void delete(@PathVariable String id) {
    workspaces.delete(id);
  }

  @GetMapping(path = "/{id}/content", produces = ZIP)
  @Operation(
      operationId = "downloadActivity",
      summary = "The files of an activity, unchanged, as a zip")
  ResponseEntity<byte[]> download(@PathVariable String id) throws IOException {
    ByteArrayOutputStream zip = new ByteArrayOutputStream();
    ActivityArchive.write(workspaces.tree(id), zip);
    return attachment(get(id).name() + ".zip", ZIP, zip.toByteArray());
  }

  @PutMapping(path = "/{id}/content", consumes = ZIP)
  @Operation(
      operationId = "replaceActivity",
      summary = "Puts other files into the place of an activity's",
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
    workspaces.require(id);
    Requests.Expected version = Requests.expected(ifMatch);
    return uploads.unpack(
        request,
        files -> {
          workspaces.replace(id, files, version);
          return get(id);
        });
  }

  @GetMapping(path = "/{id}/files/{*path}", produces = MediaType.APPLICATION_OCTET_STREAM_VALUE)
  @Operation(operationId = "downloadFile", summary = "A file of an activity")
  ResponseEntity<byte[]> file(@PathVariable String id, @PathVariable String path) {
    if (path.length() < 2) {
      throw Refusal.notFound("file", path);
    }
    String inside = path.substring(1);
    String name = inside.substring(inside.lastIndexOf('/') + 1);
    // Never as a type that a browser would run: the file is a user's.
    return attachment(
        name, MediaType.APPLICATION_OCTET_STREAM_VALUE, workspaces.content(id, inside));
  }

  @GetMapping(path = "/{id}/models/{name}", produces = MediaType.APPLICATION_XML_VALUE)
  @Operation(operationId = "getModel", summary = "The document of a test model")
  ResponseEntity<byte[]> model(@PathVariable String id, @PathVariable String name) {
    return ResponseEntity.ok()
        .contentType(MediaType.APPLICATION_XML)
        .eTag(Long.toString(get(id).version()))
        .body(workspaces.modelDocument(id, name));
  }

  @PutMapping(path = "/{id}/models/{name}", consumes = MediaType.APPLICATION_XML_VALUE)
  @Operation(
      operationId = "replaceModel",
      summary = "Puts another document into the place of a test model's",
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
      workspaces.replaceModel(id, name, body.readAllBytes(), Requests.expected(ifMatch));
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
