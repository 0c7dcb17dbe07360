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

/**
 * Takes down what a tool has opened for one application, and says of what was taken down earlier
 * whether the tool would open the same now: the same files with the same content, and no other ones
 * in front of them.
 */
public final class InputCheck {
  /** Stands for every name, where a macro may have given one that no path shows. */
  private static final String ANY = "*";

  private final Path root;
  private final IncludeSearch application;
  private final List<String> machineFolders;
  private final List<String> known;
  private final Machine machine = new Machine();

  /**
   * A check for one compilation.
   *
   * @param root where the application's files lie
   * @param folders where names are looked for, in this order; those of the application come first
   * @param known folders whose content the command stands for already
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
   * What a compiler read.
   *
   * @param included as the compiler noted them, for include directives
   * @param assembled as the assembler noted them
   * @param assemblyNoted whether the assembler does so
   * @param begunMillis when the compiler started; what may have changed since is not certain
   * @return empty where that cannot be said with certainty: what was compiled must not be kept
   */
  public Optional<Inputs> of(
      Collection<String> included,
      Collection<String> assembled,
      boolean assemblyNoted,
      long begunMillis) {
    try {
      return read(included, assembled, assemblyNoted, begunMillis);
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  private Optional<Inputs> read(
      Collection<String> included,
      Collection<String> assembled,
      boolean assemblyNoted,
      long begunMillis)
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
      if (names.unknown() || names.assembly() && !assemblyNoted) {
        return Optional.empty();
      }
    }
    // The assembler looks in the same folders, by names that no directive shows.
    for (String printed : assembled) {
      String path = IncludeSearch.inLayout(printed, root);
      asked.addAll(path == null ? namesOnMachine(printed) : application.namesOf(path));
    }
    if (all.stream().anyMatch(this::isWrittenStrangely)) {
      asked.add(ANY);
    }
    SortedSet<String> looked = new TreeSet<>();
    for (String path : machines) {
      asked.addAll(namesOnMachine(path));
      String folder = path.substring(0, path.lastIndexOf('/'));
      for (Name name : machine.asked(path).names()) {
        asked.add(name.text());
        if (name.quoted()) {
          looked.add(joined(folder, name.folder()));
        }
      }
    }
    looked.addAll(machineFoldersOf(own, asked));
    looked.removeIf(this::isKnown);
    machines.removeIf(this::isKnown);
    return taken(own, machines, looked, asked, begunMillis, machine::sha256);
  }

  /**
   * What a linker opened of this machine; its libraries are large, and linking again costs little,
   * so that any change of theirs counts.
   *
   * @param looked folders in which it may have looked for these files
   * @return empty where that cannot be said with certainty
   */
  public static Optional<Inputs> ofLinker(
      Collection<String> opened, Collection<String> looked, long begunMillis) {
    return opened.stream().allMatch(Machine::isOfSystem)
        ? ofMachine(opened, looked, begunMillis, file -> "")
        : Optional.empty();
  }

  /** What a tool opened of this machine, wherever it lies: nothing of a user's was given to it. */
  public static Optional<Inputs> ofMachine(Collection<String> opened, long begunMillis) {
    return ofMachine(opened, List.of(), begunMillis, new Machine()::sha256);
  }

  private static Optional<Inputs> ofMachine(
      Collection<String> opened, Collection<String> looked, long begunMillis, Digests digests) {
    try {
      return nothing()
          .taken(
              new TreeSet<>(),
              new TreeSet<>(opened),
              new TreeSet<>(looked),
              new TreeSet<>(),
              begunMillis,
              digests);
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  /** What stands for the content of a file of the machine. */
  private interface Digests {
    String of(String path) throws IOException;
  }

  /** Whether a tool that opened files of this machine alone would open the same now. */
  public static boolean isCurrentOnMachine(Inputs inputs) {
    return nothing().isCurrent(inputs);
  }

  private static InputCheck nothing() {
    FileTree none = FileTree.of(Map.of());
    return new InputCheck(none, none, Path.of("/"), List.of(), List.of());
  }

  private Optional<Inputs> taken(
      SortedSet<String> own,
      SortedSet<String> machines,
      SortedSet<String> looked,
      SortedSet<String> asked,
      long begunMillis,
      Digests content)
      throws IOException {
    TreeMap<String, String> digests = new TreeMap<>();
    own.forEach(path -> digests.put(path, application.sha256(path)));
    TreeMap<String, MachineFile> files = new TreeMap<>();
    for (String path : machines) {
      Stamp stamp = machine.stamp(path);
      if (stamp.equals(Stamp.NONE) || stamp.mayBeYoungerThan(begunMillis)) {
        return Optional.empty();
      }
      files.put(path, new MachineFile(stamp, content.of(path)));
    }
    TreeMap<String, Stamp> folders = new TreeMap<>();
    for (String folder : looked) {
      Stamp stamp = machine.stamp(folder);
      if (stamp.mayBeYoungerThan(begunMillis)) {
        return Optional.empty();
      }
      folders.put(folder, stamp);
    }
    return Optional.of(
        new Inputs(digests, files, folders, new TreeSet<>(asked), found(own, asked)));
  }

  /** Whether a tool would open the same now. */
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
    return found(inputs.application().navigableKeySet(), inputs.asked()).equals(inputs.found());
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

  /**
   * Digest of what all names mean in the application that these files of it, and others, ask for.
   */
  private String found(SortedSet<String> own, SortedSet<String> asked) {
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
    return Machine.sha256(text.toString().getBytes(StandardCharsets.UTF_8));
  }

  /** What a file may mean by names that macros give: those of all that was opened. */
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

  /** Whether the name in an include directive may be another than the path shows. */
  private boolean isWrittenStrangely(String printed) {
    return IncludeSearch.inLayout(printed, root) != null
        && (printed.contains("/./") || printed.contains("/../") || printed.contains("//"));
  }

  private static void append(StringBuilder text, @Nullable String path) {
    text.append(path == null ? "" : path).append('\n');
  }

  /** Folders of the machine in which any of the names was, or would have been, looked for. */
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
