package org.sitaf.server.activity;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.media.Content;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import jakarta.servlet.http.HttpServletRequest;
import java.io.IOException;
import java.util.List;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.beginning.SequenceProposal;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.web.Requests;
import org.sitaf.server.web.Uploads;
import org.springframework.http.HttpHeaders;
import org.springframework.http.MediaType;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PatchMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.PutMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestHeader;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.RestController;

/** Operations for editing activities. */
@RestController
@RequestMapping("/api/v1")
@Tag(name = "activities")
class AuthoringController {
  private static final String ZIP = "application/zip";

  private final StoredActivities activities;
  private final Uploads uploads;

  AuthoringController(StoredActivities activities, Uploads uploads) {
    this.activities = activities;
    this.uploads = uploads;
  }

  @GetMapping("/activities/{id}/description")
  @Operation(
      operationId = "describeActivity",
      summary = "Returns the interfaces of an activity with resolved types, and its world")
  DescriptionView description(@PathVariable String id) {
    return DescriptionView.of(activities.activity(id));
  }

  @GetMapping(
      path = "/activities/{id}/proposals/sequences",
      produces = MediaType.APPLICATION_XML_VALUE)
  @Operation(
      operationId = "proposeSequences",
      summary = "Proposes a test model of sequences for an interface, without storing it",
      description = "States, guards and updates are guesses from the names of the methods.")
  ResponseEntity<String> sequences(
      @PathVariable String id,
      @RequestParam("interface") String interfaceName,
      @RequestParam(defaultValue = "Sequences") String name) {
    Activity activity = activities.activity(id);
    InterfaceDescription provided =
        activity.provided().stream()
            .filter(i -> i.name().equals(interfaceName))
            .findFirst()
            .orElseThrow(
                () ->
                    RequestException.malformed(
                        "The activity provides no interface '" + interfaceName + "'."));
    return ResponseEntity.ok()
        .contentType(MediaType.APPLICATION_XML)
        .body(SequenceProposal.always(provided, name));
  }

  @PatchMapping("/activities/{id}/files")
  @Operation(
      operationId = "changeFiles",
      summary = "Changes several files of an activity",
      description = "Nothing is changed if the activity would have errors.")
  ActivityView changeFiles(
      @PathVariable String id,
      @RequestHeader(HttpHeaders.IF_MATCH) String ifMatch,
      @RequestBody FileChanges changes) {
    if (changes.changes() == null) {
      throw RequestException.malformed("changes must be given.");
    }
    activities.change(id, changes, Requests.expected(ifMatch));
    return activities.inspect(id, ActivityView::of);
  }

  @PostMapping(path = "/activities/{id}/files", consumes = ZIP)
  @Operation(
      operationId = "addFiles",
      summary = "Adds the files of a zip to an activity, and replaces those of the same paths",
      description = "Nothing is changed if the activity would have errors.",
      requestBody =
          @io.swagger.v3.oas.annotations.parameters.RequestBody(
              required = true,
              content =
                  @Content(mediaType = ZIP, schema = @Schema(type = "string", format = "binary"))))
  ActivityView addFiles(
      @PathVariable String id,
      @RequestHeader(HttpHeaders.IF_MATCH) String ifMatch,
      @Parameter(hidden = true) HttpServletRequest request)
      throws IOException {
    activities.require(id);
    Requests.Expected version = Requests.expected(ifMatch);
    return uploads.unpackWhole(
        request,
        files -> {
          activities.add(id, files, version);
          return activities.inspect(id, ActivityView::of);
        });
  }

  @GetMapping("/tags")
  @Operation(operationId = "listTags", summary = "Lists the tags of all activities, by name")
  List<Tags.Use> tags() {
    return activities.tags();
  }

  @PutMapping("/activities/{id}/tags")
  @Operation(
      operationId = "replaceTags",
      summary = "Replaces the tags of an activity",
      description = "Tags do not belong to the files, so the version of the activity stays.")
  ActivityView tag(@PathVariable String id, @RequestBody Tags tags) {
    activities.tag(id, tags.requireValid());
    return activities.inspect(id, ActivityView::of);
  }

  @PostMapping(path = "/activity-checks", consumes = ZIP)
  @Operation(
      operationId = "checkActivity",
      summary = "Checks the files of an activity without storing them",
      requestBody =
          @io.swagger.v3.oas.annotations.parameters.RequestBody(
              required = true,
              content =
                  @Content(mediaType = ZIP, schema = @Schema(type = "string", format = "binary"))))
  CheckView check(@Parameter(hidden = true) HttpServletRequest request) throws IOException {
    return uploads.unpack(request, files -> CheckView.of(files, activities));
  }
}
