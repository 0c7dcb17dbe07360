package org.sitaf.schemas;

import static org.assertj.core.api.Assertions.assertThat;

import jakarta.xml.bind.JAXBContext;
import jakarta.xml.bind.JAXBElement;
import jakarta.xml.bind.JAXBException;
import jakarta.xml.bind.Marshaller;
import java.io.IOException;
import java.io.InputStream;
import java.io.StringReader;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.util.Objects;
import javax.xml.XMLConstants;
import javax.xml.namespace.QName;
import javax.xml.transform.stream.StreamSource;
import javax.xml.validation.Schema;
import javax.xml.validation.SchemaFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.xml.sax.SAXException;

/** Schemas accept their documents, and the generated classes read and write them without loss. */
class SchemasTest {
  private static Schema schema(String name) throws SAXException {
    return SchemaFactory.newInstance(XMLConstants.W3C_XML_SCHEMA_NS_URI)
        .newSchema(SchemasTest.class.getResource(name + ".xsd"));
  }

  private static String document(String name) throws IOException {
    try (InputStream in = SchemasTest.class.getResourceAsStream("/" + name + ".xml")) {
      return new String(Objects.requireNonNull(in, name).readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  private static <T> T read(String xml, Class<T> type) throws JAXBException {
    return JAXBContext.newInstance(ObjectFactory.class)
        .createUnmarshaller()
        .unmarshal(new StreamSource(new StringReader(xml)), type)
        .getValue();
  }

  private static <T> String write(String root, Class<T> type, T value) throws JAXBException {
    StringWriter out = new StringWriter();
    Marshaller marshaller = JAXBContext.newInstance(ObjectFactory.class).createMarshaller();
    marshaller.marshal(new JAXBElement<>(new QName(root), type, value), out);
    return out.toString();
  }

  @ParameterizedTest
  @CsvSource({
    "interface_representation, service_port_type_profile, ServicePortTypeProfile",
    "test_model, test_model, TestModelDocument",
    "test_suite_data, test_suite_data, TestSuiteDocument",
    "test_result_descriptor, test_result_descriptor, TestResultDocument"
  })
  void readsAndWritesValidDocumentsWithoutLoss(String schema, String root, String className)
      throws Exception {
    roundTrip(schema, root, Class.forName("org.sitaf.schemas." + className));
  }

  private static <T> void roundTrip(String schema, String root, Class<T> type) throws Exception {
    String original = document(schema);
    schema(schema).newValidator().validate(new StreamSource(new StringReader(original)));

    String once = write(root, type, read(original, type));
    schema(schema).newValidator().validate(new StreamSource(new StringReader(once)));
    assertThat(write(root, type, read(once, type))).isEqualTo(once);
    assertThat(once.replaceAll("[\\s'\"]", "")).hasSize(normalised(original).length());
  }

  /** Without declaration, comments and white space between elements, which have no meaning. */
  private static String normalised(String xml) {
    return ("<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>"
            + xml.replaceAll("(?s)<!--.*?-->", "").replaceAll("<\\?xml[^>]*>", ""))
        .replaceAll("[\\s'\"]", "");
  }

  @Test
  void acceptsTheNameOfThePaper() throws Exception {
    String paperName = document("test_model").replace("TWO_BOUNDARY", "TWO_BOUDARY");
    assertThat(paperName).contains("NEC_NUMERIC_TWO_BOUDARY");
    schema("test_model").newValidator().validate(new StreamSource(new StringReader(paperName)));
  }
}
