package org.sitaf.server.git.source;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import org.jspecify.annotations.Nullable;

/** A Git source in the REST interface, without its secrets. */
@Schema(name = "GitSource")
record SourceView(
    String activityId,
    String url,
    String branch,
    @Schema(description = "of activity.yaml in the repository; empty for its root") String folder,
    GitSource.CredentialKind credential,
    @Schema(description = "of the token; absent for other credentials") @Nullable String user,
    @Schema(description = "fingerprint of the ssh host's key; absent before the first connection")
        @Nullable String hostKey,
    GitSource.Policy policy,
    int intervalS,
    @Schema(description = "increases with each change; for If-Match") long version,
    @Schema(description = "newest commit that was read; absent before the first one")
        @Nullable String head,
    @Schema(description = "when the branch was last fetched without a problem")
        @Nullable Instant fetched,
    @Schema(description = "why the last fetch failed, and what to do; absent if it did not")
        @Nullable String problem,
    @Nullable Instant problemSince,
    @Schema(description = "where statuses of commits are sent") Forge forge,
    @Nullable String apiUrl,
    @Schema(description = "path of the repository at the forge") @Nullable String project,
    @Schema(description = "whether a token for the forge's interface is stored")
        boolean hasForgeToken,
    @Schema(description = "whether the forge's messages are accepted") boolean hasHook) {
  static SourceView of(GitSource source) {
    ForgeProject project = source.project();
    return new SourceView(
        source.activityId(),
        source.url(),
        source.branch(),
        source.folder(),
        source.credentialKind(),
        source.credentialUser().isEmpty() ? null : source.credentialUser(),
        source.hostKey(),
        source.policy(),
        source.intervalS(),
        source.version(),
        source.head(),
        source.fetched(),
        source.problem(),
        source.problemSince(),
        project == null ? Forge.NONE : project.forge(),
        project == null ? null : project.api(),
        project == null ? null : project.path(),
        source.encryptedForgeSecret() != null,
        source.encryptedHookSecret() != null);
  }
}
