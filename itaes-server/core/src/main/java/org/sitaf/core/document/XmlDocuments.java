package org.sitaf.core.document;

import jakarta.xml.bind.JAXBContext;
import jakarta.xml.bind.JAXBElement;
import jakarta.xml.bind.JAXBException;
import jakarta.xml.bind.Marshaller;
import jakarta.xml.bind.Unmarshaller;
import jakarta.xml.bind.ValidationEvent;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.Set;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.regex.Pattern;
import javax.xml.namespace.QName;
import javax.xml.stream.Location;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLOutputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import javax.xml.stream.XMLStreamWriter;
import javax.xml.stream.util.StreamReaderDelegate;
import org.glassfish.jaxb.core.Locatable;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.diagnostic.Severity;
import org.sitaf.schemas.ObjectFactory;

/** Reads and writes the paper's XML documents, using the classes generated from the schemas. */
public final class XmlDocuments {
  /** What the JDK's parser says of a character that begins markup or an entity. */
  private static final Pattern UNESCAPED =
      Pattern.compile("well-formed character data|entity name must immediately follow");

  /** Thread-safe. */
  private static final JAXBContext CONTEXT = context();

  /**
   * Above this log level, JAXB reports only the first ten unknown elements, using a counter that
   * all threads share. The field keeps the logger alive: the log manager holds only a weak
   * reference.
   */
  @SuppressWarnings("unused")
  private static final Logger BINDING = bindingLogger();

  private XmlDocuments() {}

  /**
   * Opens a user's document. Document type declarations, and with them all entities, are rejected.
   *
   * @throws InvalidInputException if the document is not well-formed XML; contains the parser's
   *     message
   */
  public static XMLStreamReader open(InputStream document, String file) {
    try {
      XMLStreamReader reader =
          new WithoutDocumentType(inputFactory().createXMLStreamReader(document));
      while (reader.getEventType() != XMLStreamConstants.START_ELEMENT) {
        reader.next();
      }
      return reader;
    } catch (XMLStreamException e) {
      throw malformed(e, file);
    }
  }

  /**
   * Reads a user's document into a class generated from the schemas. An element that the schema
   * does not define is reported as a warning.
   *
   * @param root name of the root element
   * @throws InvalidInputException if the document is not well-formed XML or has another root
   *     element
   */
  public static <T> T read(
      InputStream document, String file, String root, Class<T> type, Diagnostics diagnostics) {
    return read(document, file, root, type, diagnostics, new ElementLines());
  }

  /**
   * Reads a document of a user, as {@link #read(InputStream, String, String, Class, Diagnostics)}.
   *
   * @param lines records the lines of elements that hold only text
   */
  public static <T> T read(
      InputStream document,
      String file,
      String root,
      Class<T> type,
      Diagnostics diagnostics,
      ElementLines lines) {
    return read(document, file, root, type, diagnostics, lines, null);
  }

  /**
   * Reads a document of a user in which nothing may be ignored.
   *
   * @param names the known names; others are reported as errors
   */
  public static <T> T readStrictly(
      InputStream document,
      String file,
      String root,
      Class<T> type,
      Diagnostics diagnostics,
      ElementLines lines,
      SchemaNames names) {
    return read(document, file, root, type, diagnostics, lines, names);
  }

  private static <T> T read(
      InputStream document,
      String file,
      String root,
      Class<T> type,
      Diagnostics diagnostics,
      ElementLines lines,
      @Nullable SchemaNames names) {
    XMLStreamReader reader = lines.recording(open(document, file));
    if (!reader.getLocalName().equals(root)) {
      throw new InvalidInputException(
          java.util.List.of(
              Diagnostic.error(
                  file,
                  reader.getLocation().getLineNumber(),
                  reader.getLocalName(),
                  "the root element must be <" + root + ">")));
    }
    T result;
    if (names == null) {
      result = readElement(reader, file, type, diagnostics);
    } else {
      Diagnostics binding = new Diagnostics();
      reader = names.checking(reader, file, diagnostics);
      result = readElement(reader, file, type, binding);
      // The warnings are about unknown elements, which are reported as errors already.
      diagnostics.addAll(
          binding.all().stream().filter(d -> d.severity() == Severity.ERROR).toList());
    }
    try {
      while (reader.hasNext()) {
        reader.next();
      }
    } catch (XMLStreamException e) {
      throw malformed(e, file);
    }
    return result;
  }

  /** Reads the element at the reader's current position. */
  public static <T> T readElement(
      XMLStreamReader reader, String file, Class<T> type, Diagnostics diagnostics) {
    try {
      Unmarshaller unmarshaller = CONTEXT.createUnmarshaller();
      unmarshaller.setEventHandler(event -> report(event, file, diagnostics));
      JAXBElement<T> element = unmarshaller.unmarshal(reader, type);
      return element.getValue();
    } catch (JAXBException e) {
      if (e.getLinkedException() instanceof XMLStreamException malformed) {
        throw malformed(malformed, file);
      }
      throw InvalidInputException.of(file, "cannot be read: " + e.getMessage());
    }
  }

  /**
   * Writes a document in UTF-8, indented by two spaces. Elements named in {@code rows} are written
   * on a single line.
   *
   * @param root name of the root element
   * @throws IllegalArgumentException if the document cannot be written to the stream
   */
  public static <T> void write(
      String root, Class<T> type, T document, Set<String> rows, OutputStream out) {
    try {
      XMLStreamWriter writer =
          new IndentingWriter(
              XMLOutputFactory.newDefaultFactory().createXMLStreamWriter(out, "UTF-8"), rows);
      Marshaller marshaller = CONTEXT.createMarshaller();
      marshaller.setProperty(Marshaller.JAXB_FRAGMENT, true);
      writer.writeStartDocument("UTF-8", "1.0");
      marshaller.marshal(new JAXBElement<>(new QName(root), type, document), writer);
      writer.writeEndDocument();
      writer.flush();
    } catch (JAXBException | XMLStreamException e) {
      throw new IllegalArgumentException("the document cannot be written: " + e.getMessage(), e);
    }
  }

  /** Line of an element in its document, from 1; 0 if unknown. */
  public static int line(Object element) {
    return element instanceof Locatable located && located.sourceLocation() != null
        ? Math.max(0, located.sourceLocation().getLineNumber())
        : 0;
  }

  private static boolean report(ValidationEvent event, String file, Diagnostics diagnostics) {
    int line = event.getLocator() == null ? 0 : Math.max(0, event.getLocator().getLineNumber());
    String message = String.valueOf(event.getMessage());
    if (event.getLinkedException() instanceof XMLStreamException) {
      return false;
    }
    if (event.getSeverity() == ValidationEvent.WARNING) {
      return true;
    }
    if (message.startsWith("unexpected element")) {
      String name = message.replaceFirst("(?s)^.*?local:\"([^\"]*)\".*$", "$1");
      diagnostics.warning(file, line, name, "unknown element, ignored; check the spelling");
    } else {
      diagnostics.error(file, line, "", message);
    }
    return true;
  }

  private static InvalidInputException malformed(XMLStreamException e, String file) {
    Location location = e.getLocation();
    // The JDK's parser prefixes its message with "ParseError at [row,col]:[..]\nMessage: ".
    String message =
        String.valueOf(e.getMessage()).replaceFirst("(?s)^ParseError at .*?Message: ", "");
    if (UNESCAPED.matcher(message).find()) {
      message += " In an expression, write &lt; for < and &amp;&amp; for &&.";
    }
    return new InvalidInputException(
        java.util.List.of(
            Diagnostic.error(
                file,
                location == null ? 0 : Math.max(0, location.getLineNumber()),
                "",
                "not well-formed XML: " + message)));
  }

  private static XMLInputFactory inputFactory() {
    XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
    factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
    factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
    factory.setProperty(XMLInputFactory.IS_COALESCING, true);
    return factory;
  }

  private static Logger bindingLogger() {
    Logger logger =
        Logger.getLogger("org.glassfish.jaxb.runtime.v2.runtime.unmarshaller.UnmarshallingContext");
    logger.setLevel(Level.FINEST);
    logger.setUseParentHandlers(false);
    return logger;
  }

  private static JAXBContext context() {
    try {
      return JAXBContext.newInstance(ObjectFactory.class);
    } catch (JAXBException e) {
      throw new IllegalStateException("the classes generated from the schemas are invalid", e);
    }
  }

  /** Rejects document type declarations, which {@code SUPPORT_DTD = false} only skips. */
  private static final class WithoutDocumentType extends StreamReaderDelegate {
    WithoutDocumentType(XMLStreamReader reader) {
      super(reader);
    }

    @Override
    public int next() throws XMLStreamException {
      int event = super.next();
      if (event == XMLStreamConstants.DTD || event == XMLStreamConstants.ENTITY_REFERENCE) {
        throw new XMLStreamException(
            "document type declarations and entities are not allowed; remove <!DOCTYPE ...>",
            getLocation());
      }
      return event;
    }
  }
}
