package org.sitaf.server.git.request;

import java.util.Locale;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.git.remote.History;
import org.sitaf.server.git.source.Forge;
import org.sitaf.server.git.source.ForgeProject;
import org.sitaf.server.git.source.GitSource;

/**
 * A pull or merge request as a message of a forge describes it. Its texts come from anyone who can
 * open a request.
 *
 * @param number of the request at the forge
 * @param author who opened the request, or pushed to it
 * @param head id of its newest commit
 * @param repository path of the repository that it is to be merged into, such as {@code owner/name}
 * @param branch that it is to be merged into
 * @param fork whether its commits come from another repository, or may come from one
 */
public record ReportedRequest(
    Forge forge,
    int number,
    String title,
    String author,
    String head,
    String repository,
    String branch,
    boolean fork,
    boolean open) {
  private static final Pattern SHA = Pattern.compile("[0-9a-f]{40}");

  public ReportedRequest {
    if (number <= 0) {
      throw RequestException.malformed(
          "The message has no positive number of the pull or merge request.");
    }
    head = requireSha("head of the message", head);
    title = History.shortened(title);
    author = History.shortened(author);
  }

  /** Rejects what is no id of a commit. */
  static String requireSha(String where, @Nullable String sha) {
    if (sha == null || !SHA.matcher(sha).matches()) {
      throw RequestException.malformed(
          where + ": must be the id of a commit, 40 lower-case hexadecimal digits.");
    }
    return sha;
  }

  /** Whether it is a request of the source's repository. */
  boolean concerns(GitSource source) {
    ForgeProject project = source.project();
    if (project != null) {
      return project.forge() == forge && project.path().equalsIgnoreCase(repository);
    }
    String url = source.url().replaceFirst("/+$", "").replaceFirst("\\.git$", "");
    String path = repository.toLowerCase(Locale.ROOT);
    return path.contains("/")
        && (url.toLowerCase(Locale.ROOT).endsWith("/" + path)
            || url.toLowerCase(Locale.ROOT).endsWith(":" + path));
  }
}
