package org.sitaf.core.description.opros;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.source.ComponentDescription;
import org.sitaf.core.description.source.ComponentDescription.Execution;
import org.sitaf.core.description.source.ComponentDescription.Port;
import org.sitaf.core.description.source.ComponentDescription.Property;
import org.sitaf.core.description.source.Findings;
import org.sitaf.core.description.source.Place;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.schemas.ComponentDataPort;
import org.sitaf.schemas.ComponentEventPort;
import org.sitaf.schemas.ComponentPort;
import org.sitaf.schemas.ComponentProfileDocument;
import org.sitaf.schemas.ComponentPropertyType;
import org.sitaf.schemas.ComponentServicePort;
import org.sitaf.schemas.ExecutionSemanticsType;
import org.sitaf.schemas.LocatedText;

/** Reads {@code component_profile} documents. */
final class ComponentReader {
  private static final long MAX_PERIOD_MS = 86_400_000;
  private static final int MAX_PERIOD_LENGTH = 20;

  private final OprosTypes types;
  private final Findings findings;

  private final References references;

  ComponentReader(OprosTypes types, Findings findings, References references) {
    this.types = types;
    this.findings = findings;
    this.references = references;
  }

  /** Resolves the references of a profile. */
  interface References {
    /** Returns the file that defines the interface of a port; empty if it was not found. */
    String service(ServicePort port);

    /** Checks a reference to a file of data types. */
    void dataTypes(Place place, String reference);
  }

  /** A valid service port whose reference is not resolved yet. */
  record ServicePort(Place place, String name, String type, boolean provided, String reference) {}

  /** Describes a component. */
  ComponentDescription describe(OprosDocument.Component document) {
    ComponentProfileDocument profile = document.profile();
    Place place = new Place(document.file(), XmlDocuments.line(profile), "component_profile");
    String name = OprosTypes.text(profile.getName());
    if (name.isEmpty()) {
      findings.error(place, "has no <name>");
    }
    return new ComponentDescription(
        name,
        OprosTypes.text(profile.getVersion()),
        OprosTypes.text(profile.getDescription()),
        execution(profile.getExecutionSemantics(), place),
        properties(profile, document.file()),
        ports(profile, document.file()),
        document.file());
  }

  private Execution execution(@Nullable ExecutionSemanticsType semantics, Place profile) {
    if (semantics == null) {
      return new Execution.Unspecified("");
    }
    String type = OprosTypes.text(semantics.getType());
    return switch (type.toLowerCase(Locale.ROOT)) {
      case "passive", "nonperiodic", "non-periodic" -> new Execution.Passive();
      case "periodic" -> periodic(semantics, profile);
      default -> new Execution.Unspecified(type);
    };
  }

  private Execution periodic(ExecutionSemanticsType semantics, Place profile) {
    LocatedText period = semantics.getPeriod();
    String text = OprosTypes.text(period);
    try {
      // Parsing many digits takes quadratic time.
      String number = text.length() > MAX_PERIOD_LENGTH ? "" : text;
      long milliseconds = new BigDecimal(number).longValueExact();
      if (milliseconds > 0 && milliseconds <= MAX_PERIOD_MS) {
        return new Execution.Periodic(milliseconds);
      }
    } catch (ArithmeticException | NumberFormatException e) {
      // Reported below.
    }
    int line = XmlDocuments.line(period == null ? semantics : period);
    findings.error(
        new Place(profile.file(), line, "execution_semantics/period"),
        "must be a whole number of milliseconds greater than 0, not '" + text + "'");
    return new Execution.Unspecified("periodic");
  }

  private List<Property> properties(ComponentProfileDocument profile, String file) {
    List<Property> properties = new ArrayList<>();
    if (profile.getProperties() != null) {
      profile.getProperties().getProperties().forEach(p -> properties.add(property(p, true, file)));
    }
    if (profile.getExports() != null) {
      profile.getExports().getVars().forEach(p -> properties.add(property(p, false, file)));
    }
    return properties;
  }

  private Property property(ComponentPropertyType entry, boolean hasDefault, String file) {
    Place place = new Place(file, XmlDocuments.line(entry), "property");
    String name = findings.identifier(entry.getName(), place);
    Place named = new Place(file, place.line(), "property " + name);
    String typeText = entry.getType() == null ? "" : entry.getType();
    if (typeText.isEmpty()) {
      findings.error(named, "has no type");
    }
    DataType type = types.resolve(typeText, named).type();
    String value = entry.getValue() == null ? "" : entry.getValue().strip();
    if (hasDefault && !value.isEmpty() && type instanceof DataType.Scalar scalar) {
      boolean fits =
          !scalar.type().isNumeric()
              || value.matches(
                  scalar.type().isInteger()
                      ? "[+-]?[0-9]{1,20}"
                      : "[+-]?([0-9]{1,40}[.]?[0-9]{0,40}|[.][0-9]{1,40})([eE][+-]?[0-9]{1,4})?");
      if (!fits) {
        findings.warning(named, "the value '" + value + "' is not a valid " + scalar.typeName());
      }
    }
    return new Property(name, type, hasDefault ? value : null);
  }

  private List<Port> ports(ComponentProfileDocument profile, String file) {
    if (profile.getPorts() == null) {
      return List.of();
    }
    return profile.getPorts().getPorts().stream().map(port -> port(port, file)).toList();
  }

  private Port port(ComponentPort port, String file) {
    String kind =
        port instanceof ComponentServicePort
            ? "service_port"
            : port instanceof ComponentDataPort ? "data_port" : "event_port";
    String name = OprosTypes.text(port.getName());
    Place place = new Place(file, XmlDocuments.line(port), (kind + " " + name).strip());
    if (name.isEmpty()) {
      findings.error(place, "has no <name>");
    }
    if (port instanceof ComponentServicePort service) {
      boolean provided = usage(port, place, "provided", "required");
      LocatedText type = service.getType();
      String typeName = OprosTypes.text(type);
      if (typeName.isEmpty()) {
        findings.error(place, "has no <type>; write the type_name of its interface");
        return new Port.Service(name, "", provided, "");
      }
      LocatedText located =
          OprosTypes.text(port.getReference()).isEmpty() ? type : port.getReference();
      String found =
          references.service(
              new ServicePort(
                  OprosTypes.at(place, located),
                  name,
                  typeName,
                  provided,
                  OprosTypes.text(port.getReference())));
      return new Port.Service(name, typeName, provided, found);
    }
    boolean output = usage(port, place, "output", "input");
    if (!OprosTypes.text(port.getReference()).isEmpty()) {
      references.dataTypes(
          OprosTypes.at(place, port.getReference()), OprosTypes.text(port.getReference()));
    }
    if (port instanceof ComponentEventPort event) {
      return new Port.Event(name, types.resolve(event.getDataType(), place).type(), output);
    }
    LocatedText type = ((ComponentDataPort) port).getDataType();
    return new Port.Data(name, types.resolve(type, place).type(), output);
  }

  /** Reads a usage that must be one of two words. Returns whether it is the first. */
  private boolean usage(ComponentPort port, Place place, String first, String second) {
    String usage = OprosTypes.text(port.getUsage()).toLowerCase(Locale.ROOT);
    if (!usage.equals(first) && !usage.equals(second)) {
      findings.error(
          port.getUsage() == null ? place : OprosTypes.at(place, port.getUsage()),
          usage.isEmpty()
              ? "has no <usage>; it is " + first + " or " + second
              : "usage must be " + first + " or " + second + ", not '" + usage + "'");
    }
    return usage.equals(first);
  }
}
