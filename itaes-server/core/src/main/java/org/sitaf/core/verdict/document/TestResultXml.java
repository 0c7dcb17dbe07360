package org.sitaf.core.verdict.document;

import java.io.InputStream;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.lock.ResolvedPackage;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.core.suite.document.TestSuiteXml;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Coverage;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.Provenance;
import org.sitaf.core.verdict.RelationResult;
import org.sitaf.core.verdict.StubCalls;
import org.sitaf.core.verdict.Summary;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.TrajectoryResult;
import org.sitaf.core.verdict.Verdict;
import org.sitaf.schemas.CallType;
import org.sitaf.schemas.CaseTimeType;
import org.sitaf.schemas.NamedValueType;
import org.sitaf.schemas.PackageType;
import org.sitaf.schemas.ProvenanceType;
import org.sitaf.schemas.RelationResultType;
import org.sitaf.schemas.SummaryType;
import org.sitaf.schemas.TestResultDocument;
import org.sitaf.schemas.TestResultListType;
import org.sitaf.schemas.TestResultType;
import org.sitaf.schemas.TrajectoryType;

/** The document of a result (schemas/test_result_descriptor.xsd). */
public final class TestResultXml {
  private static final String ROOT = "test_result_descriptor";
  private static final String MICROSECONDS = "us";

  private TestResultXml() {}

  /**
   * Reads a result.
   *
   * @param file name of the document, for diagnostics
   * @throws InvalidInputException with every problem of the document
   */
  public static TestResult read(InputStream document, String file) {
    Diagnostics diagnostics = new Diagnostics();
    TestResultDocument root =
        XmlDocuments.read(document, file, ROOT, TestResultDocument.class, diagnostics);
    List<CaseResult> cases = new ArrayList<>();
    if (root.getSummary() == null || root.getTestResultList() == null) {
      diagnostics.error(file, 0, "", "needs a summary and a test_result_list");
    } else {
      for (TestResultType given : root.getTestResultList().getTestResults()) {
        try {
          cases.add(read(given));
        } catch (IllegalArgumentException e) {
          diagnostics.error(
              file, XmlDocuments.line(given), "test_result", String.valueOf(e.getMessage()));
        }
      }
    }
    Coverage coverage = null;
    try {
      coverage = CoverageXml.read(root.getCoverageList());
    } catch (IllegalArgumentException e) {
      diagnostics.error(file, 0, "coverage_list", String.valueOf(e.getMessage()));
    }
    diagnostics.throwIfErrors();
    return new TestResult(
        root.getName() == null ? "" : root.getName(),
        read(root.getProvenance()),
        read(root.getSummary(), file),
        TestSuiteXml.read(root.getCaseParamInfo(), file, diagnostics),
        cases,
        coverage,
        root.getSuspicion());
  }

  /** Writes a result; the same result gives the same bytes. */
  public static void write(TestResult result, OutputStream out) {
    TestResultDocument root = new TestResultDocument();
    root.setName(result.name());
    root.setProvenance(write(result.provenance()));
    root.setSummary(write(result.summary()));
    root.getSummary().setCoverage(CoverageXml.summary(result.coverage()));
    root.setCoverageList(CoverageXml.write(result.coverage()));
    root.setCaseParamInfo(TestSuiteXml.write(result.parameters()));
    root.getSuspicion().addAll(result.suspicions());
    TestResultListType list = new TestResultListType();
    result.cases().forEach(c -> list.getTestResults().add(write(c)));
    root.setTestResultList(list);
    XmlDocuments.write(
        ROOT,
        TestResultDocument.class,
        root,
        Set.of("test_result", "param", "package", "line"),
        out);
  }

  private static CaseResult read(TestResultType given) {
    Verdict verdict;
    try {
      verdict = Verdict.valueOf(String.valueOf(given.getVerdict()));
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(
          "verdict must be PASS, FAIL, ERROR or DONT, not '" + given.getVerdict() + "'", e);
    }
    CaseResult read =
        new CaseResult(
            given.getNo(),
            verdict,
            given.getValues(),
            read(given.getExpected()),
            read(given.getActual()),
            new StubCalls(
                given.getCall().stream()
                    .map(
                        c ->
                            new StubCalls.Call(
                                c.getMethod() == null ? "" : c.getMethod(), read(c.getArgument())))
                    .toList(),
                given.getCallsLeftOut() == null ? 0 : given.getCallsLeftOut()),
            given.getTrajectory().stream().map(TestResultXml::read).toList(),
            given.getRelation().stream().map(TestResultXml::read).toList(),
            read(given.getProcessingTime()),
            RepeatedCallsXml.read(given.getRepeatedCalls()),
            given.getMessage() == null ? "" : given.getMessage());
    CaseResult result = given.getNote().isEmpty() ? read : read.withNotes(given.getNote());
    if (given.getHardware() != null) {
      result = result.with(HardwareReportXml.read(given.getHardware()));
    }
    return given.getStep().isEmpty() ? result : result.withSteps(StepsXml.read(given.getStep()));
  }

  static CaseResult.@Nullable ProcessingTime read(@Nullable CaseTimeType time) {
    return time == null
        ? null
        : new CaseResult.ProcessingTime(
            time.getValue(),
            orZero(time.getHardware()),
            orZero(time.getStub()),
            Boolean.TRUE.equals(time.isCold()));
  }

  static @Nullable CaseTimeType write(CaseResult.@Nullable ProcessingTime given) {
    if (given == null) {
      return null;
    }
    CaseTimeType time = new CaseTimeType();
    time.setUnit(MICROSECONDS);
    time.setValue(given.total());
    time.setHardware(given.hardware());
    time.setStub(given.stub());
    time.setCold(given.cold() ? true : null);
    return time;
  }

  private static TrajectoryResult read(TrajectoryType given) {
    return new TrajectoryResult(
        orEmpty(given.getName()),
        Verdict.valueOf(String.valueOf(given.getVerdict())),
        given.getMargin(),
        given.getAt());
  }

  private static TrajectoryType write(TrajectoryResult result) {
    TrajectoryType written = new TrajectoryType();
    written.setName(result.name());
    written.setVerdict(result.verdict().name());
    written.setMargin(result.margin());
    written.setAt(result.at());
    return written;
  }

  private static RelationResult read(RelationResultType given) {
    return new RelationResult(
        orEmpty(given.getName()),
        RelationResult.Outcome.valueOf(String.valueOf(given.getVerdict())),
        given.getValue(),
        read(given.getActual()),
        orEmpty(given.getMessage()));
  }

  private static RelationResultType write(RelationResult result) {
    RelationResultType written = new RelationResultType();
    written.setName(result.name());
    written.setVerdict(result.outcome().name());
    written.getValue().addAll(result.values());
    written.getActual().addAll(write(result.actual()));
    written.setMessage(result.message().isEmpty() ? null : result.message());
    return written;
  }

  static List<NamedValue> read(List<NamedValueType> values) {
    return values.stream()
        .map(
            v ->
                new NamedValue(
                    v.getName() == null ? "" : v.getName(),
                    v.getValue() == null ? "" : v.getValue()))
        .toList();
  }

  private static Provenance read(@Nullable ProvenanceType given) {
    ProvenanceType p = given == null ? new ProvenanceType() : given;
    return new Provenance(
        orEmpty(p.getSuite()),
        p.getSeed() == null ? 1 : p.getSeed(),
        orEmpty(p.getHarness()),
        orEmpty(p.getComponent()),
        orEmpty(p.getAgent()),
        orEmpty(p.getBridge()),
        orEmpty(p.getCompiler()),
        p.getPackage().stream()
            .map(
                each ->
                    new ResolvedPackage(
                        orEmpty(each.getName()),
                        orEmpty(each.getVersion()),
                        orEmpty(each.getSha256())))
            .toList(),
        orEmpty(p.getStarted()),
        orEmpty(p.getFinished()));
  }

  private static Summary read(SummaryType given, String file) {
    SummaryType.ProcessingTime time = given.getProcessingTime();
    boolean timed = time != null && time.getAverage() != null;
    try {
      return new Summary(
          given.getTotal(),
          given.getPass(),
          given.getFail(),
          given.getError(),
          given.getDont(),
          given.getUnjudged() == null ? 0 : given.getUnjudged(),
          given.getByError() == null ? 0 : given.getByError(),
          timed
              ? new Summary.Times(
                  orZero(time.getMin()),
                  orZero(time.getMax()),
                  orZero(time.getAverage()),
                  orZero(time.getStandardDeviation()),
                  time.getFirst())
              : null);
    } catch (IllegalArgumentException e) {
      throw InvalidInputException.of(file, "summary: " + e.getMessage());
    }
  }

  private static TestResultType write(CaseResult result) {
    TestResultType written = new TestResultType();
    written.setNo(result.no());
    written.setVerdict(result.verdict().name());
    written.getValues().addAll(result.values());
    written.getExpected().addAll(write(result.expected()));
    written.getActual().addAll(write(result.actual()));
    for (StubCalls.Call call : result.calls().recorded()) {
      CallType writtenCall = new CallType();
      writtenCall.setMethod(call.method());
      writtenCall.getArgument().addAll(write(call.arguments()));
      written.getCall().add(writtenCall);
    }
    written.setCallsLeftOut(result.calls().leftOut() == 0 ? null : result.calls().leftOut());
    result.trajectories().forEach(t -> written.getTrajectory().add(write(t)));
    result.relations().forEach(r -> written.getRelation().add(write(r)));
    written.getStep().addAll(StepsXml.write(result.steps()));
    written.setProcessingTime(write(result.time()));
    written.setRepeatedCalls(RepeatedCallsXml.write(result.repeated()));
    written.setMessage(result.message().isEmpty() ? null : result.message());
    written.getNote().addAll(result.notes());
    written.setHardware(HardwareReportXml.write(result.hardware()));
    return written;
  }

  static List<NamedValueType> write(List<NamedValue> values) {
    return values.stream()
        .map(
            v -> {
              NamedValueType written = new NamedValueType();
              written.setName(v.output().isEmpty() ? null : v.output());
              written.setValue(v.literal());
              return written;
            })
        .toList();
  }

  private static ProvenanceType write(Provenance provenance) {
    ProvenanceType written = new ProvenanceType();
    written.setSuite(provenance.suite());
    written.setSeed(provenance.seed());
    written.setHarness(provenance.harness());
    written.setComponent(provenance.component());
    written.setAgent(provenance.agent());
    written.setBridge(provenance.bridge());
    written.setCompiler(provenance.compiler().isEmpty() ? null : provenance.compiler());
    for (ResolvedPackage each : provenance.packages()) {
      PackageType used = new PackageType();
      used.setName(each.name());
      used.setVersion(each.version());
      used.setSha256(each.sha256());
      written.getPackage().add(used);
    }
    written.setStarted(provenance.started());
    written.setFinished(provenance.finished());
    return written;
  }

  private static SummaryType write(Summary summary) {
    SummaryType written = new SummaryType();
    written.setTotal(summary.total());
    written.setPass(summary.pass());
    written.setFail(summary.fail());
    written.setError(summary.error());
    written.setDont(summary.dont());
    written.setUnjudged(summary.unjudged());
    written.setByError(summary.byError());
    SummaryType.ProcessingTime time = new SummaryType.ProcessingTime();
    time.setUnit(MICROSECONDS);
    if (summary.times() != null) {
      time.setMin(summary.times().min());
      time.setMax(summary.times().max());
      time.setAverage(summary.times().average());
      time.setStandardDeviation(summary.times().standardDeviation());
      time.setFirst(summary.times().first());
    }
    written.setProcessingTime(time);
    return written;
  }

  private static double orZero(@Nullable Double number) {
    return number == null ? 0 : number;
  }

  private static String orEmpty(@Nullable String text) {
    return text == null ? "" : text;
  }
}
