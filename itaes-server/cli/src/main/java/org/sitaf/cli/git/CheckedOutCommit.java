package org.sitaf.cli.git;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;

/** The commit of a checkout that a folder belongs to. */
public final class CheckedOutCommit {
  private static final String HEAD = "HEAD";

  /** Says that the files are not those of the commit. */
  private static final String DIRTY = "-dirty";

  private CheckedOutCommit() {}

  /**
   * The id of the commit, with {@code -dirty} if the folder has other files there; empty if the
   * folder is in no Git repository with a commit.
   *
   * @param files of the folder
   */
  public static Optional<String> of(Path folder, FileTree files) {
    String commit;
    try (FolderRepository repository = FolderRepository.open(folder)) {
      commit = repository.commit(HEAD).name();
    } catch (InvalidInputException | IOException e) {
      return Optional.empty();
    }
    try {
      return Optional.of(GitFolder.read(folder, HEAD).equals(files) ? commit : commit + DIRTY);
    } catch (InvalidInputException e) {
      return Optional.of(commit + DIRTY);
    }
  }
}
