package org.sitaf.core.model.document;

import static org.sitaf.core.model.document.Problems.number;

import java.time.Duration;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.core.model.Target;
import org.sitaf.schemas.SequenceCallType;
import org.sitaf.schemas.TargetType;

/** Reads the method under test. */
final class TargetReader {
  private final Problems problems;

  TargetReader(Problems problems) {
    this.problems = problems;
  }

  /** The target of a model; without one, its name is the method. */
  Target read(@Nullable TargetType target, String modelName) {
    if (target == null) {
      return new Target(null, modelName, null, Duration.ZERO, Duration.ZERO);
    }
    int line = XmlDocuments.line(target);
    return new Target(
        target.getInterface(),
        target.getMethod() == null ? modelName : target.getMethod(),
        target.getSignature(),
        seconds(target.getSettle(), "target/settle", line),
        seconds(target.getRunFor(), "target/run_for", line));
  }

  /** The target of a call in a sequence. */
  Target read(SequenceCallType call, @Nullable String interfaceName, String name) {
    int line = XmlDocuments.line(call);
    return new Target(
        interfaceName,
        call.getMethod() == null ? name : call.getMethod(),
        call.getSignature(),
        seconds(call.getSettle(), "call " + name + "/settle", line),
        seconds(call.getRunFor(), "call " + name + "/run_for", line));
  }

  private Duration seconds(@Nullable String text, String where, int line) {
    return problems
        .attempt(
            line,
            where,
            () -> {
              double seconds = number(text);
              if (seconds < 0 || seconds > 1e6) {
                throw new IllegalArgumentException("must be 0 to 1000000 seconds");
              }
              return Duration.ofNanos(Math.round(seconds * 1e9));
            })
        .orElse(Duration.ZERO);
  }
}
