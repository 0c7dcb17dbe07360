package org.sitaf.cli;

import picocli.CommandLine.IVersionProvider;

/** The version that the build writes into the jar. */
final class Version implements IVersionProvider {
  @Override
  public String[] getVersion() {
    String version = Version.class.getPackage().getImplementationVersion();
    return new String[] {"sitaf " + (version == null ? "(not packaged)" : version)};
  }
}
