package org.sitaf.core.document;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Set;
import javax.xml.namespace.NamespaceContext;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;
import org.jspecify.annotations.Nullable;

/**
 * Indents by two spaces, keeps rows on one line, and keeps carriage returns, which XML would
 * otherwise lose.
 */
final class IndentingWriter implements XMLStreamWriter {
  private final XMLStreamWriter out;
  private final Set<String> rows;
  private final Deque<Boolean> hasChildren = new ArrayDeque<>();
  private final List<String[]> attributes = new ArrayList<>();
  private int insideRow;

  /** An element that has begun and has no content yet. */
  private @Nullable String pending;

  IndentingWriter(XMLStreamWriter out, Set<String> rows) {
    this.out = out;
    this.rows = Set.copyOf(rows);
  }

  private void begin(String name, boolean empty) throws XMLStreamException {
    flushPending(false);
    if (insideRow == 0) {
      if (!hasChildren.isEmpty()) {
        hasChildren.pop();
        hasChildren.push(true);
      }
      newLine(hasChildren.size());
    }
    if (empty) {
      return;
    }
    if (insideRow > 0 || rows.contains(name)) {
      insideRow++;
    }
    hasChildren.push(false);
  }

  private void flushPending(boolean empty) throws XMLStreamException {
    if (pending == null) {
      return;
    }
    if (empty) {
      out.writeEmptyElement(pending);
    } else {
      out.writeStartElement(pending);
    }
    for (String[] attribute : attributes) {
      out.writeAttribute(attribute[0], attribute[1]);
    }
    attributes.clear();
    pending = null;
  }

  private void newLine(int depth) throws XMLStreamException {
    out.writeCharacters("\n" + "  ".repeat(depth));
  }

  @Override
  public void writeStartElement(String name) throws XMLStreamException {
    begin(name, false);
    pending = name;
  }

  @Override
  public void writeStartElement(String uri, String name) throws XMLStreamException {
    writeStartElement(name);
  }

  @Override
  public void writeStartElement(String prefix, String name, String uri) throws XMLStreamException {
    writeStartElement(name);
  }

  @Override
  public void writeEmptyElement(String name) throws XMLStreamException {
    begin(name, true);
    out.writeEmptyElement(name);
  }

  @Override
  public void writeEmptyElement(String uri, String name) throws XMLStreamException {
    writeEmptyElement(name);
  }

  @Override
  public void writeEmptyElement(String prefix, String name, String uri) throws XMLStreamException {
    writeEmptyElement(name);
  }

  @Override
  public void writeEndElement() throws XMLStreamException {
    boolean children = hasChildren.pop();
    boolean empty = pending != null;
    flushPending(true);
    if (insideRow > 0) {
      insideRow--;
    } else if (children) {
      newLine(hasChildren.size());
    }
    if (!empty) {
      out.writeEndElement();
    }
  }

  @Override
  public void writeEndDocument() throws XMLStreamException {
    out.writeEndDocument();
    out.writeCharacters("\n");
  }

  @Override
  public void writeCharacters(String text) throws XMLStreamException {
    if (text.isEmpty()) {
      return;
    }
    flushPending(false);
    int from = 0;
    for (int at = text.indexOf('\r'); at >= 0; at = text.indexOf('\r', from)) {
      out.writeCharacters(text.substring(from, at));
      out.writeEntityRef("#13");
      from = at + 1;
    }
    out.writeCharacters(text.substring(from));
  }

  @Override
  public void writeCharacters(char[] text, int start, int length) throws XMLStreamException {
    writeCharacters(new String(text, start, length));
  }

  @Override
  public void writeAttribute(String name, String value) {
    attributes.add(new String[] {name, value});
  }

  @Override
  public void writeAttribute(String uri, String name, String value) {
    attributes.add(new String[] {name, value});
  }

  @Override
  public void writeAttribute(String prefix, String uri, String name, String value) {
    attributes.add(new String[] {name, value});
  }

  @Override
  public void writeNamespace(String prefix, String uri) {
    // The documents have no namespace.
  }

  @Override
  public void writeDefaultNamespace(String uri) {
    // The documents have no namespace.
  }

  @Override
  public void writeStartDocument() throws XMLStreamException {
    out.writeStartDocument();
  }

  @Override
  public void writeStartDocument(String version) throws XMLStreamException {
    out.writeStartDocument(version);
  }

  @Override
  public void writeStartDocument(String encoding, String version) throws XMLStreamException {
    out.writeStartDocument(encoding, version);
  }

  @Override
  public void writeComment(String data) throws XMLStreamException {
    flushPending(false);
    out.writeComment(data);
  }

  @Override
  public void writeProcessingInstruction(String target) throws XMLStreamException {
    out.writeProcessingInstruction(target);
  }

  @Override
  public void writeProcessingInstruction(String target, String data) throws XMLStreamException {
    out.writeProcessingInstruction(target, data);
  }

  @Override
  public void writeCData(String data) throws XMLStreamException {
    writeCharacters(data);
  }

  @Override
  public void writeDTD(String dtd) throws XMLStreamException {
    out.writeDTD(dtd);
  }

  @Override
  public void writeEntityRef(String name) throws XMLStreamException {
    out.writeEntityRef(name);
  }

  @Override
  public String getPrefix(String uri) throws XMLStreamException {
    return out.getPrefix(uri);
  }

  @Override
  public void setPrefix(String prefix, String uri) throws XMLStreamException {
    out.setPrefix(prefix, uri);
  }

  @Override
  public void setDefaultNamespace(String uri) throws XMLStreamException {
    out.setDefaultNamespace(uri);
  }

  @Override
  public void setNamespaceContext(NamespaceContext context) throws XMLStreamException {
    out.setNamespaceContext(context);
  }

  @Override
  public NamespaceContext getNamespaceContext() {
    return out.getNamespaceContext();
  }

  @Override
  public Object getProperty(String name) {
    return out.getProperty(name);
  }

  @Override
  public void flush() throws XMLStreamException {
    out.flush();
  }

  @Override
  public void close() throws XMLStreamException {
    out.close();
  }
}
