package org.sitaf.runtime.suite;

import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * The name that a member of a struct or a literal of an enumeration has in documents and results,
 * where Java does not allow it: the member {@code import} is the record component {@code import_}.
 */
@Retention(RetentionPolicy.RUNTIME)
@Target({ElementType.RECORD_COMPONENT, ElementType.FIELD})
public @interface DocumentName {
  /** The name in documents. */
  String value();
}
