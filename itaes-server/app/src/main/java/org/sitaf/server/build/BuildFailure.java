package org.sitaf.server.build;

import jakarta.persistence.Embeddable;
import java.util.List;
import java.util.Objects;

/** Why a build has no result. */
public record BuildFailure(Category category, String message, List<SourceProblem> problems) {
  private static final int MAX_MESSAGE = 4000;
  private static final int MAX_PROBLEMS = 500;

  /** Whose matter it is. */
  public enum Category {
    /** The activity, model and suite do not make a test application. */
    INPUT,
    /** The component, its adapter or the harness do not compile; trying again gives the same. */
    COMPILATION,
    /** Agent, simulation or network; another attempt may succeed. */
    INFRASTRUCTURE
  }

  public BuildFailure {
    Objects.requireNonNull(category);
    message = cut(message, MAX_MESSAGE);
    problems = problems.stream().limit(MAX_PROBLEMS).toList();
  }

  /** A text of at most so many characters, and without the one that PostgreSQL cannot store. */
  static String cut(String text, int length) {
    String clean = text.replace('\0', ' ');
    return clean.length() <= length ? clean : clean.substring(0, length - 1) + "…";
  }

  /**
   * What is wrong with a file of a test application.
   *
   * @param line from 1; 0 where unknown
   * @param columnNo from 1; 0 where unknown
   * @param isGenerated whether the file was generated, not written by the user
   */
  @Embeddable
  public record SourceProblem(
      String file, int line, int columnNo, String message, boolean isGenerated) {
    private static final int MAX_FILE = 1000;
    private static final int MAX_MESSAGE = 4000;

    public SourceProblem {
      file = cut(file, MAX_FILE);
      message = cut(message, MAX_MESSAGE);
    }
  }
}
