package org.sitaf.server.activity;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.media.Content;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import jakarta.servlet.http.HttpServletRequest;
import java.io.IOException;
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.web.Requests;
import org.sitaf.server.web.Uploads;
import org.springframework.http.HttpHeaders;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PatchMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestHeader;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RestController;

/** What a person needs who writes an activity, besides storing it. */
@RestController
@RequestMapping("/api/v1")
@Tag(name = "activities")
class AuthoringController {
  private static final String ZIP = "application/zip";

  private final Workspaces workspaces;
  private final Uploads uploads;

  AuthoringController(Workspaces workspaces, Uploads uploads) {
    this.workspaces = workspaces;
    this.uploads = uploads;
  }

  @GetMapping("/activities/{id}/description")
  @Operation(
      operationId = "describeActivity",
      summary = "Interfaces with their types resolved, and what the world lets a test vary")
  DescriptionView description(@PathVariable String id) {
    return DescriptionView.of(workspaces.activity(id));
  }

  @PatchMapping("/activities/{id}/files")
  @Operation(
      operationId = "changeFiles",
      summary = "Changes several files of an activity at once",
      description = "Nothing is changed when the activity would not hold together.")
  ActivityView changeFiles(
      @PathVariable String id,
      @RequestHeader(HttpHeaders.IF_MATCH) String ifMatch,
      @RequestBody FileChanges changes) {
    if (changes.changes() == null) {
      throw Refusal.malformed("changes is missing; it lists the files to change.");
    }
    workspaces.change(id, changes, Requests.expected(ifMatch));
    return workspaces.inspect(id, ActivityView::of);
  }

  @PostMapping(path = "/activity-checks", consumes = ZIP)
  @Operation(
      operationId = "checkActivity",
      summary = "Whether files would make an activity; nothing is stored",
      requestBody =
          @io.swagger.v3.oas.annotations.parameters.RequestBody(
              required = true,
              content =
                  @Content(mediaType = ZIP, schema = @Schema(type = "string", format = "binary"))))
  CheckView check(@Parameter(hidden = true) HttpServletRequest request) throws IOException {
    return uploads.unpack(request, CheckView::of);
  }
}
