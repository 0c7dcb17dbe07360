package org.sitaf.server.proposal;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.beginning.NewActivity;
import org.sitaf.core.beginning.Proposal;
import org.sitaf.core.beginning.choice.InterfaceChoice;
import org.sitaf.core.beginning.node.NodeChoice;
import org.sitaf.core.description.importer.InterfaceFiles;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.server.activity.RosPackages;
import org.sitaf.server.computation.Computations;
import org.springframework.stereotype.Service;

/** Proposes activities from interfaces and from ROS 2 packages. */
@Service
class Proposals {
  private static final String ARCHIVE = "the uploaded archive";
  private static final String MANIFEST = "package.xml";

  /** Sources of a package are below it in the activity. */
  private static final String SOURCES = "src/";

  private static final int SHOWN = 20;

  private final RosPackages installed;
  private final Computations computations;

  Proposals(RosPackages installed, Computations computations) {
    this.installed = installed;
    this.computations = computations;
  }

  /**
   * Proposes an activity.
   *
   * @param given the user's files; none for a small interface to change
   * @throws InvalidInputException if they have errors, or cannot be tested
   * @throws org.sitaf.core.beginning.node.SeveralNodesException if the package holds several nodes,
   *     and none was chosen
   */
  ProposalView propose(FileTree given, ProposalRequest request) {
    return computations.preview(
        "The proposal",
        () -> request.node() == null ? component(given, request) : node(given, request),
        () -> {});
  }

  private ProposalView component(FileTree given, ProposalRequest request) {
    InterfaceChoice chosen = choice(given, request);
    Proposal proposal =
        new NewActivity(
                request.name(),
                Objects.requireNonNullElse(request.language(), Language.PYTHON),
                request.className(),
                List.of(chosen.path()),
                chosen.provided(),
                chosen.files(),
                installed.files(),
                null)
            .propose();
    return ProposalView.of(proposal, chosen.files()::contains);
  }

  private InterfaceChoice choice(FileTree given, ProposalRequest request) {
    if (request.interfacePath() != null) {
      return InterfaceChoice.of(request.interfacePath(), given, installed.files());
    }
    if (given.paths().isEmpty()) {
      return InterfaceChoice.own();
    }
    List<String> candidates = given.paths().stream().filter(Proposals::canProvide).toList();
    if (candidates.size() != 1) {
      throw InvalidInputException.of(
          ARCHIVE,
          candidates.isEmpty()
              ? "contains no interface file: .xml (OPRoS), .idl, .srv, .action or .proto"
              : "contains several interface files; choose one as interface: " + shown(candidates));
    }
    return InterfaceChoice.of(candidates.get(0), given, installed.files());
  }

  /** Messages have no methods, and a manifest is no profile. */
  private static boolean canProvide(String path) {
    return InterfaceFiles.isSupported(path)
        && !path.endsWith(".msg")
        && !("/" + path).endsWith("/" + MANIFEST);
  }

  private ProposalView node(FileTree given, ProposalRequest request) {
    String folder = Objects.requireNonNull(request.node());
    boolean isTop = folder.isEmpty() || folder.equals(".");
    FileTree content = isTop ? given : given.below(folder);
    if (!content.contains(MANIFEST)) {
      List<String> folders =
          given.paths().stream()
              .filter(path -> path.endsWith("/" + MANIFEST))
              .map(path -> path.substring(0, path.lastIndexOf('/')))
              .toList();
      throw InvalidInputException.of(
          isTop ? ARCHIVE : folder,
          "has no package.xml; name the folder of a ROS 2 package as node: "
              + (folders.isEmpty() ? "the archive has none" : shown(folders)));
    }
    FileTree parent =
        isTop
            ? FileTree.of(Map.of())
            : given.below(folder.substring(0, Math.max(0, folder.lastIndexOf('/'))));
    Proposal proposal =
        NodeChoice.of(content, parent, isTop ? ARCHIVE : folder, request.language())
            .activity(request.name(), request.className(), installed.files())
            .propose();
    return ProposalView.of(proposal, path -> path.startsWith(SOURCES));
  }

  private static String shown(List<String> paths) {
    return String.join(", ", paths.subList(0, Math.min(SHOWN, paths.size())))
        + (paths.size() > SHOWN ? ", and " + (paths.size() - SHOWN) + " more" : "");
  }
}
