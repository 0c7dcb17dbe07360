package org.sitaf.core.activity;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.hardware.HardwareReader;
import org.sitaf.core.activity.lock.ActivityLock;
import org.sitaf.core.activity.ros.NodeSources;
import org.sitaf.core.activity.ros.RosInterfaces;
import org.sitaf.core.activity.ros.RosNode;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.description.WorldReader;
import org.sitaf.core.description.importer.InterfaceFiles;
import org.sitaf.core.description.source.ComponentDescription.Port;
import org.sitaf.core.description.source.ImportResult;
import org.sitaf.core.description.source.SourceFiles;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;
import org.sitaf.core.suite.TestCaseGenerator;

/**
 * Reads all documents of an activity and verifies them against each other. All problems are
 * reported at once.
 */
final class ActivityReader {
  /** The profile, which every activity must have. */
  static final String PROFILE = "activity.yaml";

  /** Maximum number of models, of provided and of required interface files. */
  private static final int MAX_DOCUMENTS = 500;

  /** A service or action of ROS 2; its package is the first group. */
  private static final Pattern ROS_FILE =
      Pattern.compile("(?:.*/)?(\\w+)/(?:msg|srv|action)/\\w+\\.(?:msg|srv|action)");

  private final FileTree files;

  /** Interface files of a ROS 2 release. */
  private final FileTree packages;

  private final Diagnostics diagnostics = new Diagnostics();

  ActivityReader(FileTree files, FileTree packages) {
    this.files = files;
    this.packages = packages;
  }

  Activity read() {
    return read(true);
  }

  Activity readWithoutComponent() {
    return read(false);
  }

  private Activity read(boolean withComponent) {
    String text =
        files
            .text(PROFILE)
            .orElseThrow(
                () ->
                    InvalidInputException.of(
                        PROFILE, "is missing; an activity must have this file in its root folder"));
    ActivityProfile profile = ProfileReader.read(text, PROFILE, diagnostics);
    ActivityLock.of(files, diagnostics);
    requireFew("models", profile.models());
    requireFew("provided", profile.provided());
    requireFew("required", profile.required());
    WorldDescription world = world(profile.world());
    if (world != null) {
      HardwareReader.verify(profile.hardware(), world, files, PROFILE, diagnostics);
    }
    List<InterfaceDescription> services = interfaces(profile.provided(), "provided", profile);
    RosInterfaces ros = profile.ros() == null ? null : ros(profile, profile.ros(), world);
    List<InterfaceDescription> provided = ros == null ? services : ros.provided(services);
    List<InterfaceDescription> required = interfaces(profile.required(), "required", profile);
    List<Port.Data> outputPorts =
        OutputPorts.read(files, profile.provided(), profile.component().profile(), diagnostics);
    List<TestModel> models =
        models(profile.models()).stream()
            .map(m -> InterfaceTypes.resolve(m, provided, required, outputPorts))
            .toList();
    if (withComponent) {
      ComponentFiles.verify(profile, files, PROFILE, diagnostics);
    }
    if (!diagnostics.hasErrors()) {
      for (TestModel model : models) {
        diagnostics.addAll(TestCaseGenerator.verifyConditions(model));
        diagnostics.addAll(
            ModelAgainstActivity.verify(
                model,
                provided,
                required,
                world,
                outputPorts,
                profile,
                ros == null ? null : ros.messages()));
      }
    }
    diagnostics.throwIfErrors();
    return new Activity(
        profile, files, provided, required, outputPorts, world, models, ros, diagnostics.all());
  }

  private RosInterfaces ros(
      ActivityProfile profile, RosNode node, @Nullable WorldDescription world) {
    String sources = profile.component().sources();
    FileTree component = files.below(sources == null ? "" : sources);
    List<String> texts =
        component.paths().stream()
            .filter(path -> NodeSources.isSource(path, node.isCpp()))
            .map(path -> component.text(path).orElseThrow())
            .toList();
    Set<String> used = new HashSet<>();
    for (List<String> paths : List.of(profile.provided(), profile.required())) {
      paths.stream()
          .filter(path -> path.indexOf('/') > 0)
          .forEach(path -> used.add(path.substring(0, path.indexOf('/'))));
    }
    Map<String, byte[]> installed = new HashMap<>();
    packages.paths().forEach(path -> installed.put(path, packages.content(path).orElseThrow()));
    Map<String, byte[]> own = interfaceFiles(files, List.of());
    files.paths().stream()
        .filter(path -> path.equals("package.xml") || path.endsWith("/package.xml"))
        .forEach(path -> own.put(path, files.content(path).orElseThrow()));
    return RosInterfaces.resolve(
        node, texts, profile.required(), used, own, installed, world, PROFILE, diagnostics);
  }

  /** Limits the time that a server spends on one activity. */
  private static void requireFew(String entry, List<String> documents) {
    if (documents.size() > MAX_DOCUMENTS) {
      throw new InvalidInputException(
          List.of(
              Diagnostic.error(
                  PROFILE,
                  0,
                  entry,
                  "lists %d documents, but at most %d are allowed; split the activity"
                      .formatted(documents.size(), MAX_DOCUMENTS))));
    }
  }

  private List<InterfaceDescription> interfaces(
      List<String> paths, String entry, ActivityProfile profile) {
    List<String> present = new ArrayList<>();
    for (String path : paths) {
      if (files.contains(path) || packages.contains(path)) {
        present.add(path);
      } else {
        missing(path, entry);
      }
    }
    List<String> installed = present.stream().filter(path -> !files.contains(path)).toList();
    List<String> own = present.stream().filter(files::contains).toList();
    Map<String, byte[]> sources = interfaceFiles(files, own);
    if (!installed.isEmpty() || own.stream().anyMatch(path -> ROS_FILE.matcher(path).matches())) {
      addInstalled(sources);
    }
    ImportResult result =
        InterfaceFiles.read(
            SourceFiles.of(profile.name(), sources, present).including(profile.idlIncludes()));
    diagnostics.addAll(result.diagnostics());
    // A component profile distinguishes provided and required interfaces.
    List<InterfaceDescription> interfaces =
        entry.equals("required") && !result.components().isEmpty()
            ? result.required()
            : result.provided();
    interfaces.forEach(description -> ArraySizes.verify(description, diagnostics));
    Set<String> names = new HashSet<>();
    for (InterfaceDescription description : interfaces) {
      if (!names.add(description.name())) {
        diagnostics.error(
            description.source(),
            0,
            description.name(),
            "another " + entry + " interface has this name");
      }
    }
    return interfaces;
  }

  /** Adds the installed interface packages of ROS 2 that the activity does not have itself. */
  private void addInstalled(Map<String, byte[]> sources) {
    Set<String> own = new HashSet<>();
    for (String path : sources.keySet()) {
      Matcher parts = ROS_FILE.matcher(path);
      if (parts.matches()) {
        own.add(parts.group(1));
      }
    }
    packages.paths().stream()
        .filter(path -> !own.contains(path.substring(0, Math.max(0, path.indexOf('/')))))
        .forEach(path -> sources.putIfAbsent(path, packages.content(path).orElseThrow()));
  }

  /** All files that may contain interfaces, and the named files. */
  static Map<String, byte[]> interfaceFiles(FileTree files, List<String> named) {
    Map<String, byte[]> sources = new HashMap<>();
    files.paths().stream()
        .filter(InterfaceFiles::isSupported)
        .forEach(path -> sources.put(path, files.content(path).orElseThrow()));
    named.forEach(path -> sources.put(path, files.content(path).orElseThrow()));
    return sources;
  }

  private @Nullable WorldDescription world(@Nullable String path) {
    return path == null
        ? null
        : document(path, "world", p -> WorldReader.read(files.text(p).orElseThrow(), p))
            .orElse(null);
  }

  private List<TestModel> models(List<String> paths) {
    List<TestModel> all = new ArrayList<>();
    Set<String> names = new HashSet<>();
    for (String path : paths) {
      document(path, "models", p -> TestModelXml.read(files.open(p).orElseThrow(), p))
          .ifPresent(
              model -> {
                if (!names.add(model.name())) {
                  diagnostics.error(path, 0, "name", "two models are named " + model.name());
                }
                all.add(model);
              });
    }
    return all;
  }

  private <T> Optional<T> document(String path, String entry, Function<String, T> reader) {
    if (!files.contains(path)) {
      missing(path, entry);
      return Optional.empty();
    }
    try {
      return Optional.of(reader.apply(path));
    } catch (InvalidInputException e) {
      diagnostics.addAll(e.diagnostics());
      return Optional.empty();
    }
  }

  private void missing(String path, String entry) {
    diagnostics.error(PROFILE, 0, entry, "'" + path + "' does not exist in the activity");
  }
}
