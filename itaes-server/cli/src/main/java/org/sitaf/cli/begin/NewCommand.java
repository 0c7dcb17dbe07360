package org.sitaf.cli.begin;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.cli.file.Installation;
import org.sitaf.cli.file.UserFiles;
import org.sitaf.cli.terminal.Printable;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.beginning.NewActivity;
import org.sitaf.core.beginning.Proposal;
import org.sitaf.core.beginning.choice.InterfaceChoice;
import org.sitaf.core.beginning.node.SeveralNodesException;
import org.sitaf.core.diagnostic.InvalidInputException;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Begins an activity that runs at once. */
@Command(
    name = "new",
    description =
        "Writes a complete activity into a new folder: the interface, a test model for each method"
            + " with guessed ranges, the skeleton of a component, and a world with the devices of a"
            + " robot. With --node, the activity of a ROS 2 package as it is. It runs at once; comments mark what you decide. On a terminal it asks for"
            + " what the options do not say. Exit code 2: an input is invalid; nothing was"
            + " written.",
    mixinStandardHelpOptions = true)
public final class NewCommand implements Callable<Integer> {
  private static final String NO_LANGUAGE =
      "is not one of java, cpp and python; for a ROS 2 node use --node PACKAGE";

  @Spec private @Nullable CommandSpec spec;

  @Parameters(paramLabel = "FOLDER", description = "A folder that is empty or does not exist.")
  private Path folder = Path.of("");

  @Option(
      names = "--interface",
      paramLabel = "FILE",
      description =
          "The interface of the component: OPRoS (.xml), .idl, .srv, .action or .proto, or one of"
              + " ROS 2 such as nav_msgs/srv/GetPlan.srv. Default: a small one to change.")
  private @Nullable Path interfaceFile;

  @Option(
      names = "--language",
      paramLabel = "LANGUAGE",
      converter = LanguageConverter.class,
      description = "Language of the component: java, cpp, python. Default: python.")
  private @Nullable Language language;

  @Option(
      names = "--class",
      paramLabel = "NAME",
      description =
          "Class of the component: package.Class, namespace::Class or module.Class. With --node, the"
              + " class or main that is tested if the package holds several.")
  private @Nullable String className;

  @Option(
      names = "--node",
      paramLabel = "PACKAGE",
      description =
          "A ROS 2 package in Python or C++: its folder is copied unchanged, and its topics,"
              + " services, actions and parameters are taken from its sources.")
  private @Nullable Path node;

  @Option(
      names = "--robot",
      paramLabel = "FILE",
      description =
          "A URDF, xacro or MJCF file: the activity gets a world with a device for each joint and"
              + " sensor.")
  private @Nullable Path robot;

  @Option(
      names = "--from",
      paramLabel = "EXAMPLE",
      description = "Copies an example of SITAF instead, such as ir-sensor.")
  private @Nullable String example;

  /** Languages of skeletons; a ROS 2 node exists already. */
  static final class LanguageConverter implements CommandLine.ITypeConverter<Language> {
    @Override
    public Language convert(String name) {
      try {
        return Language.valueOf(name.toUpperCase(Locale.ROOT));
      } catch (IllegalArgumentException e) {
        throw new CommandLine.TypeConversionException("'" + name + "' " + NO_LANGUAGE);
      }
    }
  }

  @Override
  public Integer call() throws IOException, InterruptedException {
    PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
    requireEmpty(folder);
    Proposal proposal;
    if (node != null) {
      proposal = ofNode(node);
    } else if (example != null) {
      proposal = new Proposal(copied(example), List.of());
    } else {
      proposal = proposed(out);
    }
    write(proposal.files());
    summarise(proposal.files(), out);
    proposal.notes().forEach(note -> out.println(Printable.line("  " + note)));
    out.flush();
    return 0;
  }

  private Proposal proposed(PrintWriter out) throws IOException, InterruptedException {
    Installation installation = Installation.current();
    Questions questions = new Questions(System.console(), out);
    if (interfaceFile == null) {
      interfaceFile =
          questions
              .ask("Interface file (.idl, .srv, .action, .proto, .xml)", "a small one to change")
              .map(Path::of)
              .orElse(null);
    }
    Path ros = installation.rosInterfaces();
    FileTree installed = Files.isDirectory(ros) ? UserFiles.folder(ros) : FileTree.of(Map.of());
    InterfaceChoice chosen =
        interfaceFile == null
            ? InterfaceChoice.own()
            : GivenFiles.interfaceOf(interfaceFile, installed);
    if (language == null) {
      language =
          questions
              .ask("Language (java, cpp, python)", "python")
              .map(NewCommand::language)
              .orElse(Language.PYTHON);
    }
    if (robot == null) {
      robot = questions.ask("Robot (URDF, xacro or MJCF)", "none").map(Path::of).orElse(null);
    }
    FileTree files = chosen.files();
    String world = null;
    if (robot != null) {
      RobotWorld proposed = RobotWorld.of(robot, installation);
      files = files.with("", proposed.files());
      world = proposed.path();
    }
    return new NewActivity(
            name(),
            Objects.requireNonNull(language),
            className,
            List.of(chosen.path()),
            chosen.provided(),
            files,
            installed,
            world)
        .propose();
  }

  private Proposal ofNode(Path folder) throws IOException {
    if (interfaceFile != null || robot != null || example != null || language == Language.JAVA) {
      throw InvalidInputException.of(
          "--node " + folder,
          "can be combined with --class, and with --language python or cpp; remove the other"
              + " options");
    }
    Path ros = Installation.current().rosInterfaces();
    FileTree installed = Files.isDirectory(ros) ? UserFiles.folder(ros) : FileTree.of(Map.of());
    try {
      return GivenFiles.packageOf(folder, language)
          .activity(name(), className, installed)
          .propose();
    } catch (SeveralNodesException e) {
      throw InvalidInputException.of(
          e.packageName(),
          "holds several nodes; choose with --class: " + String.join(", ", e.nodes()));
    }
  }

  private static Language language(String name) {
    try {
      return Language.valueOf(name.toUpperCase(Locale.ROOT));
    } catch (IllegalArgumentException e) {
      throw InvalidInputException.of("--language " + name, NO_LANGUAGE);
    }
  }

  /** The name of the folder, in the characters of names. */
  private String name() {
    String last = String.valueOf(folder.toAbsolutePath().normalize().getFileName());
    String plain = last.replaceAll("[^A-Za-z0-9_-]+", "-").replaceAll("^-+|-+$", "");
    return plain.isEmpty() ? "activity" : plain;
  }

  private FileTree copied(String name) throws IOException {
    if (interfaceFile != null
        || robot != null
        || node != null
        || className != null
        || language != null) {
      throw InvalidInputException.of(
          "--from " + name, "copies an example as it is; remove the other options");
    }
    Path examples = Installation.current().example("");
    List<String> names = names(examples);
    if (!names.contains(name)) {
      throw InvalidInputException.of(
          "--from " + name, "is not an example; examples: " + String.join(", ", names));
    }
    return UserFiles.folder(examples.resolve(name));
  }

  private static List<String> names(Path examples) throws IOException {
    try (Stream<Path> all = Files.list(examples)) {
      return all.filter(path -> Files.exists(path.resolve("activity.yaml")))
          .map(path -> String.valueOf(path.getFileName()))
          .sorted()
          .toList();
    }
  }

  private static void requireEmpty(Path folder) throws IOException {
    if (!Files.exists(folder, LinkOption.NOFOLLOW_LINKS)) {
      return;
    }
    if (!Files.isDirectory(folder)) {
      throw InvalidInputException.of(folder.toString(), "is a file; name a new folder");
    }
    try (Stream<Path> content = Files.list(folder)) {
      if (content.findAny().isPresent()) {
        throw InvalidInputException.of(
            folder.toString(), "is not empty, and nothing was changed; name a new folder");
      }
    }
  }

  private void write(FileTree files) throws IOException {
    for (String path : files.paths()) {
      Path file = folder.resolve(path);
      Files.createDirectories(Objects.requireNonNull(file.getParent()));
      try {
        Files.write(
            file,
            files.content(path).orElseThrow(),
            StandardOpenOption.CREATE_NEW,
            StandardOpenOption.WRITE);
      } catch (FileAlreadyExistsException e) {
        throw InvalidInputException.of(file.toString(), "exists and is not overwritten");
      }
    }
  }

  private void summarise(FileTree files, PrintWriter out) {
    files.paths().stream()
        .filter(path -> !path.startsWith("world/") || path.endsWith(".world.yaml"))
        .filter(path -> node == null || !path.startsWith("src/"))
        .forEach(path -> out.println(Printable.line("  " + folder.resolve(path))));
    out.println();
    out.println("Next:");
    out.println(Printable.line("  ./sitaf run " + folder));
    if (example == null) {
      if (node == null) {
        out.println("  write the component: component/");
      }
      out.println("  decide the ranges and what is expected: the *.xml models");
      if (files.paths().stream().anyMatch(path -> path.endsWith(".world.yaml"))) {
        out.println("  check the devices: world/*.world.yaml");
      }
    }
  }
}
