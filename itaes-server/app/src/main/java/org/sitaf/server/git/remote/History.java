package org.sitaf.server.git.remote;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.eclipse.jgit.lib.FileMode;
import org.eclipse.jgit.lib.ObjectId;
import org.eclipse.jgit.lib.ObjectReader;
import org.eclipse.jgit.revwalk.RevCommit;
import org.eclipse.jgit.revwalk.RevWalk;
import org.eclipse.jgit.revwalk.filter.RevFilter;
import org.eclipse.jgit.treewalk.TreeWalk;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.git.CommittedFiles;

/** Commits of the server's copy of a repository. */
public final class History implements AutoCloseable {
  private static final int MAX_TEXT = 200;
  private static final int SHORT = 10;

  private final LimitedRepository repository;

  private History(LimitedRepository repository) {
    this.repository = repository;
  }

  /**
   * Opens a copy.
   *
   * @param folder of the copy
   */
  public static History open(Path folder) throws IOException {
    return new History(LimitedRepository.open(folder));
  }

  /** A commit. */
  public record Commit(String id, String subject, String author, Instant time) {}

  /** The commits of a branch after a known one. */
  public record Line(List<Commit> commits, Optional<String> known) {
    public Line {
      commits = List.copyOf(commits);
    }
  }

  /** The commit of a fetched reference. */
  public Optional<String> resolve(String reference) throws IOException {
    ObjectId found = repository.resolve(reference + "^{commit}");
    return Optional.ofNullable(found).map(ObjectId::name);
  }

  /**
   * Follows the first parents from a commit.
   *
   * @param known where it ends
   * @param max number of commits
   * @return the oldest first; without a known commit if none was found
   */
  public Line line(String from, Set<String> known, int max) throws IOException {
    List<Commit> commits = new ArrayList<>();
    Optional<String> found = Optional.empty();
    try (RevWalk walk = new RevWalk(repository)) {
      RevCommit commit = walk.parseCommit(ObjectId.fromString(from));
      while (commits.size() < max) {
        if (known.contains(commit.name())) {
          found = Optional.of(commit.name());
          break;
        }
        commits.add(of(commit));
        if (commit.getParentCount() == 0) {
          break;
        }
        commit = walk.parseCommit(commit.getParent(0));
      }
    }
    Collections.reverse(commits);
    return new Line(commits, found);
  }

  /** Whether the copy has a commit. */
  public boolean contains(String commit) throws IOException {
    return repository.getObjectDatabase().has(ObjectId.fromString(commit));
  }

  /** A commit by its id. */
  public Commit commit(String id) throws IOException {
    try (RevWalk walk = new RevWalk(repository)) {
      return of(walk.parseCommit(ObjectId.fromString(id)));
    }
  }

  /** The commit that two commits have in common. */
  public Optional<Commit> mergeBase(String one, String other) throws IOException {
    if (one.equals(other)) {
      return Optional.of(commit(one));
    }
    ObjectId base;
    try (RevWalk walk = new RevWalk(repository)) {
      walk.setRevFilter(RevFilter.MERGE_BASE);
      walk.markStart(walk.parseCommit(ObjectId.fromString(one)));
      walk.markStart(walk.parseCommit(ObjectId.fromString(other)));
      base = walk.next();
    }
    // The first walk has changed what it knows of the commit.
    return base == null ? Optional.empty() : Optional.of(commit(base.name()));
  }

  /**
   * The files of a folder.
   *
   * @param folder empty for the whole repository
   * @throws InvalidInputException if it does not exist or cannot be an activity
   */
  public FileTree files(String commit, String folder) throws IOException {
    String name = folder + "@" + commit.substring(0, SHORT);
    try (RevWalk walk = new RevWalk(repository);
        ObjectReader objects = repository.newObjectReader()) {
      ObjectId tree = walk.parseCommit(ObjectId.fromString(commit)).getTree();
      if (!folder.isEmpty()) {
        try (TreeWalk found = TreeWalk.forPath(objects, folder, tree)) {
          if (found == null || !FileMode.TREE.equals(found.getRawMode(0))) {
            throw InvalidInputException.of(
                name, "the folder does not exist in this commit; set the folder of activity.yaml");
          }
          tree = found.getObjectId(0);
        }
      }
      FileTree files = CommittedFiles.read(objects, tree, name);
      if (!files.contains("activity.yaml")) {
        throw InvalidInputException.of(
            name, "holds no activity.yaml; set the folder of the activity, or add the file");
      }
      return files;
    }
  }

  private static Commit of(RevCommit commit) {
    return new Commit(
        commit.getName(),
        shortened(commit.getShortMessage()),
        shortened(commit.getAuthorIdent() == null ? "" : commit.getAuthorIdent().getName()),
        Instant.ofEpochSecond(commit.getCommitTime()));
  }

  /** A text that comes from anyone, without control characters and not too long. */
  public static String shortened(String text) {
    String plain = text.replaceAll("[\\p{Cc}\\p{Cf}\\p{Cs}]", " ");
    if (plain.length() <= MAX_TEXT) {
      return plain;
    }
    int end = MAX_TEXT - 1;
    return plain.substring(0, Character.isHighSurrogate(plain.charAt(end - 1)) ? end - 1 : end)
        + "…";
  }

  @Override
  public void close() {
    repository.close();
  }
}
