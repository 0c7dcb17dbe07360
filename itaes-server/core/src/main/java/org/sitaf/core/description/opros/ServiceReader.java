package org.sitaf.core.description.opros;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.sitaf.core.description.CallType;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.description.TypeGrammar;
import org.sitaf.core.description.source.Findings;
import org.sitaf.core.description.source.Place;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.schemas.MethodType;
import org.sitaf.schemas.ParamType;
import org.sitaf.schemas.ServicePortType;

/** Reads {@code service_port_type} elements. */
final class ServiceReader {
  private final OprosTypes types;
  private final Findings findings;

  ServiceReader(OprosTypes types, Findings findings) {
    this.types = types;
    this.findings = findings;
  }

  /** The interfaces of a file, in document order. */
  List<InterfaceDescription> describe(OprosDocument.Services document) {
    if (document.interfaces().isEmpty()) {
      findings.error(
          new Place(document.file(), 0, "service_port_type_profile"),
          "contains no <service_port_type>");
    }
    return document.interfaces().stream().map(i -> describe(i, document.file())).toList();
  }

  private InterfaceDescription describe(ServicePortType portType, String file) {
    int line = XmlDocuments.line(portType);
    Place place = new Place(file, line, "type_name");
    String name =
        findings.identifier(
            OprosTypes.text(portType.getTypeName()),
            portType.getTypeName() == null ? place : OprosTypes.at(place, portType.getTypeName()));
    if (portType.getMethods().isEmpty()) {
      findings.error(new Place(file, line, "service_port_type " + name), "has no <method>");
    }
    List<Method> methods =
        portType.getMethods().stream().map(method -> describe(method, file)).toList();
    InterfaceDescription description = new InterfaceDescription(name, methods, file);
    findings.checkDistinct(description);
    return description;
  }

  private Method describe(MethodType methodType, String file) {
    int line = XmlDocuments.line(methodType);
    String name = findings.identifier(methodType.getName(), new Place(file, line, "method"));
    Place place = new Place(file, line, "method " + name);
    DataType returnType = new DataType.Scalar(ScalarType.VOID);
    if (methodType.getReturnType() == null || methodType.getReturnType().isEmpty()) {
      findings.error(place, "has no return_type; write void if it returns nothing");
    } else {
      returnType =
          types
              .resolve(
                  methodType.getReturnType(),
                  new Place(file, line, place.element() + "/return_type"))
              .type();
    }
    List<ParamType> params = new ArrayList<>(methodType.getParams());
    params.sort(Comparator.comparingInt(param -> index(param, place)));
    List<Parameter> parameters = params.stream().map(param -> describe(param, place)).toList();
    return new Method(name, returnType, parameters, callType(methodType, place), line);
  }

  private Parameter describe(ParamType param, Place method) {
    Place place = new Place(method.file(), XmlDocuments.line(param), method.element() + "/param");
    Place namePlace = param.getName() == null ? place : OprosTypes.at(place, param.getName());
    String written = OprosTypes.text(param.getName());
    // Some profiles write the C++ pointer or reference sign before the name.
    boolean signed = written.startsWith("*") || written.startsWith("&");
    String name = findings.identifier(signed ? written.substring(1).strip() : written, namePlace);
    Place named = new Place(place.file(), place.line(), place.element() + " " + name);
    if (signed) {
      findings.warning(
          new Place(named.file(), namePlace.line(), named.element()),
          "'" + written.charAt(0) + "' belongs to the type and is read as part of it");
    }
    TypeGrammar.ParsedType parsed = types.resolve(param.getType(), named);
    return new Parameter(
        name, parsed.type(), signed || parsed.byReference() ? Direction.INOUT : Direction.IN);
  }

  private CallType callType(MethodType methodType, Place place) {
    String callType = methodType.getCallType() == null ? "blocking" : methodType.getCallType();
    return switch (callType) {
      case "blocking", "" -> CallType.BLOCKING;
      case "nonblocking" -> CallType.NONBLOCKING;
      default -> {
        findings.error(place, "call_type must be blocking or nonblocking, not '" + callType + "'");
        yield CallType.BLOCKING;
      }
    };
  }

  /** Parameters without an index come last. */
  private int index(ParamType param, Place method) {
    if (param.getIndex() == null || param.getIndex().isEmpty()) {
      return Integer.MAX_VALUE;
    }
    try {
      return Integer.parseInt(param.getIndex());
    } catch (NumberFormatException e) {
      findings.error(
          new Place(
              method.file(),
              XmlDocuments.line(param),
              method.element() + "/param " + OprosTypes.text(param.getName())),
          "index must be a whole number, not '" + param.getIndex() + "'");
      return Integer.MAX_VALUE;
    }
  }
}
