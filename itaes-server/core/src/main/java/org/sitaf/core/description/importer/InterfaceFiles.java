package org.sitaf.core.description.importer;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.sitaf.core.description.idl.IdlImporter;
import org.sitaf.core.description.opros.OprosImporter;
import org.sitaf.core.description.proto.ProtoImporter;
import org.sitaf.core.description.ros.RosImporter;
import org.sitaf.core.description.source.Described;
import org.sitaf.core.description.source.Findings;
import org.sitaf.core.description.source.Importer;
import org.sitaf.core.description.source.Place;
import org.sitaf.core.description.source.SourceFiles;

/**
 * Reads interface files: OPRoS profiles ({@code .xml}), OMG IDL ({@code .idl}), ROS 2 ({@code
 * .msg}, {@code .srv}, {@code .action}) and protobuf ({@code .proto}).
 */
public final class InterfaceFiles {
  /** Largest file, in bytes; interfaces are far smaller. */
  public static final int MAX_SIZE = 4 << 20;

  private static final List<Importer> IMPORTERS =
      List.of(new OprosImporter(), new IdlImporter(), new RosImporter(), new ProtoImporter());

  private static final Pattern OPROS_ROOT =
      Pattern.compile(
          "<(component_profile|service_port_type_profile|service_port_type|data_type)[\\s>/]");

  private static final int HEAD = 4096;

  private InterfaceFiles() {}

  /** Whether interfaces may stand in a file of this name. */
  public static boolean mayBe(String path) {
    return IMPORTERS.stream().anyMatch(importer -> importer.takes(path));
  }

  /**
   * Reads the files that are asked for; those beside them help to resolve references and types.
   *
   * @return what was understood, with a diagnostic for everything that was not
   */
  public static Described read(SourceFiles files) {
    Findings findings = new Findings();
    for (String path : files.asked()) {
      if (!mayBe(path)) {
        findings.error(
            new Place(path, 0, ""),
            "is no interface file; these end in .xml (OPRoS), .idl, .msg, .srv, .action or .proto");
      } else if (files.content(path).length > MAX_SIZE) {
        findings.error(
            new Place(path, 0, ""), "is larger than " + (MAX_SIZE >> 20) + " MiB; split it");
      }
    }
    SourceFiles usable = files.without(path -> files.content(path).length > MAX_SIZE);
    for (Importer importer : IMPORTERS) {
      SourceFiles own = usable.asking(importer::takes);
      if (!own.asked().isEmpty()) {
        importer.read(own, findings);
      }
    }
    return findings.described();
  }

  /**
   * Reads every interface file among others, such as those of a folder or an archive.
   *
   * @param name of the whole
   * @param files content by relative path with '/' separators
   */
  public static Described readAll(String name, Map<String, byte[]> files) {
    List<String> asked =
        files.keySet().stream().filter(p -> isInterfaceFile(p, files.get(p))).toList();
    if (asked.isEmpty()) {
      Findings findings = new Findings();
      findings.error(
          new Place(name, 0, ""),
          "holds no interface file; these are OPRoS profiles (.xml), .idl, .msg, .srv, .action and"
              + " .proto");
      return findings.described();
    }
    return read(SourceFiles.of(name, files, asked));
  }

  /** XML is used for much else, so that there the root element decides. */
  private static boolean isInterfaceFile(String path, byte[] content) {
    if (!path.endsWith(".xml")) {
      return mayBe(path);
    }
    String head =
        new String(content, 0, Math.min(content.length, HEAD), StandardCharsets.ISO_8859_1);
    return OPROS_ROOT.matcher(head.replace("\0", "")).find();
  }
}
