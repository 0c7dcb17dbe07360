package org.sitaf.cli.option;

import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.StepParameters;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;
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
        suite.parameters().forEach(parameter -> writeParameter(json, parameter));
        json.writeEndArray();
        if (suite.isOfSequences()) {
          json.writeObjectPropertyStart("step_parameters");
          for (StepParameters step : suite.stepParameters()) {
            json.writeArrayPropertyStart(step.name());
            step.parameters().forEach(parameter -> writeParameter(json, parameter));
            json.writeEndArray();
          }
          json.writeEndObject();
        }
        json.writeArrayPropertyStart("cases");
        for (TestCase testCase : suite.cases()) {
          json.writeStartObject();
          json.writeNumberProperty("no", testCase.no());
          json.writeStringProperty("class", testCase.valid() ? "valid" : "invalid");
          json.writeArrayPropertyStart("values");
          testCase.values().forEach(json::writeString);
          json.writeEndArray();
          writeExpected(json, testCase.expected());
          if (suite.isOfSequences()) {
            json.writeArrayPropertyStart("steps");
            for (TestStep step : testCase.steps()) {
              json.writeStartObject();
              json.writeStringProperty("name", step.name());
              json.writeStringProperty("class", step.valid() ? "valid" : "invalid");
              json.writeArrayPropertyStart("values");
              step.values().forEach(json::writeString);
              json.writeEndArray();
              writeExpected(json, step.expected());
              json.writeEndObject();
            }
            json.writeEndArray();
          }
          json.writeEndObject();
        }
        json.writeEndArray();
        json.writeEndObject();
        json.writeRaw('\n');
      }
    }
  };

  private static void writeParameter(JsonGenerator json, CaseParameter parameter) {
    json.writeStartObject();
    json.writeStringProperty("name", parameter.name());
    json.writeStringProperty("type", parameter.kind().name());
    json.writeStringProperty("real_type", parameter.realType());
    json.writeEndObject();
  }

  private static void writeExpected(JsonGenerator json, List<ExpectedValue> values) {
    json.writeObjectPropertyStart("expected");
    for (ExpectedValue expected : values) {
      json.writeStringProperty(
          expected.output().isEmpty() ? "return" : expected.output(), expected.literal());
    }
    json.writeEndObject();
  }

  /** Writes all cases; equal suites give equal bytes. */
  public abstract void write(TestSuite suite, OutputStream out) throws IOException;
}
