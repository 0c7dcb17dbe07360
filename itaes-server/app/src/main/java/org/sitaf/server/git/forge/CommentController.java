package org.sitaf.server.git.forge;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.tags.Tag;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.git.commit.CommitRows;
import org.sitaf.server.git.source.GitSource;
import org.sitaf.server.git.source.GitSources;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1/activities/{id}/git/commits/{sha}")
@Tag(name = "git")
class CommentController {
  private final GitSources sources;
  private final CommitRows commits;
  private final StatusTexts texts;

  CommentController(GitSources sources, CommitRows commits, StatusTexts texts) {
    this.sources = sources;
    this.commits = commits;
    this.texts = texts;
  }

  @GetMapping(path = "/comment", produces = "text/markdown")
  @Operation(
      operationId = "getGitComment",
      summary = "Returns a comment on a commit with the groups of differences",
      description = "Markdown of at most 60 lines, for a pull or merge request.")
  String comment(@PathVariable String id, @PathVariable String sha) {
    GitSource source = sources.require(id);
    return commits
        .find(source.id(), sha)
        .map(commit -> texts.comment(source, commit))
        .orElseThrow(() -> RequestException.notFound("commit", sha));
  }
}
