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
import org.sitaf.core.description.fault.DeviceFaults;
import org.sitaf.core.description.fault.FaultKind;
import org.sitaf.server.web.DiagnosticView;

/** The interfaces and the world of an activity, for editors of test models. */
@Schema(name = "ActivityDescription")
record DescriptionView(
    List<InterfaceTree> provided,
    @Schema(description = "implemented by the test stub") List<InterfaceTree> required,
    @Schema(description = "absent if the activity has no simulation") @Nullable World world,
    @Schema(description = "problems that do not prevent using the activity")
        List<DiagnosticView> warnings) {

  @Schema(name = "InterfaceTree")
  record InterfaceTree(
      String name,
      @Schema(description = "document that declares it") String source,
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
      @Schema(description = "types of the parameters; distinguishes overloads") String signature,
      CallType callType,
      TypeTree returnType,
      List<ParameterTree> parameters,
      @Schema(description = "names of the declared exceptions") List<String> raises,
      @Schema(description = "from 1; 0 if unknown") int line) {
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
      @Schema(
              description =
                  "members of a struct, or the element type of a sequence or array, named []")
          List<MemberTree> members,
      @Schema(description = "literals of an enumeration") List<String> literals) {
    static TypeTree of(DataType type) {
      if (type instanceof DataType.Struct struct) {
        List<MemberTree> members =
            struct.members().stream().map(m -> new MemberTree(m.name(), of(m.type()))).toList();
        return new TypeTree(type.typeName(), Kind.struct, members, List.of());
      }
      if (type instanceof DataType.Enumeration enumeration) {
        return new TypeTree(type.typeName(), Kind.enumeration, List.of(), enumeration.literals());
      }
      Kind kind =
          type instanceof DataType.Sequence
              ? Kind.sequence
              : type instanceof DataType.FixedArray
                  ? Kind.array
                  : type instanceof DataType.Unknown ? Kind.unknown : Kind.scalar;
      List<MemberTree> elements =
          type.parts().stream().map(part -> new MemberTree("[]", of(part))).toList();
      return new TypeTree(type.typeName(), kind, elements, List.of());
    }
  }

  @Schema(name = "MemberTree")
  record MemberTree(String name, TypeTree type) {}

  @Schema(name = "World")
  record World(
      @Schema(description = "of its description") String path,
      List<WorldParameter> parameters,
      List<WorldDevice> devices,
      @Schema(description = "possible names of outputs of type OBSERVED")
          List<String> observations) {
    static World of(WorldDescription world) {
      return new World(
          world.path(),
          world.parameters().stream()
              .map(p -> new WorldParameter(p.name(), p.unit(), p.min(), p.max(), p.defaultValue()))
              .toList(),
          world.devices().stream()
              .map(
                  d ->
                      new WorldDevice(
                          d.name(),
                          d.kind(),
                          DeviceFaults.of(d.kind()).stream().map(FaultKind::text).toList()))
              .toList(),
          world.observations());
    }
  }

  @Schema(name = "WorldParameter", description = "a parameter of the simulation (TDSD)")
  record WorldParameter(
      String name,
      @Schema(description = "SI unit; 1 if dimensionless") String unit,
      @Schema(description = "inclusive") double min,
      @Schema(description = "inclusive") double max,
      double defaultValue) {}

  @Schema(name = "WorldDevice")
  record WorldDevice(
      String name,
      String kind,
      @Schema(description = "kinds of faults that a test can set as fault.NAME.KIND")
          List<String> faults) {}

  static DescriptionView of(Activity activity) {
    return new DescriptionView(
        activity.provided().stream().map(InterfaceTree::of).toList(),
        activity.required().stream().map(InterfaceTree::of).toList(),
        activity.world() == null ? null : World.of(activity.world()),
        activity.warnings().stream().map(DiagnosticView::of).toList());
  }
}
