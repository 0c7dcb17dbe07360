package org.sitaf.agent.toolchain;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.sitaf.core.activity.ActivityProfile.Language;

/**
 * The toolchains of this machine.
 *
 * @param missing why a language that an agent knows is not among them, one sentence each
 */
public record Toolchains(List<Toolchain> found, List<String> missing) {
  public Toolchains {
    found = List.copyOf(found);
    missing = List.copyOf(missing);
  }

  /** Looks at this machine. */
  public static Toolchains find() {
    List<Toolchain> found = new ArrayList<>();
    List<String> missing = new ArrayList<>();
    JavaCompiler javac = ToolProvider.getSystemJavaCompiler();
    if (javac != null) {
      found.add(new Toolchain(Language.JAVA, "javac " + System.getProperty("java.version")));
    } else {
      missing.add(
          "java: the Java that runs the agent ("
              + System.getProperty("java.home")
              + ") is a runtime without a compiler; run the agent with a JDK 17, such as Debian's"
              + " openjdk-17-jdk-headless");
    }
    return new Toolchains(found, missing);
  }

  /** The toolchain of a language. */
  public Optional<Toolchain> of(Language language) {
    return found.stream().filter(toolchain -> toolchain.language() == language).findFirst();
  }

  /** Says that a language is not offered, why, and what is. */
  public String lackOf(Language language) {
    String reason =
        missing.stream()
            .filter(sentence -> sentence.startsWith(language.spelling() + ":"))
            .map(sentence -> " (" + sentence + ")")
            .findFirst()
            .orElse("");
    String offered =
        found.isEmpty()
            ? "none at all"
            : found.stream().map(Toolchain::toString).collect(Collectors.joining(", "));
    return "no toolchain for " + language.spelling() + reason + "; this agent offers " + offered;
  }
}
