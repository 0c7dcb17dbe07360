package org.sitaf.agent.toolchain.cpp.inputs;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.toolchain.cpp.inputs.AskedNames.Name;
import org.sitaf.agent.toolchain.cpp.inputs.Inputs.MachineFile;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.digest.Sha256;

/**
 * Records the files that a tool opened for one application, and checks later whether the tool would
 * open the same files with the same content, that is, that no file has changed and none would be
 * found before another.
 */
public final class InputCheck {
  /** Stands for all names, if a macro may have produced the name. */
  private static final String ANY = "*";

  private final Path root;
  private final IncludeSearch application;
  private final List<String> machineFolders;
  private final List<String> known;
  private final Machine machine = new Machine();

  /**
   * Creates a check for one compilation.
   *
   * @param root folder of the application's files
   * @param folders the include path after the application's folders, in order
   * @param known folders whose content is covered by the command's key
   */
  public InputCheck(
      FileTree harness, FileTree activity, Path root, List<Path> folders, List<Path> known) {
    this.root = root;
    this.known = known.stream().map(folder -> folder + "/").toList();
    List<String> own = new ArrayList<>();
    List<String> machines = new ArrayList<>();
    for (Path folder : folders) {
      String inLayout = IncludeSearch.inLayout(folder.toString(), root);
      if (inLayout != null) {
        own.add(inLayout);
      } else if (!known.contains(folder)) {
        machines.add(folder.toString());
      }
    }
    this.application = new IncludeSearch(harness, activity, own);
    this.machineFolders = List.copyOf(machines);
  }

  /**
   * The inputs of a compiler.
   *
   * @param included files that the compiler listed
   * @param assembled files that the assembler listed
   * @param assemblerListsInputs whether the assembler lists its inputs
   * @param startMillis start of the compiler; later changes make the inputs uncertain
   * @return empty if the inputs are uncertain, so that the result must not be cached
   */
  public Optional<Inputs> of(
      Collection<String> included,
      Collection<String> assembled,
      boolean assemblerListsInputs,
      long startMillis) {
    try {
      return read(included, assembled, assemblerListsInputs, startMillis);
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  private Optional<Inputs> read(
      Collection<String> included,
      Collection<String> assembled,
      boolean assemblerListsInputs,
      long startMillis)
      throws IOException {
    SortedSet<String> own = new TreeSet<>();
    SortedSet<String> machines = new TreeSet<>();
    SortedSet<String> asked = new TreeSet<>();
    List<String> all = new ArrayList<>(included);
    all.addAll(assembled);
    for (String printed : all) {
      String path = IncludeSearch.inLayout(printed, root);
      if (path != null && application.contains(path)) {
        own.add(path);
      } else if (path == null && (isKnown(printed) || Machine.isOfSystem(printed))) {
        machines.add(printed);
      } else {
        return Optional.empty();
      }
    }
    for (String path : own) {
      AskedNames names = application.asked(path);
      if (names.unknown() || names.assembly() && !assemblerListsInputs) {
        return Optional.empty();
      }
    }
    // The assembler searches the same folders for names that no directive shows.
    for (String printed : assembled) {
      String path = IncludeSearch.inLayout(printed, root);
      asked.addAll(path == null ? namesOnMachine(printed) : application.namesOf(path));
    }
    if (all.stream().anyMatch(this::isUnusualName)) {
      asked.add(ANY);
    }
    SortedSet<String> searched = new TreeSet<>();
    for (String path : machines) {
      asked.addAll(namesOnMachine(path));
      String folder = path.substring(0, path.lastIndexOf('/'));
      for (Name name : machine.asked(path).names()) {
        asked.add(name.text());
        if (name.quoted()) {
          searched.add(joined(folder, name.folder()));
        }
      }
    }
    searched.addAll(machineFoldersOf(own, asked));
    searched.removeIf(this::isKnown);
    machines.removeIf(this::isKnown);
    return record(own, machines, searched, asked, startMillis, machine::sha256);
  }

  /**
   * The files of this machine that a linker opened. Any modification counts, because libraries are
   * large and linking again is cheap.
   *
   * @param searched folders in which the linker may have searched these files
   * @return empty if the inputs are uncertain
   */
  public static Optional<Inputs> ofLinker(
      Collection<String> opened, Collection<String> searched, long startMillis) {
    return opened.stream().allMatch(Machine::isOfSystem)
        ? ofMachine(opened, searched, startMillis, file -> "")
        : Optional.empty();
  }

  /** The files of this machine that a tool opened, for tools that got no files of users. */
  public static Optional<Inputs> ofMachine(Collection<String> opened, long startMillis) {
    return ofMachine(opened, List.of(), startMillis, new Machine()::sha256);
  }

  private static Optional<Inputs> ofMachine(
      Collection<String> opened, Collection<String> searched, long startMillis, Digests digests) {
    try {
      return nothing()
          .record(
              new TreeSet<>(),
              new TreeSet<>(opened),
              new TreeSet<>(searched),
              new TreeSet<>(),
              startMillis,
              digests);
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  /** Digest of a file of this machine. */
  private interface Digests {
    String of(String path) throws IOException;
  }

  /** Whether a tool that opened only files of this machine would open the same files now. */
  public static boolean isCurrentOnMachine(Inputs inputs) {
    return nothing().isCurrent(inputs);
  }

  private static InputCheck nothing() {
    FileTree none = FileTree.of(Map.of());
    return new InputCheck(none, none, Path.of("/"), List.of(), List.of());
  }

  private Optional<Inputs> record(
      SortedSet<String> own,
      SortedSet<String> machines,
      SortedSet<String> searched,
      SortedSet<String> asked,
      long startMillis,
      Digests content)
      throws IOException {
    TreeMap<String, String> digests = new TreeMap<>();
    own.forEach(path -> digests.put(path, application.sha256(path)));
    TreeMap<String, MachineFile> files = new TreeMap<>();
    for (String path : machines) {
      Stamp stamp = machine.stamp(path);
      if (stamp.equals(Stamp.NONE) || stamp.mayBeYoungerThan(startMillis)) {
        return Optional.empty();
      }
      files.put(path, new MachineFile(stamp, content.of(path)));
    }
    TreeMap<String, Stamp> folders = new TreeMap<>();
    for (String folder : searched) {
      Stamp stamp = machine.stamp(folder);
      if (stamp.mayBeYoungerThan(startMillis)) {
        return Optional.empty();
      }
      folders.put(folder, stamp);
    }
    return Optional.of(
        new Inputs(digests, files, folders, new TreeSet<>(asked), resolutionDigest(own, asked)));
  }

  /** Whether a tool would open the same files now. */
  public boolean isCurrent(Inputs inputs) {
    for (Map.Entry<String, String> file : inputs.application().entrySet()) {
      if (!application.contains(file.getKey())
          || !application.sha256(file.getKey()).equals(file.getValue())) {
        return false;
      }
    }
    for (Map.Entry<String, Stamp> folder : inputs.folders().entrySet()) {
      if (!machine.stamp(folder.getKey()).equals(folder.getValue())) {
        return false;
      }
    }
    for (Map.Entry<String, MachineFile> file : inputs.files().entrySet()) {
      if (!isCurrent(file.getKey(), file.getValue())) {
        return false;
      }
    }
    return resolutionDigest(inputs.application().navigableKeySet(), inputs.asked())
        .equals(inputs.found());
  }

  private boolean isCurrent(String path, MachineFile then) {
    Stamp now = machine.stamp(path);
    if (now.equals(then.stamp())) {
      return true;
    }
    try {
      return !now.equals(Stamp.NONE)
          && !then.sha256().isEmpty()
          && machine.sha256(path).equals(then.sha256());
    } catch (IOException e) {
      return false;
    }
  }

  /** Digest of the files that all these names refer to in the application. */
  private String resolutionDigest(SortedSet<String> own, SortedSet<String> asked) {
    StringBuilder text = new StringBuilder();
    for (String path : own) {
      AskedNames names = application.asked(path);
      for (Name name : names.names()) {
        append(text, application.find(name, path));
      }
      if (names.computed()) {
        appendComputed(text, path, own, asked);
      }
    }
    application
        .findAll(asked)
        .forEach(
            (name, path) -> {
              append(text, name);
              append(text, path);
            });
    return Sha256.hex(text.toString().getBytes(StandardCharsets.UTF_8));
  }

  /** Appends what a file with computed names may refer to: the names of all opened files. */
  private void appendComputed(
      StringBuilder text, String asking, SortedSet<String> own, SortedSet<String> asked) {
    if (asked.contains(ANY)) {
      application.paths().forEach(path -> append(text, path));
      return;
    }
    SortedSet<String> names = new TreeSet<>(asked);
    String folder = asking.substring(0, asking.lastIndexOf('/') + 1);
    for (String path : own) {
      names.addAll(application.namesOf(path));
      if (path.startsWith(folder)) {
        names.add(path.substring(folder.length()));
      }
    }
    for (String name : names) {
      String path = application.find(new Name(name, true), asking);
      if (path != null) {
        append(text, name);
        append(text, path);
      }
    }
  }

  /** Whether the name in the directive may differ from the printed path. */
  private boolean isUnusualName(String printed) {
    return IncludeSearch.inLayout(printed, root) != null
        && (printed.contains("/./") || printed.contains("/../") || printed.contains("//"));
  }

  private static void append(StringBuilder text, @Nullable String path) {
    text.append(path == null ? "" : path).append('\n');
  }

  /** Folders of this machine in which any of the names was searched. */
  private SortedSet<String> machineFoldersOf(SortedSet<String> own, SortedSet<String> asked) {
    SortedSet<String> parts = new TreeSet<>();
    asked.forEach(name -> parts.add(new Name(name, false).folder()));
    own.forEach(path -> application.asked(path).names().forEach(name -> parts.add(name.folder())));
    SortedSet<String> folders = new TreeSet<>();
    for (String folder : machineFolders) {
      parts.forEach(part -> folders.add(joined(folder, part)));
    }
    return folders;
  }

  private List<String> namesOnMachine(String path) {
    return machineFolders.stream()
        .filter(folder -> path.startsWith(folder + "/"))
        .map(folder -> path.substring(folder.length() + 1))
        .toList();
  }

  private static String joined(String folder, String part) {
    return part.isEmpty() ? folder : folder + "/" + part;
  }

  private boolean isKnown(String path) {
    return known.stream().anyMatch(folder -> (path + "/").startsWith(folder));
  }
}
