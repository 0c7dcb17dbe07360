package org.sitaf.cli.option;

import java.io.IOException;
import java.io.OutputStream;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.suite.document.SuiteCsv;
import org.sitaf.core.suite.document.TestSuiteXml;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.json.JsonFactory;

/** Output formats of test cases. */
public enum SuiteFormat {
  /** The paper's document (Fig. 9). */
  XML {
    @Override
    public void write(TestSuite suite, OutputStream out) {
      TestSuiteXml.write(suite, out);
    }
  },
  /** A header and one line per case, as in RFC 4180. */
  CSV {
    @Override
    public void write(TestSuite suite, OutputStream out) throws IOException {
      SuiteCsv.write(suite, out);
    }
  },
  /** One object with parameters and cases; values are literals, as in the XML document. */
  JSON {
    @Override
    public void write(TestSuite suite, OutputStream out) {
      try (JsonGenerator json = new JsonFactory().createGenerator(out)) {
        json.writeStartObject();
        json.writeStringProperty("name", suite.name());
        json.writeStringProperty("test_model_name", suite.modelName());
        json.writeNumberProperty("seed", suite.generation().seed());
        json.writeArrayPropertyStart("parameters");
        for (CaseParameter parameter : suite.parameters()) {
          json.writeStartObject();
          json.writeStringProperty("name", parameter.name());
          json.writeStringProperty("type", parameter.kind().name());
          json.writeStringProperty("real_type", parameter.realType());
          json.writeEndObject();
        }
        json.writeEndArray();
        json.writeArrayPropertyStart("cases");
        for (TestCase testCase : suite.cases()) {
          json.writeStartObject();
          json.writeNumberProperty("no", testCase.no());
          json.writeStringProperty("class", testCase.valid() ? "valid" : "invalid");
          json.writeArrayPropertyStart("values");
          testCase.values().forEach(json::writeString);
          json.writeEndArray();
          json.writeObjectPropertyStart("expected");
          for (ExpectedValue expected : testCase.expected()) {
            json.writeStringProperty(
                expected.output().isEmpty() ? "return" : expected.output(), expected.literal());
          }
          json.writeEndObject();
          json.writeEndObject();
        }
        json.writeEndArray();
        json.writeEndObject();
        json.writeRaw('\n');
      }
    }
  };

  /** Writes all cases; equal suites give equal bytes. */
  public abstract void write(TestSuite suite, OutputStream out) throws IOException;
}
