package org.sitaf.core.description;

import java.io.InputStream;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.schemas.LocatedText;
import org.sitaf.schemas.MethodType;
import org.sitaf.schemas.ParamType;
import org.sitaf.schemas.ServicePortType;
import org.sitaf.schemas.ServicePortTypeProfile;

/** Interface Parser for the interface representation of OPRoS (paper, Fig. 3). */
public final class OprosReader {
  private static final Pattern IDENTIFIER = Pattern.compile("[A-Za-z_][A-Za-z0-9_]*");

  private final String file;
  private final Diagnostics diagnostics;

  private OprosReader(String file, Diagnostics diagnostics) {
    this.file = file;
    this.diagnostics = diagnostics;
  }

  /**
   * Reads the interfaces of a file: a {@code service_port_type_profile} or a bare {@code
   * service_port_type}.
   *
   * @param diagnostics takes warnings, such as types that nothing defines
   * @throws InvalidInputException with every problem of the file
   */
  public static List<InterfaceDescription> read(
      InputStream document, String file, Diagnostics diagnostics) {
    Diagnostics own = new Diagnostics();
    List<InterfaceDescription> interfaces = new OprosReader(file, own).readDocument(document);
    own.throwIfErrors();
    diagnostics.addAll(own.all());
    return interfaces;
  }

  private List<InterfaceDescription> readDocument(InputStream document) {
    var reader = XmlDocuments.open(document, file);
    Diagnostics unread = new Diagnostics();
    return switch (reader.getLocalName()) {
      case "service_port_type_profile" -> {
        var profile = XmlDocuments.readElement(reader, file, ServicePortTypeProfile.class, unread);
        if (profile.getServicePortTypes().isEmpty()) {
          diagnostics.error(file, 0, "service_port_type_profile", "holds no <service_port_type>");
        }
        yield profile.getServicePortTypes().stream().map(this::describe).toList();
      }
      case "service_port_type" ->
          List.of(describe(XmlDocuments.readElement(reader, file, ServicePortType.class, unread)));
      default -> {
        diagnostics.error(
            file,
            reader.getLocation().getLineNumber(),
            reader.getLocalName(),
            "an interface file has the root <service_port_type_profile> or <service_port_type>");
        yield List.of();
      }
    };
  }

  private InterfaceDescription describe(ServicePortType portType) {
    int line = XmlDocuments.line(portType);
    String name = identifier(text(portType.getTypeName()), line, "type_name");
    if (portType.getMethods().isEmpty()) {
      diagnostics.error(file, line, "service_port_type " + name, "has no <method>");
    }
    Set<String> prototypes = new HashSet<>();
    List<Method> methods = new ArrayList<>();
    for (MethodType methodType : portType.getMethods()) {
      Method method = describe(methodType);
      if (!prototypes.add(method.name() + "(" + method.signature() + ")")) {
        diagnostics.error(
            file,
            method.line(),
            "method " + method.name(),
            "stands here twice with the same parameter types; remove one");
      }
      methods.add(method);
    }
    return new InterfaceDescription(name, methods, file);
  }

  private Method describe(MethodType methodType) {
    int line = XmlDocuments.line(methodType);
    String name = identifier(methodType.getName(), line, "method");
    String where = "method " + name;
    if (methodType.getReturnType() == null) {
      diagnostics.error(
          file, line, where, "has no return_type; write void where it returns nothing");
    }
    String spelling = methodType.getReturnType() == null ? "void" : methodType.getReturnType();
    DataType returnType = resolve(spelling, line, where + "/return_type").type();
    List<ParamType> params = new ArrayList<>(methodType.getParams());
    params.sort(Comparator.comparingInt(p -> index(p, where)));
    Set<String> names = new HashSet<>();
    List<Parameter> parameters = new ArrayList<>();
    for (ParamType param : params) {
      Parameter parameter = describe(param, where);
      if (!names.add(parameter.name())) {
        diagnostics.error(
            file,
            XmlDocuments.line(param),
            where + "/param " + parameter.name(),
            "two parameters have this name");
      }
      parameters.add(parameter);
    }
    return new Method(name, returnType, parameters, callType(methodType, line, where), line);
  }

  private Parameter describe(ParamType param, String where) {
    int line = XmlDocuments.line(param);
    String name = identifier(text(param.getName()), line, where + "/param");
    String element = where + "/param " + name;
    if (param.getType() == null) {
      diagnostics.error(file, line, element, "has no <type>");
      return new Parameter(name, new DataType.Unknown(""), Direction.IN);
    }
    TypeGrammar.Spelled spelled = resolve(param.getType().getValue(), line, element);
    return new Parameter(
        name, spelled.type(), spelled.byReference() ? Direction.INOUT : Direction.IN);
  }

  private CallType callType(MethodType methodType, int line, String where) {
    String spelling = methodType.getCallType() == null ? "blocking" : methodType.getCallType();
    return switch (spelling) {
      case "blocking" -> CallType.BLOCKING;
      case "nonblocking" -> CallType.NONBLOCKING;
      default -> {
        diagnostics.error(
            file, line, where, "call_type must be blocking or nonblocking, not '" + spelling + "'");
        yield CallType.BLOCKING;
      }
    };
  }

  private int index(ParamType param, String where) {
    if (param.getIndex() == null) {
      return Integer.MAX_VALUE;
    }
    try {
      return Integer.parseInt(param.getIndex());
    } catch (NumberFormatException e) {
      diagnostics.error(
          file,
          XmlDocuments.line(param),
          where + "/param " + text(param.getName()),
          "index must be a whole number, not '" + param.getIndex() + "'");
      return Integer.MAX_VALUE;
    }
  }

  private TypeGrammar.Spelled resolve(String spelling, int line, String where) {
    TypeGrammar.Spelled spelled = TypeGrammar.parse(spelling);
    unknownIn(spelled.type())
        .forEach(
            name ->
                diagnostics.warning(
                    file, line, where, "unknown type '" + name + "', kept by its name"));
    return spelled;
  }

  private static List<String> unknownIn(DataType type) {
    if (type instanceof DataType.Unknown unknown) {
      return List.of(unknown.name());
    }
    if (type instanceof DataType.Sequence sequence) {
      return unknownIn(sequence.element());
    }
    return type instanceof DataType.FixedArray array ? unknownIn(array.element()) : List.of();
  }

  private static @org.jspecify.annotations.Nullable String text(
      @org.jspecify.annotations.Nullable LocatedText text) {
    return text == null ? null : text.getValue();
  }

  private String identifier(
      @org.jspecify.annotations.Nullable String name, int line, String where) {
    if (name == null || !IDENTIFIER.matcher(name).matches()) {
      diagnostics.error(
          file,
          line,
          where,
          (name == null ? "has no name" : "'" + name + "' is not a name")
              + "; letters, digits and '_', not beginning with a digit");
      return "unnamed";
    }
    return name;
  }
}
