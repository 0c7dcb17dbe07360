package org.sitaf.core.verdict.document;

import java.io.OutputStream;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.xml.stream.XMLOutputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.FailureGroup;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.StepResult;
import org.sitaf.core.verdict.Summary;
import org.sitaf.core.verdict.TestResult;

/**
 * A result in the format that CI systems read: FAIL is a failure, ERROR an error, DONT skipped. A
 * suspect result has an additional error, so that CI systems do not report it as passed.
 */
public final class JunitXml {
  private JunitXml() {}

  /**
   * Writes each result as a {@code testsuite}.
   *
   * @param activity name of the activity, for the class names of the cases
   */
  public static void write(String activity, List<TestResult> results, OutputStream out) {
    try {
      XMLStreamWriter xml =
          XMLOutputFactory.newDefaultFactory().createXMLStreamWriter(out, "UTF-8");
      xml.writeStartDocument("UTF-8", "1.0");
      xml.writeCharacters("\n");
      xml.writeStartElement("testsuites");
      for (TestResult result : results) {
        write(activity, result, xml);
      }
      xml.writeCharacters("\n");
      xml.writeEndElement();
      xml.writeCharacters("\n");
      xml.writeEndDocument();
      xml.flush();
    } catch (XMLStreamException e) {
      throw new IllegalArgumentException("the report cannot be written: " + e.getMessage(), e);
    }
  }

  private static void write(String activity, TestResult result, XMLStreamWriter xml)
      throws XMLStreamException {
    Summary summary = result.summary();
    xml.writeCharacters("\n  ");
    xml.writeStartElement("testsuite");
    xml.writeAttribute("name", activity + "." + result.name());
    int suspect = result.isSuspect() ? 1 : 0;
    xml.writeAttribute("tests", Integer.toString(summary.total() + suspect));
    xml.writeAttribute("failures", Integer.toString(summary.fail()));
    xml.writeAttribute("errors", Integer.toString(summary.error() + suspect));
    xml.writeAttribute("skipped", Integer.toString(summary.dont()));
    xml.writeAttribute("timestamp", result.provenance().started());
    xml.writeAttribute(
        "time", seconds(result.cases().stream().mapToDouble(JunitXml::microseconds).sum()));
    for (CaseResult testCase : result.cases()) {
      write(activity, result, testCase, xml);
    }
    if (result.isSuspect()) {
      writeSuspectError(activity, result, xml);
    }
    writeGroups(FailureGroup.of(result.cases()), xml);
    xml.writeCharacters("\n  ");
    xml.writeEndElement();
  }

  /** The groups of the cases that did not pass, as one output of the suite: a line for each. */
  private static void writeGroups(List<FailureGroup> groups, XMLStreamWriter xml)
      throws XMLStreamException {
    if (groups.isEmpty()) {
      return;
    }
    xml.writeCharacters("\n    ");
    xml.writeStartElement("system-out");
    xml.writeCharacters(groups.stream().map(FailureGroup::line).collect(Collectors.joining("\n")));
    xml.writeEndElement();
  }

  private static void writeSuspectError(String activity, TestResult result, XMLStreamWriter xml)
      throws XMLStreamException {
    xml.writeCharacters("\n    ");
    xml.writeStartElement("testcase");
    xml.writeAttribute("classname", activity + "." + result.name());
    xml.writeAttribute("name", "the result can be trusted");
    xml.writeStartElement("error");
    xml.writeAttribute("message", "the result is suspect");
    xml.writeCharacters(String.join("\n", result.suspicions()));
    xml.writeEndElement();
    xml.writeEndElement();
  }

  private static void write(
      String activity, TestResult result, CaseResult testCase, XMLStreamWriter xml)
      throws XMLStreamException {
    String inputs =
        IntStream.range(0, Math.min(testCase.values().size(), result.parameters().size()))
            .mapToObj(i -> result.parameters().get(i).name() + "=" + testCase.values().get(i))
            .collect(Collectors.joining(", "));
    xml.writeCharacters("\n    ");
    xml.writeStartElement("testcase");
    xml.writeAttribute("classname", activity + "." + result.name());
    xml.writeAttribute(
        "name",
        testCase.no() == 0 ? "all cases" : testCase.no() + ": " + name(inputs, testCase.steps()));
    xml.writeAttribute("time", seconds(microseconds(testCase)));
    String element =
        switch (testCase.verdict()) {
          case PASS -> "";
          case FAIL -> "failure";
          case ERROR -> "error";
          case DONT -> "skipped";
        };
    if (!element.isEmpty()) {
      xml.writeStartElement(element);
      xml.writeAttribute("message", testCase.message());
      xml.writeCharacters(
          testCase.steps().isEmpty()
              ? "expected " + values(testCase.expected()) + ", actual " + values(testCase.actual())
              : steps(testCase.steps()));
      xml.writeEndElement();
    }
    if (testCase.repeated() != null && testCase.repeated().differ()) {
      xml.writeStartElement("system-out");
      xml.writeCharacters("repeated calls differ: " + testCase.repeated().differs());
      xml.writeEndElement();
    }
    xml.writeEndElement();
  }

  /** The inputs and the steps of a sequence. */
  private static String name(String inputs, List<StepResult> steps) {
    String names = steps.stream().map(StepResult::name).collect(Collectors.joining(" "));
    return inputs.isEmpty() || names.isEmpty() ? inputs + names : inputs + ": " + names;
  }

  private static String steps(List<StepResult> steps) {
    return IntStream.range(0, steps.size())
        .mapToObj(i -> step(i + 1, steps.get(i)))
        .collect(Collectors.joining("\n"));
  }

  private static String step(int number, StepResult step) {
    return number
        + " "
        + step.call()
        + kind(step)
        + ": "
        + step.verdict()
        + (step.afterFailure() ? " after a failure" : "")
        + (step.expected().isEmpty() ? "" : ", expected " + values(step.expected()))
        + (step.actual().isEmpty() ? "" : ", actual " + values(step.actual()))
        + (step.message().isEmpty() ? "" : ": " + step.message());
  }

  private static String kind(StepResult step) {
    return step.kind() == StepResult.Kind.VALID ? "" : " (" + step.kind().words() + ")";
  }

  private static String values(List<NamedValue> values) {
    return values.isEmpty()
        ? "none"
        : values.stream()
            .map(v -> v.output().isEmpty() ? v.literal() : v.output() + "=" + v.literal())
            .collect(Collectors.joining(", "));
  }

  private static double microseconds(CaseResult testCase) {
    return testCase.micros().orElse(0);
  }

  private static String seconds(double microseconds) {
    return String.format(Locale.ROOT, "%.6f", microseconds / 1e6);
  }
}
