package org.sitaf.core.expression.type;

import java.util.Optional;
import java.util.Set;

/** The names that an expression can use. */
public interface Names {
  /** The type of a name, which may contain dots; empty if there is no such name. */
  Optional<Type> find(String name);

  /** All names, for suggestions. */
  Set<String> all();
}
