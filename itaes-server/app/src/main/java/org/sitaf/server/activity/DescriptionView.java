package org.sitaf.server.activity;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.description.CallType;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.server.web.DiagnosticView;

/** What a test of an activity's component can call, vary and observe. */
@Schema(name = "ActivityDescription")
record DescriptionView(
    List<InterfaceTree> provided,
    @Schema(description = "that the stub implements") List<InterfaceTree> required,
    @Schema(description = "absent where the component needs no simulation") @Nullable World world,
    @Schema(description = "what was found and does not keep the activity from being used")
        List<DiagnosticView> warnings) {

  @Schema(name = "InterfaceTree")
  record InterfaceTree(
      String name,
      @Schema(description = "document it was read from") String source,
      List<MethodTree> methods) {
    static InterfaceTree of(InterfaceDescription description) {
      return new InterfaceTree(
          description.name(),
          description.source(),
          description.methods().stream().map(MethodTree::of).toList());
    }
  }

  @Schema(name = "MethodTree")
  record MethodTree(
      String name,
      @Schema(description = "types of the parameters; tells overloads apart") String signature,
      CallType callType,
      TypeTree returnType,
      List<ParameterTree> parameters,
      @Schema(description = "names of the exceptions that it declares") List<String> raises,
      @Schema(description = "from 1; 0 where unknown") int line) {
    static MethodTree of(Method method) {
      return new MethodTree(
          method.name(),
          method.signature(),
          method.callType(),
          TypeTree.of(method.returnType()),
          method.parameters().stream().map(ParameterTree::of).toList(),
          method.raises(),
          method.line());
    }
  }

  @Schema(name = "ParameterTree")
  record ParameterTree(String name, Direction direction, TypeTree type) {
    static ParameterTree of(Parameter parameter) {
      return new ParameterTree(
          parameter.name(), parameter.direction(), TypeTree.of(parameter.type()));
    }
  }

  /** Which kind of type. */
  enum Kind {
    scalar,
    sequence,
    array,
    struct,
    enumeration,
    unknown
  }

  @Schema(name = "TypeTree")
  record TypeTree(
      String spelling,
      Kind kind,
      @Schema(description = "of a struct; the one element, named [], of a sequence or array")
          List<MemberTree> members,
      @Schema(description = "of an enumeration") List<String> literals) {
    static TypeTree of(DataType type) {
      if (type instanceof DataType.Struct struct) {
        List<MemberTree> members =
            struct.members().stream().map(m -> new MemberTree(m.name(), of(m.type()))).toList();
        return new TypeTree(type.spelling(), Kind.struct, members, List.of());
      }
      if (type instanceof DataType.Enumeration enumeration) {
        return new TypeTree(type.spelling(), Kind.enumeration, List.of(), enumeration.literals());
      }
      Kind kind =
          type instanceof DataType.Sequence
              ? Kind.sequence
              : type instanceof DataType.FixedArray
                  ? Kind.array
                  : type instanceof DataType.Unknown ? Kind.unknown : Kind.scalar;
      List<MemberTree> elements =
          type.parts().stream().map(part -> new MemberTree("[]", of(part))).toList();
      return new TypeTree(type.spelling(), kind, elements, List.of());
    }
  }

  @Schema(name = "MemberTree")
  record MemberTree(String name, TypeTree type) {}

  @Schema(name = "World")
  record World(
      @Schema(description = "of its description among the files") String path,
      List<WorldParameter> parameters,
      List<WorldDevice> devices,
      @Schema(description = "names that an output of type OBSERVED may have")
          List<String> observations) {
    static World of(WorldDescription world) {
      return new World(
          world.path(),
          world.parameters().stream()
              .map(p -> new WorldParameter(p.name(), p.unit(), p.min(), p.max(), p.defaultValue()))
              .toList(),
          world.devices().stream().map(d -> new WorldDevice(d.name(), d.kind())).toList(),
          world.observations());
    }
  }

  @Schema(name = "WorldParameter", description = "what a test may vary in the simulation (TDSD)")
  record WorldParameter(
      String name,
      @Schema(description = "SI unit, 1 for a plain number") String unit,
      @Schema(description = "inclusive") double min,
      @Schema(description = "inclusive") double max,
      double defaultValue) {}

  @Schema(name = "WorldDevice")
  record WorldDevice(String name, String kind) {}

  static DescriptionView of(Activity activity) {
    return new DescriptionView(
        activity.provided().stream().map(InterfaceTree::of).toList(),
        activity.required().stream().map(InterfaceTree::of).toList(),
        activity.world() == null ? null : World.of(activity.world()),
        activity.warnings().stream().map(DiagnosticView::of).toList());
  }
}
