package org.sitaf.server.preview;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.media.Content;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.parameters.RequestBody;
import io.swagger.v3.oas.annotations.tags.Tag;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.io.InputStream;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.web.Requests;
import org.springframework.http.MediaType;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1/activities/{id}/model-previews")
@Tag(name = "activities")
class PreviewController {
  private final Previews previews;
  private final Requests requests;

  PreviewController(Previews previews, Requests requests) {
    this.previews = previews;
    this.requests = requests;
  }

  @PostMapping(consumes = MediaType.APPLICATION_XML_VALUE)
  @Operation(
      operationId = "previewModel",
      summary = "Previews the values and cases of a test model without storing it",
      requestBody =
          @RequestBody(
              required = true,
              content =
                  @Content(
                      mediaType = MediaType.APPLICATION_XML_VALUE,
                      schema = @Schema(type = "string"))))
  PreviewView preview(
      @PathVariable String id,
      @RequestParam(defaultValue = "false") boolean cases,
      @RequestParam(defaultValue = "1") long seed,
      @Parameter(hidden = true) HttpServletRequest request,
      @Parameter(hidden = true) HttpServletResponse response)
      throws IOException {
    byte[] draft;
    try (InputStream body = requests.body(request)) {
      draft = body.readAllBytes();
    }
    try {
      return previews.preview(id, draft, cases, seed, () -> write(response));
    } catch (RequestException e) {
      if (!response.isCommitted()) {
        throw e;
      }
      return Previews.failed(e);
    }
  }

  /**
   * Writes a space, which JSON allows before the value. This fails if the client has disconnected,
   * which a servlet container does not report otherwise.
   */
  private static void write(HttpServletResponse response) {
    try {
      response.setContentType(MediaType.APPLICATION_JSON_VALUE);
      response.getOutputStream().write(' ');
      response.flushBuffer();
    } catch (IOException e) {
      throw RequestException.busy("The client has disconnected.");
    }
  }
}
