package org.sitaf.server.build;

import jakarta.persistence.Embeddable;
import java.util.List;
import java.util.Objects;

/** Why a build has no result. */
public record BuildFailure(Category category, String message, List<SourceProblem> problems) {
  private static final int MAX_MESSAGE = 4000;
  private static final int MAX_PROBLEMS = 500;

  public enum Category {
    /** The test application could not be generated from activity, model and suite. */
    INPUT,
    /** The component, its adapter or the harness do not compile; the build is not retried. */
    COMPILATION,
    /** Agent, simulation or network failed; the build is retried. */
    INFRASTRUCTURE
  }

  public BuildFailure {
    Objects.requireNonNull(category);
    message = cut(message, MAX_MESSAGE);
    problems = problems.stream().limit(MAX_PROBLEMS).toList();
  }

  /** Limits the length of a text and replaces NUL characters, which PostgreSQL cannot store. */
  static String cut(String text, int length) {
    String clean = text.replace('\0', ' ');
    return clean.length() <= length ? clean : clean.substring(0, length - 1) + "…";
  }

  /**
   * A problem in a file of a test application.
   *
   * @param line from 1; 0 if unknown
   * @param columnNo from 1; 0 if unknown
   * @param isGenerated whether the file was generated
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
