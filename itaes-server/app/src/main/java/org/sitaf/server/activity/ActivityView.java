package org.sitaf.server.activity;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** An activity in the REST interface. */
@Schema(name = "Activity")
record ActivityView(
    String id,
    String name,
    String description,
    @Schema(description = "java, cpp or python") String language,
    String componentClass,
    Instant created,
    Instant updated,
    @Schema(description = "increases with each change; for If-Match") long version,
    List<FileView> files,
    List<ModelView> models,
    List<InterfaceView> interfaces,
    @Schema(description = "in ascending order") List<String> tags) {

  @Schema(name = "ActivityFile")
  record FileView(String path, @Schema(description = "in bytes") long size, String sha256) {}

  @Schema(name = "ActivityModel")
  record ModelView(
      String name,
      @Schema(description = "of its document") String path,
      @Nullable String interfaceName,
      String method) {}

  @Schema(name = "ActivityInterface")
  record InterfaceView(String name, Usage usage, List<String> methods) {}

  /** Whether the component implements or calls the interface. */
  enum Usage {
    provided,
    required
  }

  static ActivityView of(StoredActivity activity) {
    return new ActivityView(
        activity.id(),
        activity.name(),
        activity.description(),
        activity.language(),
        activity.componentClass(),
        activity.created(),
        activity.updated(),
        activity.version(),
        activity.files().stream().map(f -> new FileView(f.path(), f.size(), f.sha256())).toList(),
        activity.models().stream()
            .map(m -> new ModelView(m.name(), m.path(), m.interfaceName(), m.method()))
            .toList(),
        interfaces(activity.methods()),
        activity.tags());
  }

  private static List<InterfaceView> interfaces(List<StoredMethod> methods) {
    Map<String, InterfaceView> interfaces = new LinkedHashMap<>();
    for (StoredMethod method : methods) {
      Usage usage = method.required() ? Usage.required : Usage.provided;
      interfaces
          .computeIfAbsent(
              usage + " " + method.interfaceName(),
              key -> new InterfaceView(method.interfaceName(), usage, new ArrayList<>()))
          .methods()
          .add(method.method());
    }
    return List.copyOf(interfaces.values());
  }
}
