package org.sitaf.server.proposal;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.media.Content;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.parameters.RequestBody;
import io.swagger.v3.oas.annotations.tags.Tag;
import jakarta.servlet.http.HttpServletRequest;
import java.io.IOException;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.FileTree;
import org.sitaf.server.web.Uploads;
import org.springframework.http.HttpHeaders;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1/activity-proposals")
@Tag(name = "activities")
class ProposalController {
  private static final String ZIP = "application/zip";

  private final Proposals proposals;
  private final Uploads uploads;

  ProposalController(Proposals proposals, Uploads uploads) {
    this.proposals = proposals;
    this.uploads = uploads;
  }

  @PostMapping(consumes = ZIP)
  @Operation(
      operationId = "proposeActivity",
      summary = "Proposes an activity that runs at once, without storing it",
      description =
          "The body is a zip of interface files, from which come test models and the skeleton of a"
              + " component, or with node a zip of a ROS 2 package, which is copied. It is empty for"
              + " an installed interface of ROS 2, and for a small interface to change.",
      requestBody =
          @RequestBody(
              content =
                  @Content(mediaType = ZIP, schema = @Schema(type = "string", format = "binary"))))
  ProposalView propose(
      @RequestParam String name,
      @Parameter(
              description =
                  "java, cpp or python; default: python, or for a package that of its node")
          @RequestParam(required = false)
          @Nullable String language,
      @Parameter(
              name = "class",
              description =
                  "of the component: package.Class, namespace::Class or module.Class; of a package"
                      + " that holds several nodes: one of them")
          @RequestParam(name = "class", required = false)
          @Nullable String className,
      @Parameter(
              name = "interface",
              description =
                  "path of an interface file in the zip, or of an installed one such as"
                      + " nav_msgs/srv/GetPlan.srv; default: the only one")
          @RequestParam(name = "interface", required = false)
          @Nullable String interfacePath,
      @Parameter(description = "folder of package.xml in the zip; . for the top")
          @RequestParam(required = false)
          @Nullable String node,
      @Parameter(hidden = true) HttpServletRequest request)
      throws IOException {
    ProposalRequest wanted =
        new ProposalRequest(
            name, ProposalRequest.language(language), className, interfacePath, node);
    return hasBody(request)
        ? uploads.unpackWhole(request, given -> proposals.propose(given, wanted))
        : proposals.propose(FileTree.of(Map.of()), wanted);
  }

  private static boolean hasBody(HttpServletRequest request) {
    return request.getContentLengthLong() > 0
        || request.getHeader(HttpHeaders.TRANSFER_ENCODING) != null;
  }
}
