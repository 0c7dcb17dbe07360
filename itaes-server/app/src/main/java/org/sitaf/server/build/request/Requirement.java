package org.sitaf.server.build.request;

/** A requirement that a build's agent must meet. */
public sealed interface Requirement {
  /** Whether an agent meets it. */
  boolean isMetBy(Capabilities agent);

  /** The requirement in a sentence such as "no agent offers ...". */
  String words();

  /** A language that the agent can compile and run, or a ROS 2 that nodes can run with. */
  record Language(String name) implements Requirement {
    /** As agents register the ROS 2 of their machine. */
    static final Language INSTALLED_ROS = new Language("ros");

    @Override
    public boolean isMetBy(Capabilities agent) {
      return agent.toolchains().stream().anyMatch(t -> t.language().equals(name));
    }

    @Override
    public String words() {
      return equals(INSTALLED_ROS) ? "an installed ROS 2" : name;
    }
  }

  /** A version of a language's toolchain. */
  record Version(String language, String version) implements Requirement {
    @Override
    public boolean isMetBy(Capabilities agent) {
      return agent.toolchains().stream()
          .anyMatch(t -> t.language().equals(language) && t.matches(version));
    }

    @Override
    public String words() {
      return language + " " + version;
    }
  }

  /** The agent can run simulations. */
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

  /** The agent accepts analyses of builds. */
  record Analyses() implements Requirement {
    @Override
    public boolean isMetBy(Capabilities agent) {
      return agent.analyses();
    }

    @Override
    public String words() {
      return "analyses of builds";
    }
  }

  /** A real device, which the build has alone. */
  record Device(String name) implements Requirement {
    @Override
    public boolean isMetBy(Capabilities agent) {
      return agent.devices().contains(name);
    }

    @Override
    public String words() {
      return "the device " + name;
    }
  }

  /** A label of the agent. */
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
