package org.sitaf.cli.falsify;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.xml.stream.XMLOutputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.model.document.TestModelXml;

/** Adds a case to the {@code case_list} of a model and leaves the rest of its text unchanged. */
public final class KeptCaseText {
  private static final String LIST_END = "</case_list>";
  private static final String MODEL_END = "</test_model>";

  private KeptCaseText() {}

  /**
   * Adds a case.
   *
   * @throws InvalidInputException if the place cannot be found; the file is unchanged then
   */
  static void add(Path file, TestModel model, List<Value> values) throws IOException {
    String text = Files.readString(file);
    String added = element(values) + "\n  ";
    int list = text.lastIndexOf(LIST_END);
    int end = text.lastIndexOf(MODEL_END);
    String changed =
        list >= 0
            ? text.substring(0, list) + "  " + added + text.substring(list)
            : end < 0
                ? text
                : text.substring(0, end)
                    + "  <case_list>\n    "
                    + added
                    + LIST_END
                    + "\n"
                    + text.substring(end);
    TestModel read =
        TestModelXml.read(
            new ByteArrayInputStream(changed.getBytes(StandardCharsets.UTF_8)), model.source());
    if (read.keptCases().size() != model.keptCases().size() + 1) {
      throw InvalidInputException.of(file.toString(), "has no place for a case; add it by hand");
    }
    Files.writeString(file, changed);
  }

  private static String element(List<Value> values) {
    StringWriter text = new StringWriter();
    try {
      XMLStreamWriter xml = XMLOutputFactory.newFactory().createXMLStreamWriter(text);
      xml.writeStartElement("case");
      for (Value value : values) {
        xml.writeStartElement("value");
        xml.writeCharacters(value.literal());
        xml.writeEndElement();
      }
      xml.writeEndElement();
      xml.flush();
    } catch (XMLStreamException e) {
      throw new IllegalStateException(e);
    }
    return text.toString();
  }
}
