package org.sitaf.core.document;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import javax.xml.stream.util.StreamReaderDelegate;

/**
 * Lines of elements that hold only text. JAXB does not locate those, unlike elements with
 * attributes or children, for which {@link XmlDocuments#line} gives the line.
 */
public final class ElementLines {
  private final Set<String> names;
  private final Map<String, List<Integer>> lines = new HashMap<>();

  /** Of elements with these names; none so far. */
  public ElementLines(String... names) {
    this.names = Set.of(names);
  }

  /**
   * The line of an element.
   *
   * @param index its position among the elements of this name in the document, from 0
   * @return from 1; 0 if there is no such element
   */
  public int of(String name, int index) {
    List<Integer> found = lines.getOrDefault(name, List.of());
    return index < found.size() ? found.get(index) : 0;
  }

  XMLStreamReader recording(XMLStreamReader reader) {
    return new StreamReaderDelegate(reader) {
      @Override
      public int next() throws XMLStreamException {
        int event = super.next();
        if (event == XMLStreamConstants.START_ELEMENT && names.contains(getLocalName())) {
          lines
              .computeIfAbsent(getLocalName(), name -> new ArrayList<>())
              .add(Math.max(0, getLocation().getLineNumber()));
        }
        return event;
      }
    };
  }
}
