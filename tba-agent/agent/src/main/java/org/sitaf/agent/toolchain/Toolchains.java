package org.sitaf.agent.toolchain;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.toolchain.ToolchainLookup.Found;
import org.sitaf.agent.toolchain.ToolchainLookup.Missing;
import org.sitaf.agent.toolchain.cpp.CppToolchain;
import org.sitaf.agent.toolchain.java.JavaToolchain;
import org.sitaf.agent.toolchain.python.PythonToolchain;
import org.sitaf.agent.toolchain.python.RosInstallation;
import org.sitaf.core.activity.ActivityProfile.Language;

/** The toolchains of this machine; each is searched at its first use. */
public final class Toolchains {
  private static final System.Logger LOGGER = System.getLogger("org.sitaf.agent");

  private final ToolchainPlaces places;
  private final Map<Language, ToolchainLookup> lookups = new EnumMap<>(Language.class);

  public Toolchains(ToolchainPlaces places) {
    this.places = places;
  }

  /** Searches the toolchain of a language. The only place that lists all of them. */
  private ToolchainLookup search(Language language) {
    return switch (language) {
      case JAVA -> JavaToolchain.find(places);
      case CPP -> CppToolchain.find(places);
      case PYTHON -> PythonToolchain.find(places);
    };
  }

  private synchronized ToolchainLookup lookup(Language language) {
    return lookups.computeIfAbsent(language, this::search);
  }

  /** The cache of compiled applications. */
  public Path compiled() {
    return places.cache().resolve("compiled");
  }

  /** The toolchain of a language. */
  public Optional<Toolchain> of(Language language) {
    return lookup(language) instanceof Found found
        ? Optional.of(found.toolchain())
        : Optional.empty();
  }

  /** All installed toolchains. */
  public List<Toolchain> found() {
    List<Toolchain> found = new ArrayList<>();
    for (Language language : Language.values()) {
      of(language).ifPresent(found::add);
    }
    return List.copyOf(found);
  }

  /** The ROS 2 of this machine that nodes can run with instead of what comes along. */
  public Optional<RosInstallation> ros() {
    if (!(of(Language.PYTHON).orElse(null) instanceof PythonToolchain python)) {
      return Optional.empty();
    }
    try {
      return python.ros().found();
    } catch (IOException e) {
      LOGGER.log(System.Logger.Level.WARNING, "cannot search for ROS 2: " + e);
      return Optional.empty();
    }
  }

  /**
   * Starts a process ahead for the next build in a language. A failure is reported by the build
   * that needs the process.
   */
  public void startAhead(Language language, Sandbox sandbox) {
    of(language)
        .ifPresent(
            toolchain -> {
              try {
                toolchain.startAhead(sandbox);
              } catch (IOException e) {
                LOGGER.log(System.Logger.Level.WARNING, "cannot start a compiler ahead: " + e);
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
            });
  }

  /** Ends the processes that were started ahead. */
  public synchronized void stop() {
    for (ToolchainLookup lookup : lookups.values()) {
      if (lookup instanceof Found found) {
        found.toolchain().stop();
      }
    }
  }

  /** One sentence for each missing toolchain. */
  public List<String> missing() {
    List<String> sentences = new ArrayList<>();
    for (Language language : Language.values()) {
      if (lookup(language) instanceof Missing missing) {
        sentences.add(language.id() + ": " + missing.reason() + "; " + missing.remedy());
      }
    }
    return List.copyOf(sentences);
  }

  /** A message that a language is not available, with the reason and the available languages. */
  public String missingMessage(Language language) {
    String why =
        lookup(language) instanceof Missing missing
            ? " (" + missing.reason() + "; " + missing.remedy() + ")"
            : "";
    String offered =
        found().stream()
            .map(toolchain -> toolchain.language().id() + " (" + toolchain.version() + ")")
            .collect(Collectors.joining(", "));
    return "no toolchain for "
        + language.id()
        + why
        + "; this agent offers "
        + (offered.isEmpty() ? "none at all" : offered);
  }
}
