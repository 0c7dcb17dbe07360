package org.sitaf.server.git.source;

import java.time.Instant;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * The folder of a Git branch that an activity comes from.
 *
 * @param folder of activity.yaml in the repository; empty for its root
 * @param credentialUser user name of a token; empty if it is not needed
 * @param encryptedSecret null if there is none
 * @param hostKey fingerprint of the key of an ssh host; null before the first connection
 * @param policy which commits are built
 * @param intervalS of polling
 * @param head the newest commit that was read; null before the first one
 * @param fetched when the branch was last fetched without a problem
 * @param problem why the last fetch failed
 * @param project where statuses are sent; null for nowhere
 * @param encryptedForgeSecret null to use the token of the repository
 * @param encryptedHookSecret signs the forge's messages; null before it was created
 */
public record GitSource(
    String id,
    String activityId,
    String url,
    String branch,
    String folder,
    CredentialKind credentialKind,
    String credentialUser,
    @Nullable String encryptedSecret,
    @Nullable String hostKey,
    Policy policy,
    int intervalS,
    long version,
    Instant created,
    @Nullable String head,
    @Nullable Instant fetched,
    @Nullable String problem,
    @Nullable Instant problemSince,
    @Nullable ForgeProject project,
    @Nullable String encryptedForgeSecret,
    @Nullable String encryptedHookSecret) {

  /** What the repository is read with. */
  public enum CredentialKind {
    NONE,
    TOKEN,
    DEPLOY_KEY
  }

  /** Which commits of a push are built. */
  public enum Policy {
    /** The newest one; the others are built when somebody asks for the first bad commit. */
    LATEST,
    /** Each one. */
    EVERY
  }

  /** Its reference in the server's copy and in the repository. */
  public String reference() {
    return "refs/heads/" + branch;
  }

  /** The newest commit that was read. */
  public Optional<String> headCommit() {
    return Optional.ofNullable(head);
  }
}
