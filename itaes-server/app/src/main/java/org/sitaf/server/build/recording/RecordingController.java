package org.sitaf.server.build.recording;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Content;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.responses.ApiResponse;
import io.swagger.v3.oas.annotations.tags.Tag;
import jakarta.servlet.http.HttpServletResponse;
import java.time.Instant;
import org.sitaf.server.web.Listing;
import org.springframework.core.io.ByteArrayResource;
import org.springframework.core.io.Resource;
import org.springframework.data.domain.Sort;
import org.springframework.http.HttpHeaders;
import org.springframework.http.MediaType;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1/builds/{id}/recordings")
@Tag(name = "recordings")
class RecordingController {
  private static final String GLB = "model/gltf-binary";

  private final Recordings recordings;

  RecordingController(Recordings recordings) {
    this.recordings = recordings;
  }

  @Schema(name = "Recording", description = "the recording of a case of a build")
  record RecordingView(
      @Schema(description = "from 1") int caseNo,
      @Schema(description = "of the binary glTF, in hexadecimal") String sha256,
      @Schema(description = "in bytes") long size,
      Instant received) {
    static RecordingView of(Recording recording) {
      return new RecordingView(
          recording.caseNo(), recording.sha256(), recording.size(), recording.received());
    }
  }

  @GetMapping
  @Operation(
      operationId = "listRecordings",
      summary = "Lists the recordings of a build",
      description =
          "A recording is available when its case has finished, while the build is still running."
              + " NEWEST lists the newest first.")
  Listing<RecordingView> list(
      @PathVariable String id,
      @RequestParam(defaultValue = "CASE") Recordings.Order order,
      @RequestParam(defaultValue = "0") int page,
      @RequestParam(defaultValue = "50") int size) {
    return Listing.of(
        recordings.of(id, order, Listing.request(page, size, Sort.unsorted())), RecordingView::of);
  }

  @GetMapping(path = "/{caseNo}", produces = GLB)
  @Operation(
      operationId = "getRecording",
      summary = "Downloads the recording of a case as binary glTF 2.0",
      description =
          "The file contains the solids, an animation over the simulation time in seconds, and the"
              + " readings of the devices at these times in the scene's extras. Range requests are"
              + " supported.")
  @ApiResponse(
      responseCode = "200",
      content = @Content(mediaType = GLB, schema = @Schema(type = "string", format = "binary")))
  ResponseEntity<Resource> get(
      @PathVariable String id, @PathVariable int caseNo, HttpServletResponse response) {
    return glb(recordings.find(id, caseNo), response);
  }

  @GetMapping(path = "/{caseNo}/relations/{relation}", produces = GLB)
  @Operation(
      operationId = "getSecondRunRecording",
      summary = "Downloads the recording of the second run of a case for a relation",
      description =
          "The number of the relation is its place in the test model, from 1. The second runs of a"
              + " case are recorded together with the case.")
  @ApiResponse(
      responseCode = "200",
      content = @Content(mediaType = GLB, schema = @Schema(type = "string", format = "binary")))
  ResponseEntity<Resource> getSecondRun(
      @PathVariable String id,
      @PathVariable int caseNo,
      @PathVariable int relation,
      HttpServletResponse response) {
    return glb(recordings.findSecondRun(id, caseNo, relation), response);
  }

  private ResponseEntity<Resource> glb(Recording recording, HttpServletResponse response) {
    // Browsers may store the file, but have to revalidate it.
    response.setHeader(HttpHeaders.CACHE_CONTROL, "private, no-cache");
    return ResponseEntity.ok()
        .contentType(MediaType.parseMediaType(GLB))
        .eTag("\"" + recording.sha256() + "\"")
        .body(new ByteArrayResource(recordings.content(recording)));
  }
}
