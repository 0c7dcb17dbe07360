package org.sitaf.core.suite.document;

import java.io.InputStream;
import java.io.OutputStream;
import java.util.AbstractList;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.Strength;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.Generation;
import org.sitaf.core.suite.StepParameters;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.schemas.CaseListType;
import org.sitaf.schemas.CaseParamInfoType;
import org.sitaf.schemas.CaseType;
import org.sitaf.schemas.GenerationType;
import org.sitaf.schemas.NamedValueType;
import org.sitaf.schemas.StepParamInfoType;
import org.sitaf.schemas.StepType;
import org.sitaf.schemas.TestSuiteDocument;

/** Reads and writes test suite documents (schemas/test_suite_data.xsd). */
public final class TestSuiteXml {
  private static final String ROOT = "test_suite_data";

  private TestSuiteXml() {}

  /**
   * Reads a suite.
   *
   * @param file name of the document, for diagnostics
   * @throws org.sitaf.core.diagnostic.InvalidInputException with all problems of the document
   */
  public static TestSuite read(InputStream document, String file) {
    Diagnostics diagnostics = new Diagnostics();
    TestSuiteDocument root =
        XmlDocuments.read(document, file, ROOT, TestSuiteDocument.class, diagnostics);
    TestSuite suite = new Reading(file, diagnostics).suite(root);
    diagnostics.throwIfErrors();
    return suite;
  }

  /** Writes a suite. The same suite gives the same bytes. */
  public static void write(TestSuite suite, OutputStream out) {
    TestSuiteDocument root = new TestSuiteDocument();
    root.setName(suite.name());
    root.setDescription(suite.description());
    root.setTestModelName(suite.modelName());
    GenerationType generation = new GenerationType();
    generation.setOrderOfCombinations(suite.generation().strength().text());
    generation.setInvalidValues(suite.generation().invalidValues().text());
    generation.setSeed(suite.generation().seed());
    generation.setEffort(suite.generation().effort());
    generation.setGenerator(suite.generation().generator());
    generation.setMaxCases(suite.generation().maxCases());
    if (suite.generation().tuples() != null) {
      generation.setTuples(suite.generation().tuples().text());
    }
    root.setGeneration(generation);
    root.setCaseParamInfo(write(suite.parameters()));
    if (suite.isOfSequences()) {
      root.setStepParamInfo(writeSteps(suite.stepParameters()));
    }
    root.setCaseList(new LazyCases(suite.cases()));
    XmlDocuments.write(ROOT, TestSuiteDocument.class, root, rows(suite), out);
  }

  /** The elements that are written on one line: a whole case, or a step of it. */
  private static Set<String> rows(TestSuite suite) {
    return suite.isOfSequences()
        ? Set.of("step", "param", "generation", "value")
        : Set.of("case", "param", "generation");
  }

  private static StepParamInfoType writeSteps(List<StepParameters> steps) {
    StepParamInfoType info = new StepParamInfoType();
    for (StepParameters parameters : steps) {
      StepParamInfoType.Step step = new StepParamInfoType.Step();
      step.setName(parameters.name());
      write(parameters.parameters(), step);
      info.getSteps().add(step);
    }
    return info;
  }

  /** Converts parameters to {@code case_param_info}. */
  public static CaseParamInfoType write(List<CaseParameter> parameters) {
    CaseParamInfoType info = new CaseParamInfoType();
    write(parameters, info);
    return info;
  }

  private static void write(List<CaseParameter> parameters, CaseParamInfoType info) {
    for (CaseParameter parameter : parameters) {
      CaseParamInfoType.Param param = new CaseParamInfoType.Param();
      param.setName(parameter.name());
      param.setType(parameter.kind().name());
      param.setRealType(parameter.realType());
      info.getParams().add(param);
    }
  }

  /** Reads the parameters of {@code case_param_info}. Problems are added to the diagnostics. */
  public static List<CaseParameter> read(
      @org.jspecify.annotations.Nullable CaseParamInfoType info,
      String file,
      Diagnostics diagnostics) {
    List<CaseParameter> parameters = new ArrayList<>();
    if (info != null) {
      for (CaseParamInfoType.Param param : info.getParams()) {
        String type = String.valueOf(param.getType()).toUpperCase(Locale.ROOT);
        String name = param.getName();
        if (name == null || !List.of("TDI", "TDSD", "TDS", "TDTS").contains(type)) {
          diagnostics.error(
              file,
              XmlDocuments.line(param),
              "param " + name,
              "needs a name and a type of TDI, TDSD or TDTS");
        } else {
          parameters.add(
              new CaseParameter(
                  name,
                  type.equals("TDS") ? InputKind.TDSD : InputKind.valueOf(type),
                  param.getRealType() == null ? "" : param.getRealType()));
        }
      }
    }
    return parameters;
  }

  /** Converts each case to an element only while it is written, to save memory. */
  private static final class LazyCases extends CaseListType {
    LazyCases(List<TestCase> of) {
      cases =
          new AbstractList<>() {
            @Override
            public CaseType get(int index) {
              return write(of.get(index));
            }

            @Override
            public int size() {
              return of.size();
            }
          };
    }
  }

  private static CaseType write(TestCase testCase) {
    CaseType element = new CaseType();
    element.setNo(testCase.no());
    element.setCaseClass(testCase.valid() ? "valid" : "invalid");
    element.getValues().addAll(testCase.values());
    testCase.steps().forEach(step -> element.getSteps().add(write(step)));
    testCase.expected().forEach(e -> element.getExpected().add(write(e)));
    return element;
  }

  private static StepType write(TestStep step) {
    StepType element = new StepType();
    element.setName(step.name());
    element.setStepClass(step.valid() ? null : "invalid");
    element.getValues().addAll(step.values());
    step.expected().forEach(e -> element.getExpected().add(write(e)));
    return element;
  }

  private static NamedValueType write(ExpectedValue expected) {
    NamedValueType value = new NamedValueType();
    value.setName(expected.output().isEmpty() ? null : expected.output());
    value.setValue(expected.literal());
    return value;
  }

  private record Reading(String file, Diagnostics diagnostics) {
    TestSuite suite(TestSuiteDocument root) {
      List<CaseParameter> parameters = read(root.getCaseParamInfo(), file, diagnostics);
      List<StepParameters> steps = new ArrayList<>();
      if (root.getStepParamInfo() != null) {
        for (StepParamInfoType.Step step : root.getStepParamInfo().getSteps()) {
          steps.add(
              new StepParameters(String.valueOf(step.getName()), read(step, file, diagnostics)));
        }
      }
      List<TestCase> cases = new ArrayList<>();
      Set<Integer> numbers = new java.util.HashSet<>();
      if (root.getCaseList() != null) {
        for (CaseType element : root.getCaseList().getCases()) {
          addCase(element, parameters.size(), steps, numbers, cases);
        }
      }
      String model = root.getTestModelName() == null ? "" : root.getTestModelName();
      return new TestSuite(
          root.getName() == null ? model : root.getName(),
          root.getDescription() == null ? "" : root.getDescription(),
          model,
          generation(root.getGeneration()),
          parameters,
          steps,
          diagnostics.hasErrors() ? List.of() : cases);
    }

    private void addCase(
        CaseType element,
        int parameters,
        List<StepParameters> kinds,
        Set<Integer> numbers,
        List<TestCase> cases) {
      int no = element.getNo() == null ? cases.size() + 1 : element.getNo();
      int line = XmlDocuments.line(element);
      String where = "case " + no;
      if (no < 1 || !numbers.add(no)) {
        diagnostics.error(file, line, where, "case numbers must be at least 1 and unique");
      } else if (element.getValues().size() != parameters) {
        diagnostics.error(
            file,
            line,
            where,
            "has " + element.getValues().size() + " values for " + parameters + " parameters");
      } else {
        cases.add(
            new TestCase(
                no,
                !"invalid".equals(element.getCaseClass()),
                element.getValues(),
                expected(element.getExpected()),
                steps(element, where, kinds)));
      }
    }

    private List<TestStep> steps(CaseType element, String where, List<StepParameters> kinds) {
      List<TestStep> steps = new ArrayList<>();
      for (StepType step : element.getSteps()) {
        String name = String.valueOf(step.getName());
        Optional<StepParameters> kind =
            kinds.stream().filter(k -> k.name().equals(name)).findFirst();
        if (kind.isEmpty() || kind.get().parameters().size() != step.getValues().size()) {
          diagnostics.error(
              file,
              XmlDocuments.line(step),
              where + "/step " + name,
              kind.isEmpty()
                  ? "is not described in step_param_info"
                  : "has "
                      + step.getValues().size()
                      + " values for "
                      + kind.get().parameters().size()
                      + " parameters");
        }
        steps.add(
            new TestStep(
                name,
                !"invalid".equals(step.getStepClass()),
                step.getValues(),
                expected(step.getExpected())));
      }
      return steps;
    }

    private static List<ExpectedValue> expected(List<NamedValueType> values) {
      return values.stream()
          .map(
              e ->
                  new ExpectedValue(
                      e.getName() == null ? "" : e.getName(),
                      e.getValue() == null ? "" : e.getValue()))
          .toList();
    }

    private Generation generation(@Nullable GenerationType given) {
      if (given == null) {
        return new Generation(new Strength(1), InvalidValues.ISOLATE, 1, "default", "");
      }
      Strength strength = new Strength(1);
      try {
        if (given.getOrderOfCombinations() != null) {
          strength = Strength.parse(given.getOrderOfCombinations());
        }
      } catch (IllegalArgumentException e) {
        diagnostics.error(
            file, XmlDocuments.line(given), "generation", String.valueOf(e.getMessage()));
      }
      return new Generation(
          strength,
          "combine".equals(given.getInvalidValues())
              ? InvalidValues.COMBINE
              : InvalidValues.ISOLATE,
          given.getSeed() == null ? 1 : given.getSeed(),
          given.getEffort() == null ? "default" : given.getEffort(),
          given.getGenerator() == null ? "" : given.getGenerator(),
          given.getMaxCases(),
          tuples(given));
    }

    private Generation.@Nullable Tuples tuples(GenerationType given) {
      try {
        return given.getTuples() == null ? null : Generation.Tuples.parse(given.getTuples());
      } catch (IllegalArgumentException e) {
        diagnostics.error(
            file, XmlDocuments.line(given), "generation", String.valueOf(e.getMessage()));
        return null;
      }
    }
  }
}
