package org.sitaf.server.web;

import io.swagger.v3.core.converter.AnnotatedType;
import io.swagger.v3.core.converter.ModelConverter;
import io.swagger.v3.core.converter.ModelConverterContext;
import io.swagger.v3.core.util.Json;
import io.swagger.v3.oas.models.media.Schema;
import java.lang.reflect.RecordComponent;
import java.util.Iterator;
import org.jspecify.annotations.Nullable;
import org.springframework.context.annotation.Lazy;
import org.springframework.stereotype.Component;

/**
 * Marks record components that are not {@link Nullable} as required properties in the OpenAPI
 * document.
 */
@Component
@Lazy
class RequiredComponents implements ModelConverter {
  private static final String REFERENCE = "#/components/schemas/";

  @Override
  public @Nullable Schema<?> resolve(
      AnnotatedType type, ModelConverterContext context, Iterator<ModelConverter> chain) {
    if (!chain.hasNext()) {
      return null;
    }
    Schema<?> resolved = chain.next().resolve(type, context, chain);
    Class<?> raw = Json.mapper().constructType(type.getType()).getRawClass();
    if (resolved != null && raw.isRecord()) {
      Schema<?> model =
          resolved.get$ref() == null
              ? resolved
              : context.getDefinedModels().get(resolved.get$ref().substring(REFERENCE.length()));
      if (model != null && model.getProperties() != null) {
        require(raw.getRecordComponents(), model);
      }
    }
    return resolved;
  }

  private static void require(RecordComponent[] components, Schema<?> model) {
    for (RecordComponent component : components) {
      String name = component.getName();
      boolean nullable = component.getAnnotatedType().isAnnotationPresent(Nullable.class);
      boolean known = model.getRequired() != null && model.getRequired().contains(name);
      if (!nullable && !known && model.getProperties().containsKey(name)) {
        model.addRequiredItem(name);
      }
    }
  }
}
