package org.sitaf.core.harness.python;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.description.DataType;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.harness.layout.SourcePrinter;
import org.sitaf.core.harness.plan.HarnessPlan;
import org.sitaf.core.harness.plan.HarnessWriter;

/**
 * Generates test applications in Python: test driver, simulation control, test stub, the concrete
 * test driver that the user may edit, and the package {@code sitaf_interfaces} with the interfaces
 * and types that they share with the component.
 */
public final class PythonHarness implements HarnessWriter {
  private static final String CONCRETE = "concrete_test_driver";
  private static final String INTERFACES = "sitaf_interfaces/";

  private static final SourcePrinter PRINTER =
      new SourcePrinter(PythonHarness.class, PythonLayout::format);

  @Override
  public FileTree write(HarnessPlan neutral, Diagnostics diagnostics) {
    PythonPlan plan = PythonPlanner.plan(neutral, diagnostics);
    Map<String, byte[]> files = new HashMap<>();
    if (diagnostics.hasErrors()) {
      return FileTree.of(files);
    }
    String folder = folder(neutral.modelName());
    files.put("sitaf_harness/__init__.py", bytes("\"\"\"Test applications.\"\"\"\n"));
    files.put(
        folder + "__init__.py", bytes("\"\"\"The test application of one test model.\"\"\"\n"));
    files.put(
        folder + "test_driver.py",
        plan.isSequence()
            ? print("sequence_driver", SequenceDriverView.of(plan))
            : print("test_driver", TestDriverView.of(plan)));
    files.put(
        folder + "simulation_control.py",
        print("simulation_control", SimulationControlView.of(plan)));
    files.put(folder + "test_stub.py", print("test_stub", TestStubView.of(plan)));
    files.put(editableFile(neutral.modelName()), print(CONCRETE, ConcreteTestDriverView.of(plan)));
    interfaces(plan, files);
    return FileTree.of(files);
  }

  /**
   * Generates the interfaces and types that the test shares with the component, if there are any.
   */
  private static void interfaces(PythonPlan plan, Map<String, byte[]> files) {
    HarnessPlan neutral = plan.neutral();
    StringBuilder exported = new StringBuilder();
    Imports imports = new Imports();
    if (!neutral.types().isEmpty()) {
      files.put(
          INTERFACES + "data_types.py", print("data_types", InterfacesView.DataTypes.of(neutral)));
      for (DataType type : neutral.types()) {
        imports.add("sitaf_interfaces.data_types", PythonNames.DECLARED.type(type));
      }
    }
    if (!neutral.errors().isEmpty()) {
      files.put(INTERFACES + "errors.py", print("errors", Map.of("errors", neutral.errors())));
      neutral.errors().forEach(e -> imports.add("sitaf_interfaces.errors", e));
    }
    for (PythonPlan.Stub stub : plan.stubs()) {
      files.put(
          INTERFACES + stub.name() + ".py",
          print("required_interface", InterfacesView.Interface.of(stub)));
      imports.add("sitaf_interfaces." + stub.name(), stub.name());
    }
    if (!imports.isEmpty()) {
      exported
          .append("\"\"\"Interfaces and types that the component shares with the test.\"\"\"\n\n")
          .append(imports.text())
          .append("\n\n")
          .append(imports.all())
          .append('\n');
      files.put(INTERFACES + "__init__.py", bytes(PythonLayout.format(exported.toString())));
    }
  }

  @Override
  public FileTree adapter(HarnessPlan.Adapter plan, Diagnostics diagnostics) {
    AdapterView view = AdapterView.of(plan, diagnostics);
    return diagnostics.hasErrors()
        ? FileTree.of(Map.of())
        : FileTree.of(Map.of(view.module().replace('.', '/') + ".py", print("adapter", view)));
  }

  @Override
  public String entryPoint(String modelName) {
    return PythonPlanner.packageName(modelName) + "." + CONCRETE;
  }

  @Override
  public String editableFile(String modelName) {
    return folder(modelName) + CONCRETE + ".py";
  }

  private static String folder(String modelName) {
    return PythonPlanner.packageName(modelName).replace('.', '/') + "/";
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  private static byte[] print(String template, Object view) {
    return PRINTER.print(template, view);
  }
}
