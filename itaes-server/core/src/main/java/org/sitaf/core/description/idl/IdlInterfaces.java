package org.sitaf.core.description.idl;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.sitaf.core.description.CallType;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.AttributeContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.ExportContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.InterfaceDeclarationContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.NameContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.OperationContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.ParameterContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.RaisesContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.ScopedNameContext;
import org.sitaf.core.description.source.Findings;
import org.sitaf.core.description.source.Place;

/**
 * Describes IDL interfaces including inherited operations. Attributes become getters and setters.
 */
final class IdlInterfaces {
  private static final DataType VOID = new DataType.Scalar(ScalarType.VOID);

  private final IdlScopes scopes;
  private final IdlTypes types;
  private final Predicate<String> isException;
  private final Findings findings;

  IdlInterfaces(
      IdlScopes scopes, IdlTypes types, Predicate<String> isException, Findings findings) {
    this.scopes = scopes;
    this.types = types;
    this.isException = isException;
    this.findings = findings;
  }

  /** An interface declaration. */
  record Declared(String qualified, InterfaceDeclarationContext body, String file) {}

  /**
   * Describes an interface.
   *
   * @param all all interfaces by qualified name
   * @param name name of the interface in tests
   */
  InterfaceDescription describe(Declared declared, Map<String, Declared> all, String name) {
    for (ScopedNameContext base : declared.body().scopedName()) {
      Optional<String> found = scopes.base(base, declared.qualified());
      Place place = new Place(declared.file(), base.getStart().getLine(), "interface " + name);
      if (found.isEmpty()) {
        findings.error(
            place,
            "inherits from '"
                + IdlScopes.text(base)
                + (types.isType(base, declared.qualified())
                    ? "', which is no interface"
                    : "', which is not declared in any file; add the file that declares it"));
      } else if (scopes.lineage(found.get()).contains(declared.qualified())) {
        findings.error(place, "inherits from itself");
      }
    }
    List<String> lineage = scopes.lineage(declared.qualified());
    if (!lineage.contains(declared.qualified())) {
      findings.error(
          new Place(declared.file(), declared.body().getStart().getLine(), "interface " + name),
          "inherits from more than " + IdlScopes.MAX_LINEAGE + " interfaces");
    }
    List<Method> methods = new ArrayList<>();
    for (String ancestor : lineage) {
      Declared source = all.get(ancestor);
      if (source != null) {
        source.body().export().forEach(export -> methods.addAll(methods(export, source)));
      }
    }
    return new InterfaceDescription(name, methods, declared.file());
  }

  private List<Method> methods(ExportContext export, Declared declared) {
    if (export.operation() != null) {
      return List.of(operation(export.operation(), declared));
    }
    if (export.attribute() == null) {
      return List.of();
    }
    return export.attribute().name().stream()
        .flatMap(name -> attribute(export.attribute(), name, declared).stream())
        .toList();
  }

  private Method operation(OperationContext operation, Declared declared) {
    String name = IdlScopes.text(operation.name());
    Place place =
        new Place(declared.file(), operation.name().getStart().getLine(), "method " + name);
    DataType returnType =
        operation.typeSpec() == null
            ? VOID
            : types.resolve(operation.typeSpec(), declared.qualified(), place);
    List<Parameter> parameters = new ArrayList<>();
    for (ParameterContext parameter : operation.parameter()) {
      parameters.add(parameter(parameter, declared, place));
    }
    boolean oneway = operation.ONEWAY() != null;
    if (oneway
        && (!returnType.equals(VOID)
            || parameters.stream().anyMatch(p -> p.direction() != Direction.IN))) {
      findings.error(place, "is oneway and must not return anything");
    }
    return new Method(
        name,
        returnType,
        parameters,
        oneway ? CallType.NONBLOCKING : CallType.BLOCKING,
        raises(operation.raises(), declared, place),
        place.line());
  }

  private Parameter parameter(ParameterContext context, Declared declared, Place method) {
    String name = IdlScopes.text(context.name());
    Place place = IdlTypes.at(method, context.name(), method.element() + "/param " + name);
    if (context.IN() == null && context.OUT() == null && context.INOUT() == null) {
      findings.warning(place, "has no direction, read as in; write in, out or inout");
    }
    Direction direction =
        context.OUT() != null
            ? Direction.OUT
            : context.INOUT() != null ? Direction.INOUT : Direction.IN;
    return new Parameter(
        name, types.resolve(context.typeSpec(), declared.qualified(), place), direction);
  }

  private List<Method> attribute(AttributeContext attribute, NameContext name, Declared declared) {
    String attributeName = IdlScopes.text(name);
    Place place =
        new Place(declared.file(), name.getStart().getLine(), "attribute " + attributeName);
    DataType type = types.resolve(attribute.typeSpec(), declared.qualified(), place);
    List<String> raised =
        attribute.raises().stream().flatMap(r -> raises(r, declared, place).stream()).toList();
    Method get =
        new Method(
            "get_" + attributeName, type, List.of(), CallType.BLOCKING, raised, place.line());
    if (attribute.READONLY() != null) {
      return List.of(get);
    }
    List<Parameter> value = List.of(new Parameter("value", type, Direction.IN));
    return List.of(
        get,
        new Method("set_" + attributeName, VOID, value, CallType.BLOCKING, raised, place.line()));
  }

  private List<String> raises(
      @org.jspecify.annotations.Nullable RaisesContext raises, Declared declared, Place place) {
    if (raises == null) {
      return List.of();
    }
    List<String> names = new ArrayList<>();
    for (ScopedNameContext name : raises.scopedName()) {
      Optional<String> found = scopes.find(name, declared.qualified(), isException);
      if (found.isEmpty()) {
        findings.warning(
            IdlTypes.at(place, name, place.element()),
            "raises the unknown exception '" + IdlScopes.text(name) + "'");
      }
      names.add(found.orElse(IdlScopes.text(name)));
    }
    return names;
  }
}
