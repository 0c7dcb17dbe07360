package org.sitaf.cli.git;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.eclipse.jgit.errors.MissingObjectException;
import org.eclipse.jgit.lib.ObjectId;
import org.eclipse.jgit.revwalk.RevCommit;
import org.eclipse.jgit.revwalk.RevSort;
import org.eclipse.jgit.revwalk.RevWalk;
import org.sitaf.core.diagnostic.InvalidInputException;

/**
 * The commits between two revisions that change a folder, the oldest first.
 *
 * @param good the commit that the history begins after
 * @param commits the last one has the folder of the bad revision
 */
public record FolderHistory(String good, List<Commit> commits) {
  private static final int MAX_COMMITS = 100_000;

  public FolderHistory {
    commits = List.copyOf(commits);
  }

  /**
   * A commit.
   *
   * @param parents indices of the commits of this history that it is based on directly
   */
  public record Commit(
      String id, String subject, String author, Instant time, List<Integer> parents) {
    private static final int SHORT = 10;

    public Commit {
      parents = List.copyOf(parents);
    }

    /** The beginning of the id. */
    public String shortId() {
      return id.substring(0, SHORT);
    }
  }

  /**
   * Reads the commits that are reachable from the bad revision and not from the good one, without
   * those whose folder is the same as in a parent.
   *
   * @throws InvalidInputException if there is no repository, revision or commit
   */
  public static FolderHistory read(Path folder, String good, String bad) {
    try (FolderRepository repository = FolderRepository.open(folder)) {
      RevCommit first = repository.commit(good);
      RevCommit last = repository.commit(bad);
      FolderHistory history =
          new FolderHistory(first.getName(), new Reading(repository).commits(first, last));
      if (history.commits().isEmpty()) {
        throw InvalidInputException.of(
            folder.toString(),
            "does not differ between "
                + good
                + " and "
                + bad
                + ", or "
                + bad
                + " is not based on a change of it");
      }
      return history;
    } catch (MissingObjectException e) {
      throw InvalidInputException.of(
          folder.toString(),
          "the history is incomplete; fetch it with 'git fetch --unshallow': " + e.getMessage());
    } catch (IOException e) {
      throw InvalidInputException.of(folder.toString(), "cannot be read: " + e.getMessage());
    }
  }

  private static final class Reading {
    private final FolderRepository repository;
    private final List<Commit> commits = new ArrayList<>();

    /** For each commit, the index of the commit that last changed the folder. */
    private final Map<ObjectId, Integer> origins = new HashMap<>();

    Reading(FolderRepository repository) {
      this.repository = repository;
    }

    List<Commit> commits(RevCommit good, RevCommit bad) throws IOException {
      try (RevWalk walk = new RevWalk(repository.objects())) {
        walk.markStart(walk.parseCommit(bad));
        walk.markUninteresting(walk.parseCommit(good));
        walk.sort(RevSort.TOPO);
        walk.sort(RevSort.REVERSE, true);
        for (RevCommit commit : walk) {
          add(commit, walk);
        }
      }
      Integer last = origins.get(bad.getId());
      return last == null ? List.of() : commits.subList(0, last + 1);
    }

    private void add(RevCommit commit, RevWalk walk) throws IOException {
      ObjectId tree = repository.folderIn(commit.getTree());
      Set<Integer> based = new LinkedHashSet<>();
      for (RevCommit parent : commit.getParents()) {
        Integer origin = origins.get(parent.getId());
        if (Objects.equals(tree, repository.folderIn(walk.parseCommit(parent).getTree()))) {
          if (origin != null) {
            origins.put(commit.getId(), origin);
          }
          return;
        }
        if (origin != null) {
          based.add(origin);
        }
      }
      if (commits.size() >= MAX_COMMITS) {
        throw InvalidInputException.of(
            repository.path(), "has more than " + MAX_COMMITS + " commits in between");
      }
      commits.add(commit(commit, based));
      origins.put(commit.getId(), commits.size() - 1);
    }

    private static Commit commit(RevCommit commit, Set<Integer> parents) {
      return new Commit(
          commit.getName(),
          commit.getShortMessage(),
          commit.getAuthorIdent().getName(),
          Instant.ofEpochSecond(commit.getCommitTime()),
          List.copyOf(parents));
    }
  }
}
