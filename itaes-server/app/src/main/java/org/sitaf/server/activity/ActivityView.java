package org.sitaf.server.activity;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** A workspace as people and programs see it. */
@Schema(name = "Activity")
record ActivityView(
    String id,
    String name,
    String description,
    @Schema(description = "java, cpp or python") String language,
    String componentClass,
    Instant created,
    Instant updated,
    @Schema(description = "grows with each change; for If-Match") long version,
    List<FileView> files,
    List<ModelView> models,
    List<InterfaceView> interfaces) {

  @Schema(name = "ActivityFile")
  record FileView(String path, @Schema(description = "in bytes") long size, String sha256) {}

  @Schema(name = "ActivityModel")
  record ModelView(
      String name,
      @Schema(description = "of its document among the files") String path,
      @Nullable String interfaceName,
      String method) {}

  @Schema(name = "ActivityInterface")
  record InterfaceView(String name, Usage usage, List<String> methods) {}

  /** Who calls whom. */
  enum Usage {
    provided,
    required
  }

  static ActivityView of(Workspace workspace) {
    return new ActivityView(
        workspace.id(),
        workspace.name(),
        workspace.description(),
        workspace.language(),
        workspace.componentClass(),
        workspace.created(),
        workspace.updated(),
        workspace.version(),
        workspace.files().stream().map(f -> new FileView(f.path(), f.size(), f.sha256())).toList(),
        workspace.models().stream()
            .map(m -> new ModelView(m.name(), m.path(), m.interfaceName(), m.method()))
            .toList(),
        interfaces(workspace.methods()));
  }

  private static List<InterfaceView> interfaces(List<WorkspaceMethod> methods) {
    Map<String, InterfaceView> found = new LinkedHashMap<>();
    for (WorkspaceMethod method : methods) {
      Usage usage = method.required() ? Usage.required : Usage.provided;
      found
          .computeIfAbsent(
              usage + " " + method.interfaceName(),
              key -> new InterfaceView(method.interfaceName(), usage, new ArrayList<>()))
          .methods()
          .add(method.method());
    }
    return List.copyOf(found.values());
  }
}
