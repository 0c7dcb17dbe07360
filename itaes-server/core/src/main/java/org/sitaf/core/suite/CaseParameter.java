package org.sitaf.core.suite;

import java.util.Objects;
import org.sitaf.core.model.InputKind;

/** A parameter of test cases: describes the values at one position of every case. */
public record CaseParameter(String name, InputKind kind, String realType) {
  public CaseParameter {
    Objects.requireNonNull(name);
    Objects.requireNonNull(kind);
    Objects.requireNonNull(realType);
  }
}
