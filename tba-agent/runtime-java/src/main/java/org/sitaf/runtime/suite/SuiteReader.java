package org.sitaf.runtime.suite;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import org.jspecify.annotations.Nullable;

/**
 * Reads a {@code test_suite_data} document (paper, Fig. 9) case by case, so that memory does not
 * grow with the suite. A document with a DTD is rejected.
 */
public final class SuiteReader implements AutoCloseable {
  private final InputStream stream;
  private final XMLStreamReader xml;
  private final String document;
  private final List<String> parameters = new ArrayList<>();
  private final Map<String, List<String>> parametersOfSteps = new HashMap<>();
  private final Deque<TestCase> ahead = new ArrayDeque<>();
  private @Nullable CaseDataException failure;
  private int casesRead;

  private SuiteReader(InputStream stream, XMLStreamReader xml, String document) {
    this.stream = stream;
    this.xml = xml;
    this.document = document;
  }

  /**
   * Opens a suite.
   *
   * @throws IOException when the file cannot be read
   * @throws CaseDataException when the file is not a suite
   */
  public static SuiteReader open(Path suite) throws IOException {
    InputStream stream = Files.newInputStream(suite);
    try {
      XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
      factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
      factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
      factory.setProperty(XMLInputFactory.IS_COALESCING, true);
      SuiteReader reader =
          new SuiteReader(
              stream, factory.createXMLStreamReader(stream), suite.getFileName().toString());
      reader.readHead();
      return reader;
    } catch (XMLStreamException e) {
      stream.close();
      throw new CaseDataException(suite.getFileName() + ": " + e.getMessage(), e);
    } catch (CaseDataException e) {
      stream.close();
      throw e;
    }
  }

  /**
   * The next case; empty after the last.
   *
   * @throws CaseDataException when the document is malformed
   */
  public Optional<TestCase> next() {
    if (!ahead.isEmpty()) {
      return Optional.of(ahead.remove());
    }
    if (failure != null) {
      throw failure;
    }
    return read();
  }

  /**
   * Up to {@code count} of the cases that {@link #next} will return, up to the first error in the
   * document; {@code next} throws when it reaches the error.
   */
  public List<TestCase> upcoming(int count) {
    try {
      while (ahead.size() < count && failure == null) {
        Optional<TestCase> next = read();
        if (next.isEmpty()) {
          break;
        }
        ahead.add(next.get());
      }
    } catch (CaseDataException e) {
      failure = e;
    }
    return ahead.stream().limit(count).toList();
  }

  private Optional<TestCase> read() {
    try {
      while (xml.hasNext()) {
        int event = advance();
        if (event == XMLStreamConstants.START_ELEMENT && xml.getLocalName().equals("case")) {
          return Optional.of(readCase());
        }
      }
      return Optional.empty();
    } catch (XMLStreamException e) {
      throw new CaseDataException(document + ": " + e.getMessage(), e);
    }
  }

  @Override
  public void close() throws IOException {
    stream.close();
  }

  private void readHead() throws XMLStreamException {
    boolean isSuite = false;
    List<String> current = parameters;
    while (xml.hasNext()) {
      int event = advance();
      if (event == XMLStreamConstants.END_ELEMENT && xml.getLocalName().equals("step")) {
        current = parameters;
      }
      if (event != XMLStreamConstants.START_ELEMENT) {
        continue;
      }
      switch (xml.getLocalName()) {
        case "test_suite_data" -> isSuite = true;
        case "step" ->
            current = parametersOfSteps.computeIfAbsent(attribute("name"), k -> new ArrayList<>());
        case "param" -> {
          String name = attribute("name");
          if (current.contains(name)) {
            throw problem("two parameters are named '" + name + "'");
          }
          current.add(name);
        }
        case "case_list" -> {
          if (isSuite) {
            return;
          }
        }
        default -> {
          if (!isSuite) {
            throw problem("the root is <" + xml.getLocalName() + ">, not <test_suite_data>");
          }
        }
      }
    }
    throw problem("there is no <case_list>");
  }

  private TestCase readCase() throws XMLStreamException {
    casesRead++;
    String number = xml.getAttributeValue(null, "no");
    int no = number == null ? casesRead : (int) Literals.whole(number, 1, Integer.MAX_VALUE);
    boolean valid = !"invalid".equals(xml.getAttributeValue(null, "class"));
    Map<String, String> values = new LinkedHashMap<>();
    List<TestStep> steps = new ArrayList<>();
    while (true) {
      int event = advance();
      if (event == XMLStreamConstants.END_ELEMENT) {
        break;
      }
      if (event != XMLStreamConstants.START_ELEMENT) {
        continue;
      }
      switch (xml.getLocalName()) {
        case "value" -> {
          if (values.size() == parameters.size()) {
            throw problem("case " + no + " has more values than the suite has parameters");
          }
          values.put(parameters.get(values.size()), xml.getElementText());
        }
        // Only the agent uses expected values.
        case "expected" -> xml.getElementText();
        case "step" -> steps.add(readStep(no, steps.size() + 1));
        default -> throw problem("<" + xml.getLocalName() + "> is unknown inside <case>");
      }
    }
    requireAll("case " + no, values, parameters);
    return new TestCase(no, valid, values, steps);
  }

  private TestStep readStep(int no, int number) throws XMLStreamException {
    String name = attribute("name");
    boolean valid = !"invalid".equals(xml.getAttributeValue(null, "class"));
    List<String> names = parametersOfSteps.getOrDefault(name, List.of());
    String what = "step " + number + " (" + name + ") of case " + no;
    Map<String, String> values = new LinkedHashMap<>();
    while (true) {
      int event = advance();
      if (event == XMLStreamConstants.END_ELEMENT) {
        break;
      }
      if (event != XMLStreamConstants.START_ELEMENT) {
        continue;
      }
      switch (xml.getLocalName()) {
        case "value" -> {
          if (values.size() == names.size()) {
            throw problem(what + " has more values than its call has parameters");
          }
          values.put(names.get(values.size()), xml.getElementText());
        }
        case "expected" -> xml.getElementText();
        default -> throw problem("<" + xml.getLocalName() + "> is unknown inside <step>");
      }
    }
    requireAll(what, values, names);
    return new TestStep(no, number, name, valid, values);
  }

  private void requireAll(String what, Map<String, String> values, List<String> names) {
    if (values.size() < names.size()) {
      throw problem(what + " has " + values.size() + " values for " + names.size() + " parameters");
    }
  }

  private int advance() throws XMLStreamException {
    int event = xml.next();
    if (event == XMLStreamConstants.DTD || event == XMLStreamConstants.ENTITY_REFERENCE) {
      throw problem("a DTD or an entity is not allowed here");
    }
    return event;
  }

  private String attribute(String name) {
    String value = xml.getAttributeValue(null, name);
    if (value == null) {
      throw problem("<" + xml.getLocalName() + "> has no attribute '" + name + "'");
    }
    return value;
  }

  private CaseDataException problem(String message) {
    return new CaseDataException(
        document + ":" + xml.getLocation().getLineNumber() + ": " + message);
  }
}
