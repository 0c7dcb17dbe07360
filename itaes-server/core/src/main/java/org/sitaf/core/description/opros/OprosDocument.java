package org.sitaf.core.description.opros;

import java.io.ByteArrayInputStream;
import java.io.InputStream;
import java.util.List;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.diagnostic.Severity;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.schemas.ComponentProfileDocument;
import org.sitaf.schemas.DataStructType;
import org.sitaf.schemas.DataTypeDocument;
import org.sitaf.schemas.ServicePortType;
import org.sitaf.schemas.ServicePortTypeProfile;

/** An OPRoS file; its kind is determined by the root element. */
sealed interface OprosDocument {
  String file();

  /** A {@code component_profile}. */
  record Component(String file, ComponentProfileDocument profile) implements OprosDocument {}

  /** A {@code service_port_type_profile} or a bare {@code service_port_type}. */
  record Services(String file, List<ServicePortType> interfaces) implements OprosDocument {
    public Services {
      interfaces = List.copyOf(interfaces);
    }
  }

  /** A {@code data_type}. */
  record DataTypes(String file, List<DataStructType> structs) implements OprosDocument {
    public DataTypes {
      structs = List.copyOf(structs);
    }
  }

  /** A file of another kind. */
  record Other(String file, String root, int line) implements OprosDocument {}

  /**
   * Reads a file.
   *
   * @throws InvalidInputException if the file is not well-formed XML
   */
  static OprosDocument read(byte[] content, String file) {
    return read(new ByteArrayInputStream(content), file);
  }

  /**
   * Reads a file.
   *
   * @throws InvalidInputException if the file is not well-formed XML
   */
  static OprosDocument read(InputStream content, String file) {
    XMLStreamReader reader = XmlDocuments.open(content, file);
    OprosDocument document =
        switch (reader.getLocalName()) {
          case "component_profile" ->
              new Component(file, element(reader, file, ComponentProfileDocument.class));
          case "service_port_type_profile" ->
              new Services(
                  file, element(reader, file, ServicePortTypeProfile.class).getServicePortTypes());
          case "service_port_type" ->
              new Services(file, List.of(element(reader, file, ServicePortType.class)));
          case "data_type" ->
              new DataTypes(file, element(reader, file, DataTypeDocument.class).getStructs());
          default -> new Other(file, reader.getLocalName(), reader.getLocation().getLineNumber());
        };
    readToEnd(reader, file);
    return document;
  }

  /**
   * Reads the root element. Real profiles often contain elements that the schema does not define;
   * these are ignored, as is the message of JAXB about more than ten of them.
   */
  private static <T> T element(XMLStreamReader reader, String file, Class<T> type) {
    Diagnostics found = new Diagnostics();
    T element = XmlDocuments.readElement(reader, file, type, found);
    List<Diagnostic> errors =
        found.all().stream()
            .filter(d -> d.severity() == Severity.ERROR)
            .filter(d -> !d.message().startsWith("Errors limit exceeded"))
            .toList();
    if (!errors.isEmpty()) {
      throw new InvalidInputException(errors);
    }
    return element;
  }

  private static void readToEnd(XMLStreamReader reader, String file) {
    try {
      while (reader.hasNext()) {
        reader.next();
      }
    } catch (XMLStreamException e) {
      int line = e.getLocation() == null ? 0 : Math.max(0, e.getLocation().getLineNumber());
      throw new InvalidInputException(
          List.of(
              Diagnostic.error(
                  file, line, "", "not well-formed XML: content after the root element")));
    }
  }
}
