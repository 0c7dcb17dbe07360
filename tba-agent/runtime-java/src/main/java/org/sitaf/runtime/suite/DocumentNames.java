package org.sitaf.runtime.suite;

import java.lang.reflect.AnnotatedElement;
import java.lang.reflect.RecordComponent;
import org.jspecify.annotations.Nullable;

/** The names of members and literals in documents. */
final class DocumentNames {
  private DocumentNames() {}

  /** The name of a record's component. */
  static String of(RecordComponent component) {
    return of(component.getName(), component);
  }

  /** The name of an enum's constant. */
  static String of(Enum<?> constant) {
    String name = constant.name();
    if (!isRenamed(name)) {
      return name;
    }
    try {
      return of(name, constant.getDeclaringClass().getField(name));
    } catch (NoSuchFieldException e) {
      throw new IllegalStateException(name + " has no field", e);
    }
  }

  private static String of(String name, AnnotatedElement declared) {
    @Nullable DocumentName documentName =
        isRenamed(name) ? declared.getAnnotation(DocumentName.class) : null;
    return documentName == null ? name : documentName.value();
  }

  /** Whether a name may be that of an annotated declaration; annotations are slow to read. */
  private static boolean isRenamed(String name) {
    return name.endsWith("_");
  }
}
