package org.sitaf.core.description.opros;

import java.io.InputStream;
import java.util.List;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.source.Findings;
import org.sitaf.core.description.source.Place;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.InvalidInputException;

/** Interface Parser for a single file in the interface representation of OPRoS (paper, Fig. 3). */
public final class OprosReader {
  private OprosReader() {}

  /**
   * Reads the interfaces of a file: a {@code service_port_type_profile} or a bare {@code
   * service_port_type}.
   *
   * @param diagnostics takes warnings, such as types that nothing defines
   * @throws InvalidInputException with every problem of the file
   */
  public static List<InterfaceDescription> read(
      InputStream document, String file, Diagnostics diagnostics) {
    Findings findings = new Findings();
    List<InterfaceDescription> interfaces = List.of();
    if (OprosDocument.read(document, file) instanceof OprosDocument.Services services) {
      interfaces = new ServiceReader(new OprosTypes(findings), findings).describe(services);
    } else {
      findings.error(
          new Place(file, 0, ""),
          "an interface file has the root <service_port_type_profile> or <service_port_type>");
    }
    diagnostics.addAll(findings.described().orThrow().diagnostics());
    return interfaces;
  }
}
