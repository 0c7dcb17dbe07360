package org.sitaf.core.description.importer;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.sitaf.core.description.idl.IdlImporter;
import org.sitaf.core.description.opros.OprosImporter;
import org.sitaf.core.description.proto.ProtoImporter;
import org.sitaf.core.description.ros.RosImporter;
import org.sitaf.core.description.source.Findings;
import org.sitaf.core.description.source.ImportResult;
import org.sitaf.core.description.source.Importer;
import org.sitaf.core.description.source.Place;
import org.sitaf.core.description.source.SourceFiles;

/**
 * Reads interface files: OPRoS profiles ({@code .xml}), OMG IDL ({@code .idl}), ROS 2 ({@code
 * .msg}, {@code .srv}, {@code .action}) and protobuf ({@code .proto}).
 */
public final class InterfaceFiles {
  /** Maximum size of a file in bytes. Real interface files are far smaller. */
  public static final int MAX_SIZE = 4 << 20;

  private static final List<Importer> IMPORTERS =
      List.of(new OprosImporter(), new IdlImporter(), new RosImporter(), new ProtoImporter());

  private static final Pattern OPROS_ROOT =
      Pattern.compile(
          "<(component_profile|service_port_type_profile|service_port_type|data_type)[\\s>/]");

  private static final int HEAD = 4096;

  private InterfaceFiles() {}

  /** Whether a file name has the extension of an interface file. */
  public static boolean isSupported(String path) {
    return IMPORTERS.stream().anyMatch(importer -> importer.supports(path));
  }

  /**
   * Reads the requested files. The other files are used to resolve references and types.
   *
   * @return the descriptions, with a diagnostic for everything that could not be read
   */
  public static ImportResult read(SourceFiles files) {
    Findings findings = new Findings();
    for (String path : files.requested()) {
      if (!isSupported(path)) {
        findings.error(
            new Place(path, 0, ""),
            "is not an interface file; use .xml (OPRoS), .idl, .msg, .srv, .action or .proto");
      } else if (files.content(path).length > MAX_SIZE) {
        findings.error(
            new Place(path, 0, ""), "is larger than " + (MAX_SIZE >> 20) + " MiB; split it");
      }
    }
    SourceFiles usable = files.without(path -> files.content(path).length > MAX_SIZE);
    for (Importer importer : IMPORTERS) {
      SourceFiles own = usable.requesting(importer::supports);
      if (!own.requested().isEmpty()) {
        importer.read(own, findings);
      }
    }
    return findings.result();
  }

  /**
   * Reads all interface files of a folder or an archive. Other files are ignored.
   *
   * @param name name of the folder or archive
   * @param files content by relative path with '/' separators
   */
  public static ImportResult readAll(String name, Map<String, byte[]> files) {
    return readAll(SourceFiles.of(name, files, List.copyOf(files.keySet())));
  }

  /** Reads all requested files that are interface files. */
  public static ImportResult readAll(SourceFiles files) {
    SourceFiles sources = files.requesting(path -> isInterfaceFile(path, files.content(path)));
    if (sources.requested().isEmpty()) {
      Findings findings = new Findings();
      findings.error(
          new Place(files.name(), 0, ""),
          "contains no interface file; supported are OPRoS profiles (.xml), .idl, .msg, .srv,"
              + " .action and .proto");
      return findings.result();
    }
    return read(sources);
  }

  /** XML files are recognized by their root element, since not every XML file is a profile. */
  private static boolean isInterfaceFile(String path, byte[] content) {
    if (!path.endsWith(".xml")) {
      return isSupported(path);
    }
    String head =
        new String(content, 0, Math.min(content.length, HEAD), StandardCharsets.ISO_8859_1);
    return OPROS_ROOT.matcher(head.replace("\0", "")).find();
  }
}
