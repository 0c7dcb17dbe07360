package org.sitaf.core.harness.java;

import java.util.HashMap;
import java.util.Map;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.harness.java.plan.JavaDeclaredType;
import org.sitaf.core.harness.java.plan.JavaPlan;
import org.sitaf.core.harness.java.plan.JavaPlanner;
import org.sitaf.core.harness.java.plan.JavaType;
import org.sitaf.core.harness.layout.SourcePrinter;
import org.sitaf.core.harness.plan.HarnessPlan;
import org.sitaf.core.harness.plan.HarnessWriter;

/**
 * Generates test applications in Java: test driver, simulation control, test stub, and the concrete
 * test driver that the user may edit (paper, Figs. 10, 13(e) and 16).
 */
public final class JavaHarness implements HarnessWriter {
  private static final String CONCRETE = "ConcreteTestDriver";

  private static final String INTERFACES = JavaType.INTERFACES.replace('.', '/') + "/";

  private static final SourcePrinter PRINTER =
      new SourcePrinter(JavaHarness.class, JavaLayout::format);

  @Override
  public FileTree write(HarnessPlan neutral, Diagnostics diagnostics) {
    JavaPlan plan = JavaPlanner.plan(neutral, diagnostics);
    Map<String, byte[]> files = new HashMap<>();
    if (diagnostics.hasErrors()) {
      return FileTree.of(files);
    }
    String folder = folder(plan.modelName());
    files.put(
        folder + "TestDriver.java",
        plan.isSequence()
            ? print("SequenceDriver", SequenceDriverView.of(plan))
            : print("TestDriver", TestDriverView.of(plan)));
    files.put(
        folder + "SimulationControl.java",
        print("SimulationControl", SimulationControlView.of(plan)));
    files.put(folder + "TestStub.java", print("TestStub", TestStubView.of(plan)));
    files.put(editableFile(plan.modelName()), print(CONCRETE, ConcreteTestDriverView.of(plan)));
    for (JavaPlan.Interface described : plan.interfaces()) {
      files.put(
          INTERFACES + described.name() + ".java", print("Interface", InterfaceView.of(described)));
    }
    for (JavaDeclaredType type : plan.types()) {
      files.put(
          INTERFACES + type.name() + ".java", print("DeclaredType", DeclaredTypeView.of(type)));
    }
    for (String error : plan.errors()) {
      files.put(INTERFACES + error + ".java", print("DeclaredError", Map.of("name", error)));
    }
    return FileTree.of(files);
  }

  @Override
  public FileTree adapter(HarnessPlan.Adapter plan, Diagnostics diagnostics) {
    AdapterView view = AdapterView.of(plan, diagnostics);
    return diagnostics.hasErrors()
        ? FileTree.of(Map.of())
        : FileTree.of(Map.of(plan.className().replace('.', '/') + ".java", print("Adapter", view)));
  }

  @Override
  public String entryPoint(String modelName) {
    return JavaPlanner.packageName(modelName) + "." + CONCRETE;
  }

  @Override
  public String editableFile(String modelName) {
    return folder(modelName) + CONCRETE + ".java";
  }

  private static String folder(String modelName) {
    return JavaPlanner.packageName(modelName).replace('.', '/') + "/";
  }

  private static byte[] print(String template, Object view) {
    return PRINTER.print(template, view);
  }
}
