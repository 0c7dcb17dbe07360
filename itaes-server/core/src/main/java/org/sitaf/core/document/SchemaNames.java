package org.sitaf.core.document;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.LinkedList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import javax.xml.XMLConstants;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import javax.xml.stream.util.StreamReaderDelegate;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.NearestName;
import org.sitaf.schemas.ObjectFactory;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import org.xml.sax.SAXException;

/**
 * The names that a schema declares. JAXB ignores unknown attributes, so a document in which nothing
 * may be ignored is read through {@link #checking}.
 */
public final class SchemaNames {
  private static final String SCHEMA = "http://www.w3.org/2001/XMLSchema";

  private final Declaration root;

  /** What an element may hold. */
  private record Declaration(Map<String, Declaration> elements, Set<String> attributes) {
    Declaration() {
      this(new LinkedHashMap<>(), new LinkedHashSet<>());
    }
  }

  private SchemaNames(Declaration root) {
    this.root = root;
  }

  /**
   * Reads the names of a schema of SITAF and of the schemas that it includes.
   *
   * @param file such as {@code test_model.xsd}
   * @param rootElement name of the root element of documents
   */
  public static SchemaNames of(String file, String rootElement) {
    Reading reading = new Reading();
    reading.include(file);
    Element element = reading.elements.get(rootElement);
    if (element == null) {
      throw new IllegalArgumentException(file + " declares no element " + rootElement);
    }
    return new SchemaNames(reading.declaration(element));
  }

  /**
   * A reader at a root element that reports unknown elements and attributes as errors and passes
   * them on. Attributes with a namespace, such as those of XML Schema, are left alone.
   */
  XMLStreamReader checking(XMLStreamReader reader, String file, Diagnostics diagnostics) {
    Deque<@Nullable Declaration> open = new LinkedList<>();
    open.push(root);
    checkAttributes(reader, root, file, diagnostics);
    return new StreamReaderDelegate(reader) {
      @Override
      public int next() throws XMLStreamException {
        int event = super.next();
        if (event == XMLStreamConstants.START_ELEMENT) {
          Declaration parent = open.peek();
          Declaration child = parent == null ? null : parent.elements().get(getLocalName());
          if (parent != null && child == null) {
            report(
                this,
                getLocalName(),
                "element",
                getLocalName(),
                parent.elements().keySet(),
                file,
                diagnostics);
          }
          if (child != null) {
            checkAttributes(this, child, file, diagnostics);
          }
          open.push(child);
        } else if (event == XMLStreamConstants.END_ELEMENT) {
          open.pop();
        }
        return event;
      }
    };
  }

  private static void checkAttributes(
      XMLStreamReader reader, Declaration declared, String file, Diagnostics diagnostics) {
    for (int i = 0; i < reader.getAttributeCount(); i++) {
      String namespace = reader.getAttributeNamespace(i);
      String name = reader.getAttributeLocalName(i);
      if ((namespace == null || namespace.isEmpty()) && !declared.attributes().contains(name)) {
        report(
            reader,
            reader.getLocalName() + "/" + name,
            "attribute",
            name,
            declared.attributes(),
            file,
            diagnostics);
      }
    }
  }

  private static void report(
      XMLStreamReader reader,
      String where,
      String kind,
      String name,
      Set<String> known,
      String file,
      Diagnostics diagnostics) {
    diagnostics.error(
        file,
        Math.max(0, reader.getLocation().getLineNumber()),
        where,
        "unknown "
            + kind
            + " '"
            + name
            + "'"
            + NearestName.hint(name, known)
            + (known.isEmpty() ? "" : " Known: " + String.join(", ", new TreeSet<>(known))));
  }

  /** Reads the schema documents. */
  private static final class Reading {
    private final Map<String, Element> elements = new LinkedHashMap<>();
    private final Map<String, Element> types = new LinkedHashMap<>();
    private final Map<String, Declaration> typeDeclarations = new LinkedHashMap<>();

    void include(String file) {
      try (InputStream document = ObjectFactory.class.getResourceAsStream(file)) {
        if (document == null) {
          throw new IllegalArgumentException("there is no schema " + file);
        }
        DocumentBuilderFactory factory = DocumentBuilderFactory.newDefaultInstance();
        factory.setNamespaceAware(true);
        factory.setFeature(XMLConstants.FEATURE_SECURE_PROCESSING, true);
        Element schema = factory.newDocumentBuilder().parse(document).getDocumentElement();
        for (Element child : children(schema)) {
          String name = child.getAttribute("name");
          switch (child.getLocalName()) {
            case "include" -> include(child.getAttribute("schemaLocation"));
            case "element" -> elements.put(name, child);
            case "complexType" -> types.put(name, child);
            default -> {
              // Simple types and annotations hold no names.
            }
          }
        }
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      } catch (ParserConfigurationException | SAXException e) {
        throw new IllegalStateException("the schema " + file + " is invalid", e);
      }
    }

    Declaration declaration(Element element) {
      String type = element.getAttribute("type");
      if (!type.isEmpty()) {
        return typeDeclaration(type);
      }
      Declaration declaration = new Declaration();
      collect(element, declaration);
      return declaration;
    }

    private Declaration typeDeclaration(String type) {
      Declaration known = typeDeclarations.get(type);
      if (known != null) {
        return known;
      }
      Declaration declaration = new Declaration();
      typeDeclarations.put(type, declaration);
      Element declared = types.get(type);
      if (declared != null) {
        collect(declared, declaration);
      }
      return declaration;
    }

    private void collect(Element parent, Declaration into) {
      for (Element child : children(parent)) {
        switch (child.getLocalName()) {
          case "element" -> {
            String reference = child.getAttribute("ref");
            Element declared = reference.isEmpty() ? child : elements.get(reference);
            into.elements()
                .put(
                    reference.isEmpty() ? child.getAttribute("name") : reference,
                    declaration(declared == null ? child : declared));
          }
          case "attribute" -> into.attributes().add(child.getAttribute("name"));
          case "extension" -> {
            Declaration base = typeDeclaration(child.getAttribute("base"));
            into.elements().putAll(base.elements());
            into.attributes().addAll(base.attributes());
            collect(child, into);
          }
          case "annotation", "simpleType" -> {
            // No names.
          }
          default -> collect(child, into);
        }
      }
    }

    private static Iterable<Element> children(Element parent) {
      List<Element> children = new ArrayList<>();
      for (Node n = parent.getFirstChild(); n != null; n = n.getNextSibling()) {
        if (n instanceof Element element && SCHEMA.equals(element.getNamespaceURI())) {
          children.add(element);
        }
      }
      return children;
    }
  }
}
