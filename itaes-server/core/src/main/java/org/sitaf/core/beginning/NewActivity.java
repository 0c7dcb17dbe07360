package org.sitaf.core.beginning;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;

/**
 * What a new activity is made of.
 *
 * @param name name of the activity
 * @param className class of the component in the form of its language; null for a default
 * @param provided paths of the interface files in the activity
 * @param interfaces what these files provide
 * @param files interface files, and files of the robot
 * @param installed interface files of ROS 2 that the activity may use without containing them
 * @param world path of the world description among the files, or null
 */
public record NewActivity(
    String name,
    Language language,
    @Nullable String className,
    List<String> provided,
    List<InterfaceDescription> interfaces,
    FileTree files,
    FileTree installed,
    @Nullable String world) {
  private static final int MAX_MODELS = 100;
  private static final String XML = ".xml";

  public NewActivity {
    provided = List.copyOf(provided);
    interfaces = List.copyOf(interfaces);
  }

  /** Whether all types are defined; the other methods cannot be tested. */
  private static boolean isKnown(Method method) {
    return !method.returnType().holdsUnknown()
        && method.parameters().stream().noneMatch(p -> p.type().holdsUnknown());
  }

  /**
   * Proposes the activity: it runs without changes, and comments mark where a person decides.
   *
   * @throws InvalidInputException if the interfaces cannot be tested in the language
   */
  public Proposal propose() {
    List<InterfaceDescription> testable =
        interfaces.stream().map(i -> i.withMethods(NewActivity::isKnown)).toList();
    if (testable.stream().allMatch(i -> i.methods().isEmpty())) {
      throw InvalidInputException.of(
          provided.isEmpty() ? "interface" : provided.get(0),
          "contains no interface with a method whose types are all defined; name a file with a"
              + " service, an action or an interface, next to the files that it refers to");
    }
    Map<String, byte[]> all = new HashMap<>();
    files.paths().forEach(path -> all.put(path, files.content(path).orElseThrow()));
    List<String> models = new ArrayList<>();
    modelTexts(testable)
        .forEach(
            (model, text) -> {
              models.add(model + XML);
              all.put(model + XML, text.getBytes(StandardCharsets.UTF_8));
            });
    all.put("activity.yaml", profile(models).getBytes(StandardCharsets.UTF_8));
    FileTree withoutComponent = FileTree.of(all);
    Activity activity = Activity.readWithoutComponent(withoutComponent, installed);
    FileTree proposed =
        withoutComponent.with("", InterfaceTestApplicationGenerator.component(activity));
    verify(Activity.read(proposed, installed));
    return new Proposal(proposed, leftOut(testable, models.size()));
  }

  private List<String> leftOut(List<InterfaceDescription> testable, int models) {
    List<String> notes = new ArrayList<>();
    for (InterfaceDescription provided : interfaces) {
      for (Method method : provided.methods()) {
        if (!isKnown(method)) {
          notes.add(
              "%s of %s is left out, because a type of it is not defined; add the file that defines it"
                  .formatted(method.name(), provided.name()));
        }
      }
    }
    int methods = testable.stream().mapToInt(provided -> provided.methods().size()).sum();
    if (methods > models) {
      notes.add(
          "only %d of the %d methods have a test model; add one for each other that you test"
              .formatted(models, methods));
    }
    return notes;
  }

  /** Reports what the language cannot express before anything is written. */
  private static void verify(Activity activity) {
    for (TestModel model : activity.models()) {
      var suite = TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
      var unused = InterfaceTestApplicationGenerator.sources(activity, model, suite);
    }
  }

  private Map<String, String> modelTexts(List<InterfaceDescription> testable) {
    Map<String, String> models = new TreeMap<>();
    Set<String> names = new HashSet<>();
    // A profile in XML can have the name of its method.
    files.paths().stream()
        .filter(path -> path.endsWith(XML))
        .forEach(
            path ->
                names.add(
                    path.substring(0, path.length() - XML.length()).toLowerCase(Locale.ROOT)));
    for (InterfaceDescription provided : testable) {
      for (Method method : provided.methods()) {
        String base =
            names.contains(method.name().toLowerCase(Locale.ROOT))
                ? provided.name() + "_" + method.name()
                : method.name();
        String model = base;
        // File names that differ in case only are one file on some systems.
        for (int i = 2; !names.add(model.toLowerCase(Locale.ROOT)); i++) {
          model = base + "_" + i;
        }
        if (models.size() < MAX_MODELS) {
          models.put(model, ModelProposal.of(provided, method, model));
        }
      }
    }
    for (InterfaceDescription provided : testable) {
      String model = "Sequences";
      for (int i = 2; names.contains(model.toLowerCase(Locale.ROOT)); i++) {
        model = "Sequences_" + i;
      }
      Optional<String> text = SequenceProposal.of(provided, model);
      if (text.isPresent() && models.size() < MAX_MODELS) {
        names.add(model.toLowerCase(Locale.ROOT));
        models.put(model, text.get());
      }
    }
    return models;
  }

  private String profile(List<String> models) {
    StringBuilder text = new StringBuilder();
    text.append("name: ").append(YamlScalar.of(name)).append('\n');
    text.append("description: \"\"   # Say in one sentence what is tested.\n");
    text.append("component:\n");
    text.append("  language: ").append(language.name().toLowerCase(Locale.ROOT)).append('\n');
    text.append("  # A skeleton. Replace it by the sources of your component and its class.\n");
    text.append("  sources: component/\n");
    text.append("  class: ").append(YamlScalar.of(chosenClass())).append('\n');
    text.append("  # If names or types differ from the interface: adapter: adapter/, then\n");
    text.append("  # ./sitaf harness FOLDER --adapter.\n");
    text.append("provided: [").append(scalars(provided)).append("]\n");
    text.append("# Interfaces that the component calls; the test stub implements them.\n");
    text.append("required: []\n");
    if (world == null) {
      text.append("# A simulation, if the component uses sensors or actuators:\n");
      text.append("# world: world/NAME.world.yaml\n");
    } else {
      text.append("world: ").append(YamlScalar.of(world)).append('\n');
    }
    text.append("models: [").append(scalars(models)).append("]\n");
    text.append("limits: {case_wall_s: 10}\n");
    return text.toString();
  }

  private static String scalars(List<String> paths) {
    return paths.stream().map(YamlScalar::of).collect(Collectors.joining(", "));
  }

  private String chosenClass() {
    if (className != null) {
      return className;
    }
    String simple = interfaces.get(0).name().replaceAll("\\W+", "_") + "Component";
    return switch (language) {
      case JAVA -> "component." + simple;
      case CPP -> "component::" + simple;
      case PYTHON -> "component." + simple;
    };
  }
}
