package org.sitaf.runtime.stub;

import org.sitaf.runtime.CannotRunException;

/**
 * Creates the exceptions that interfaces declare; their types are generated with the interfaces.
 */
final class DeclaredError {
  private static final String PACKAGE = "sitaf.interfaces.";

  private DeclaredError() {}

  static RuntimeException named(String name, String message) {
    try {
      ClassLoader loader = Thread.currentThread().getContextClassLoader();
      return Class.forName(PACKAGE + name, true, loader)
          .asSubclass(RuntimeException.class)
          .getConstructor(String.class)
          .newInstance(message);
    } catch (ReflectiveOperationException | ClassCastException e) {
      throw new CannotRunException(
          "the error "
              + name
              + " has no type "
              + PACKAGE
              + name
              + "; generate the test application again",
          e);
    }
  }
}
