import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;

/**
 * An activity to edit. It has a small driver instead of a generated one, so that hundreds of builds
 * take minutes; the compile time of generated drivers is not measured here.
 */
final class Project {
  /** Files of the activity, without those that all activities have. */
  final TreeMap<String, byte[]> files = new TreeMap<>();

  /** Entries of the profile. */
  final TreeMap<String, String> component = new TreeMap<>();

  final List<String> libraries = new ArrayList<>();
  final String name;
  final boolean java;
  private String world = "";

  Project(String name, boolean java) {
    this.name = name;
    this.java = java;
    component.put("language", java ? "java" : "cpp");
    component.put("class", java ? "demo.Component" : "Component");
  }

  Project put(String path, String text) {
    files.put(path, text.getBytes(StandardCharsets.UTF_8));
    return this;
  }

  /** Adds a world of the examples in a folder, which ends with a slash or is empty. */
  void world(String folder, Path home) throws IOException {
    world = folder + "ir.world.yaml";
    for (String file : List.of("ir.world.yaml", "ir.xml")) {
      files.put(folder + file, Files.readAllBytes(home.resolve("examples/ir-sensor/world").resolve(file)));
    }
  }

  /** Copies another project. */
  void becomeLike(Project other) {
    files.clear();
    files.putAll(other.files);
    component.clear();
    component.putAll(other.component);
    libraries.clear();
    libraries.addAll(other.libraries);
    world = other.world;
  }

  Project copy() {
    Project copy = new Project(name, java);
    copy.becomeLike(this);
    return copy;
  }

  String sources() {
    return component.get("sources");
  }

  /** The inputs of the Java compiler. */
  String trace() {
    StringBuilder trace = new StringBuilder(component + " " + libraries + "\n");
    files.forEach(
        (path, content) -> {
          boolean read =
              !libraries.isEmpty() && path.endsWith(".jar")
                  || path.startsWith(sources())
                  || component.containsKey("adapter") && path.startsWith(component.get("adapter"));
          if (read) {
            trace.append(path).append(' ').append(Arrays.hashCode(content)).append('\n');
          }
        });
    return trace.toString();
  }

  String text(String path) {
    return new String(files.get(path), StandardCharsets.UTF_8);
  }

  /** The include path, in the order of the command. */
  List<String> includeFolders() {
    List<String> folders = new ArrayList<>(List.of("harness/program", "harness"));
    for (String entry : List.of("adapter", "sources", "headers")) {
      if (component.containsKey(entry)) {
        folders.add("activity/" + component.get(entry).replaceAll("/$", ""));
      }
    }
    return folders;
  }

  /** All files in the layout of an application, as text. */
  Map<String, byte[]> layout() {
    Map<String, byte[]> layout = new TreeMap<>();
    files.forEach((path, content) -> layout.put("activity/" + path, content));
    harness().paths().forEach(p -> layout.put("harness/" + p, harness().content(p).orElseThrow()));
    return layout;
  }

  FileTree harness() {
    Map<String, byte[]> harness = new HashMap<>();
    if (java) {
      harness.put(
          "driver/Driver.java",
          """
          package driver;

          public final class Driver {
            public static void main(String[] arguments) {
              System.out.println(new demo.Component().total());
            }
          }
          """
              .getBytes(StandardCharsets.UTF_8));
    } else {
      harness.put(
          "program/driver.cpp",
          """
          #include "component.hpp"
          int main() { return Component().total() & 127; }
          """
              .getBytes(StandardCharsets.UTF_8));
    }
    return FileTree.of(harness);
  }

  TestApplication application() {
    Map<String, byte[]> all = new HashMap<>(files);
    StringBuilder profile = new StringBuilder("name: " + name + "\ncomponent:\n");
    component.forEach((entry, value) -> profile.append("  " + entry + ": " + value + "\n"));
    profile.append("provided: [Echo.idl.xml]\nmodels: [Echo.xml]\n");
    profile.append("libraries: " + libraries + "\n");
    if (!world.isEmpty()) {
      profile.append("world: " + world + "\n");
    }
    all.put("activity.yaml", profile.toString().getBytes(StandardCharsets.UTF_8));
    all.put("Echo.idl.xml", INTERFACE.getBytes(StandardCharsets.UTF_8));
    all.put("Echo.xml", MODEL.getBytes(StandardCharsets.UTF_8));
    Activity activity = Activity.read(FileTree.of(all));
    TestModel model = activity.model("Echo").orElseThrow();
    return new TestApplication(
        activity,
        model,
        TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite(),
        harness(),
        java ? "driver.Driver" : "program");
  }

  private static final String INTERFACE =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <service_port_type>
        <type_name>EchoService</type_name>
        <method name="echo" return_type="int" call_type="blocking">
          <param index="1"><type>int</type><name>Value</name></param>
        </method>
      </service_port_type>
      """;

  private static final String MODEL =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <test_model>
        <name>Echo</name>
        <description>What goes in comes out</description>
        <target interface="EchoService" method="echo"/>
        <input_spec_list>
          <test_element abstract_type="NUMERIC" real_type="int">
            <name>Value</name>
            <type>TDI</type>
            <user_value_list><value>1</value></user_value_list>
          </test_element>
        </input_spec_list>
        <output_spec_list>
          <test_element abstract_type="NUMERIC" real_type="int">
            <name>return</name>
            <type>RETURN</type>
            <expected>Value</expected>
          </test_element>
        </output_spec_list>
        <order_of_combinations>1</order_of_combinations>
      </test_model>
      """;
}
