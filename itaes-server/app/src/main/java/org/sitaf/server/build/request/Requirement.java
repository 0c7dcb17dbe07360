package org.sitaf.server.build.request;

/** One thing that an agent must have for a build. */
public sealed interface Requirement {
  /** Whether an agent has it. */
  boolean isMetBy(Capabilities agent);

  /** For people, as in "no agent offers …". */
  String words();

  /** To compile and run a language. */
  record Language(String name) implements Requirement {
    @Override
    public boolean isMetBy(Capabilities agent) {
      return agent.toolchains().stream().anyMatch(t -> t.language().equals(name));
    }

    @Override
    public String words() {
      return name;
    }
  }

  /** A release of the tools of a language. */
  record Version(String language, String version) implements Requirement {
    @Override
    public boolean isMetBy(Capabilities agent) {
      return agent.toolchains().stream()
          .anyMatch(t -> t.language().equals(language) && t.isOf(version));
    }

    @Override
    public String words() {
      return language + " " + version;
    }
  }

  /** To simulate a world. */
  record Simulation() implements Requirement {
    @Override
    public boolean isMetBy(Capabilities agent) {
      return agent.simulation();
    }

    @Override
    public String words() {
      return "a simulation";
    }
  }

  /** A label, by which its owner says what else an agent is good for. */
  record Label(String name) implements Requirement {
    @Override
    public boolean isMetBy(Capabilities agent) {
      return agent.labels().contains(name);
    }

    @Override
    public String words() {
      return "the label " + name;
    }
  }
}
