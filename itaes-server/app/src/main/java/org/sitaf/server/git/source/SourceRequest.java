package org.sitaf.server.git.source;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.Optional;
import org.eclipse.jgit.lib.Repository;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.FileTree;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.git.GitSettings;
import org.sitaf.server.git.remote.Credential;
import org.sitaf.server.git.remote.GitAddress;
import org.sitaf.server.git.remote.Remote;

/** Settings of a Git source in the REST interface. */
@Schema(name = "GitSourceRequest")
record SourceRequest(
    @Schema(description = "https://HOST/PATH, ssh://USER@HOST/PATH or USER@HOST:PATH") String url,
    String branch,
    @Schema(description = "of activity.yaml in the repository; default its root")
        @Nullable String folder,
    @Schema(description = "default NONE") GitSource.@Nullable CredentialKind credential,
    @Schema(description = "of the token; default oauth2") @Nullable String user,
    @Schema(
            description =
                "token, or private key in the format of OpenSSH; stored encrypted and never"
                    + " returned; absent to keep the stored one")
        @Nullable String secret,
    @Schema(description = "default LATEST") GitSource.@Nullable Policy policy,
    @Schema(description = "seconds between two looks for new commits; default 300")
        @Nullable Integer intervalS,
    @Schema(description = "accept another key of the ssh host") @Nullable Boolean forgetHostKey,
    @Schema(description = "where statuses of commits are sent; default NONE") @Nullable Forge forge,
    @Schema(description = "default: the usual one of the repository's host")
        @Nullable String apiUrl,
    @Schema(description = "default: the path of the repository, such as owner/name")
        @Nullable String project,
    @Schema(
            description =
                "token that may write statuses; stored encrypted and never returned; absent to"
                    + " keep the stored one, or to use the token of the repository")
        @Nullable String forgeToken) {
  private static final int MAX_BRANCH = 200;
  private static final int MAX_SECRET = 16_000;
  private static final int DEFAULT_INTERVAL_S = 300;
  private static final int MAX_INTERVAL_S = 86_400;
  private static final String DEFAULT_USER = "oauth2";

  GitAddress address(GitSettings settings) {
    if (url == null) {
      throw RequestException.malformed("url must be given.");
    }
    return GitAddress.parse(url.strip(), settings);
  }

  String checkedBranch() {
    if (branch == null
        || branch.length() > MAX_BRANCH
        || branch.startsWith("-")
        || !Repository.isValidRefName("refs/heads/" + branch)) {
      throw RequestException.malformed(
          "branch: must be the name of a branch, at most " + MAX_BRANCH + " characters.");
    }
    return branch;
  }

  String checkedFolder() {
    String plain = folder == null ? "" : folder.strip().replaceAll("^/+|/+$", "");
    try {
      return plain.isEmpty() || plain.equals(".") ? "" : FileTree.requireSafe(plain);
    } catch (IllegalArgumentException e) {
      throw RequestException.malformed("folder: " + e.getMessage() + ".");
    }
  }

  GitSource.CredentialKind kind() {
    return credential == null ? GitSource.CredentialKind.NONE : credential;
  }

  String checkedUser() {
    if (kind() != GitSource.CredentialKind.TOKEN) {
      return "";
    }
    String name = user == null || user.isBlank() ? DEFAULT_USER : user.strip();
    if (name.length() > MAX_BRANCH || name.chars().anyMatch(c -> c <= ' ' || c > '~' || c == ':')) {
      throw RequestException.malformed(
          "user: must be at most " + MAX_BRANCH + " printable ASCII characters without ':'.");
    }
    return name;
  }

  GitSource.Policy checkedPolicy() {
    return policy == null ? GitSource.Policy.LATEST : policy;
  }

  int checkedInterval(GitSettings settings) {
    long min = settings.minInterval().toSeconds();
    int seconds = intervalS == null ? DEFAULT_INTERVAL_S : intervalS;
    if (seconds < min || seconds > MAX_INTERVAL_S) {
      throw RequestException.malformed(
          "intervalS: must be " + min + " to " + MAX_INTERVAL_S + " seconds.");
    }
    return seconds;
  }

  @Nullable ForgeProject checkedProject(GitAddress address, GitSettings settings) {
    return forge == null || forge == Forge.NONE
        ? null
        : ForgeProject.of(forge, address, apiUrl, project, settings);
  }

  /**
   * The token for the forge's interface; empty to use the repository's.
   *
   * @param stored the token that is stored for the same interface
   */
  Optional<String> checkedForgeToken(
      @Nullable ForgeProject found, Credential credential, Optional<String> stored) {
    if (found == null) {
      return Optional.empty();
    }
    if (forgeToken != null && forgeToken.length() > MAX_SECRET) {
      throw RequestException.malformed(
          "forgeToken: must be at most " + MAX_SECRET + " characters.");
    }
    Optional<String> given =
        forgeToken == null || forgeToken.isBlank() ? stored : Optional.of(forgeToken.strip());
    if (given.isEmpty() && !(credential instanceof Credential.Token)) {
      throw RequestException.malformed(
          "forgeToken: must be given, since the repository is not read with a token.");
    }
    return given;
  }

  boolean forgetsHostKey() {
    return Boolean.TRUE.equals(forgetHostKey);
  }

  /**
   * The credential.
   *
   * @param stored the secret that is stored for the same host; empty if there is none
   */
  Credential checkedCredential(GitAddress address, Optional<String> stored) {
    Credential found =
        switch (kind()) {
          case NONE -> new Credential.None();
          case TOKEN -> new Credential.Token(checkedUser(), checkedSecret(stored));
          case DEPLOY_KEY -> new Credential.DeployKey(checkedSecret(stored));
        };
    Remote.requireUsable(address, found);
    return found;
  }

  private String checkedSecret(Optional<String> stored) {
    if (secret == null || secret.isBlank()) {
      return stored.orElseThrow(
          () ->
              RequestException.malformed(
                  "secret: must be given for this kind of credential and this host."));
    }
    if (secret.length() > MAX_SECRET) {
      throw RequestException.malformed("secret: must be at most " + MAX_SECRET + " characters.");
    }
    return kind() == GitSource.CredentialKind.TOKEN ? secret.strip() : secret;
  }
}
