package org.sitaf.agent.build;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.explain.Explanation;
import org.sitaf.core.flaky.FlakyCase;
import org.sitaf.core.score.SpecificationScore;
import org.sitaf.core.score.mutation.MutationScore;

/** What an analysis of a build found. */
public sealed interface AnalysisReport {
  /**
   * The causes of failures.
   *
   * @param records what a further execution of the simplest case of each cause gave, for bundles;
   *     empty for a cause that has none
   * @param further the cases that were executed beyond the suite
   */
  record Explained(
      Explanation explanation,
      List<Map<String, String>> records,
      List<Further> further,
      List<Input> inputs)
      implements AnalysisReport {
    public Explained {
      Objects.requireNonNull(explanation);
      records = List.copyOf(records);
      further = List.copyOf(further);
      inputs = List.copyOf(inputs);
    }
  }

  /**
   * The score of a specification.
   *
   * @param mutations score by mutations of the sources; null if there are no sources
   */
  record Scored(SpecificationScore score, @Nullable MutationScore mutations)
      implements AnalysisReport {
    public Scored {
      Objects.requireNonNull(score);
    }
  }

  /**
   * What repeated runs of the cases showed.
   *
   * @param runs number of further runs
   */
  record Repeated(int runs, List<FlakyCase> flaky) implements AnalysisReport {
    public Repeated {
      flaky = List.copyOf(flaky);
    }
  }

  /** A case that was executed beyond the suite: literals in the order of the inputs. */
  record Further(List<String> values, boolean failed) {
    public Further {
      values = List.copyOf(values);
    }
  }

  /**
   * An input of the model.
   *
   * @param values the literals of the suite, with their validity
   */
  record Input(String name, boolean numeric, Map<String, Boolean> values) {
    public Input {
      Objects.requireNonNull(name);
      values = java.util.Collections.unmodifiableMap(new LinkedHashMap<>(values));
    }
  }
}
