package org.sitaf.core.harness.cpp;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.harness.cpp.syntax.ComponentHeader;
import org.sitaf.core.harness.cpp.syntax.CppNames;
import org.sitaf.core.harness.layout.SourcePrinter;
import org.sitaf.core.harness.plan.HarnessPlan;
import org.sitaf.core.harness.plan.HarnessWriter;

/**
 * Generates test applications in C++: test driver, simulation control, test stub, and the concrete
 * test driver that the user may edit (paper, Figs. 10, 13(e) and 16).
 */
public final class CppHarness implements HarnessWriter {
  private static final String CONCRETE = "ConcreteTestDriver.cpp";

  private static final SourcePrinter PRINTER =
      new SourcePrinter(CppHarness.class, CppLayout::format);

  private final Activity activity;

  /** Creates a writer. The header of the component is searched in the activity. */
  public CppHarness(Activity activity) {
    this.activity = activity;
  }

  @Override
  public FileTree write(HarnessPlan plan, Diagnostics diagnostics) {
    new CppChecks(diagnostics).check(plan);
    Optional<String> header = ComponentHeader.find(activity, diagnostics);
    if (header.isEmpty() || diagnostics.hasErrors()) {
      return FileTree.of(Map.of());
    }
    CppPlan planned = CppPlan.of(plan, header.get());
    String folder = planned.namespace() + "/";
    Map<String, byte[]> files = new HashMap<>();
    boolean sequence = planned.isSequence();
    for (String extension : new String[] {".hpp", ".cpp"}) {
      files.put(
          folder + "SimulationControl" + extension,
          print("SimulationControl" + extension, SimulationControlView.of(planned)));
      files.put(
          folder + "TestStub" + extension, print("TestStub" + extension, TestStubView.of(planned)));
      files.put(
          folder + "TestDriver" + extension,
          sequence
              ? print("SequenceDriver" + extension, SequenceDriverView.of(planned))
              : print("TestDriver" + extension, TestDriverView.of(planned)));
    }
    files.put(folder + CONCRETE, print(CONCRETE, ConcreteTestDriverView.of(planned)));
    interfaces(plan, files);
    return FileTree.of(files);
  }

  /** Generates the interfaces and types that the test shares with the component. */
  private static void interfaces(HarnessPlan plan, Map<String, byte[]> files) {
    if (plan.component().adapter() != null) {
      for (InterfaceDescription provided : plan.provided()) {
        put(
            files,
            provided.name(),
            "Interface",
            InterfaceView.of(provided.name(), provided.source(), provided.methods(), false));
      }
    }
    for (HarnessPlan.Stub stub : plan.stubs()) {
      var methods = stub.methods().stream().map(HarnessPlan.StubMethod::method).toList();
      put(
          files,
          stub.name(),
          "Interface",
          InterfaceView.of(stub.name(), stub.source(), methods, true));
    }
    for (DataType type : plan.types()) {
      put(files, CppNames.DECLARED.type(type), "Type", TypeView.of(type));
    }
    for (String error : plan.errors()) {
      put(files, error, "Type", TypeView.ofError(error));
    }
  }

  private static void put(Map<String, byte[]> files, String name, String template, Object view) {
    files.put("sitaf/interfaces/" + name + ".hpp", print(template + ".hpp", view));
  }

  @Override
  public FileTree adapter(HarnessPlan.Adapter plan, Diagnostics diagnostics) {
    new CppChecks(diagnostics).check(plan);
    if (diagnostics.hasErrors()) {
      return FileTree.of(Map.of());
    }
    AdapterView view = AdapterView.of(plan);
    return FileTree.of(
        Map.of(
            view.file() + ".hpp", print("Adapter.hpp", view),
            view.file() + ".cpp", print("Adapter.cpp", view)));
  }

  @Override
  public String entryPoint(String modelName) {
    return CppNames.namespace(modelName);
  }

  @Override
  public String editableFile(String modelName) {
    return CppNames.namespace(modelName) + "/" + CONCRETE;
  }

  private static byte[] print(String template, Object view) {
    return PRINTER.print(template, view);
  }
}
