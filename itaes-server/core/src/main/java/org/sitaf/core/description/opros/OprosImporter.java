package org.sitaf.core.description.opros;

import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.source.Findings;
import org.sitaf.core.description.source.Importer;
import org.sitaf.core.description.source.Place;
import org.sitaf.core.description.source.SourceFiles;
import org.sitaf.core.diagnostic.InvalidInputException;

/**
 * Reads OPRoS files: component profiles with the interfaces that they reference, service port
 * types, and data types.
 */
public final class OprosImporter implements Importer {
  private static final Pattern DATA_TYPE = Pattern.compile("<data_type[\\s>]");
  private static final Pattern PROFILE = Pattern.compile("<component_profile[\\s>]");
  private static final int HEAD = 4096;

  @Override
  public boolean supports(String path) {
    return path.endsWith(".xml");
  }

  @Override
  public void read(SourceFiles files, Findings findings) {
    new Reading(files, findings).read();
  }

  /** The state of one import. Documents are parsed when they are first referenced. */
  private static final class Reading implements ComponentReader.References {
    private final SourceFiles files;
    private final Findings findings;
    private final OprosTypes types;
    private final ServiceReader services;
    private final Map<String, Optional<OprosDocument>> documents = new HashMap<>();
    private final Map<String, List<InterfaceDescription>> interfaces = new HashMap<>();
    private final Set<InterfaceDescription> provided = new LinkedHashSet<>();
    private final Set<InterfaceDescription> required = new LinkedHashSet<>();

    Reading(SourceFiles files, Findings findings) {
      this.files = files;
      this.findings = findings;
      this.types = new OprosTypes(findings);
      this.services = new ServiceReader(types, findings);
    }

    void read() {
      // Requested files first: their structs take precedence over duplicates.
      files.requested().forEach(this::declareTypes);
      files.files().keySet().stream()
          .filter(
              path -> path.endsWith(".xml") && !files.isRequested(path) && looksLikeDataTypes(path))
          .forEach(this::declareTypes);
      ComponentReader reader = new ComponentReader(types, findings, this);
      for (String path : files.requested()) {
        if (document(path).orElse(null) instanceof OprosDocument.Component component) {
          findings.component(reader.describe(component));
        }
      }
      for (String path : files.requested()) {
        for (InterfaceDescription description : describe(path)) {
          if (!provided.contains(description) && !required.contains(description)) {
            provided.add(description);
          }
        }
        if (document(path).orElse(null) instanceof OprosDocument.Other other) {
          findings.error(
              new Place(other.file(), other.line(), other.root()),
              "an OPRoS file has the root <component_profile>, <service_port_type_profile>,"
                  + " <service_port_type> or <data_type>");
        }
      }
      provided.forEach(findings::provides);
      required.forEach(findings::requires);
      types.declaredIn(files::isRequested).forEach(findings::type);
    }

    private void declareTypes(String path) {
      if (document(path).orElse(null) instanceof OprosDocument.DataTypes dataTypes) {
        types.declare(dataTypes);
      }
    }

    @Override
    public void dataTypes(Place place, String reference) {
      if (files.resolve(place.file(), reference).isEmpty()) {
        findings.warning(
            place, "references '" + reference + "', which is not among the given files");
      }
    }

    @Override
    public String service(ComponentReader.ServicePort port) {
      boolean named = !port.reference().isEmpty();
      String reference = named ? port.reference() : port.type() + ".xml";
      Optional<String> file = files.resolve(port.place().file(), reference);
      if (file.isEmpty()) {
        findings.error(
            port.place(),
            (named
                    ? "references '" + reference + "', which"
                    : "has no <reference>, and '" + reference + "'")
                + " is not among the given files; add it or correct the reference");
        return "";
      }
      List<InterfaceDescription> all = describe(file.get());
      Optional<InterfaceDescription> found =
          all.stream().filter(i -> i.name().equals(port.type())).findFirst();
      if (found.isEmpty()) {
        findings.error(
            port.place(),
            "'"
                + file.get()
                + "' does not define service_port_type "
                + port.type()
                + "; it defines "
                + all.stream().map(InterfaceDescription::name).toList());
        return "";
      }
      (port.provided() ? provided : required).add(found.get());
      return file.get();
    }

    private List<InterfaceDescription> describe(String path) {
      List<InterfaceDescription> known = interfaces.get(path);
      if (known == null) {
        known =
            document(path).orElse(null) instanceof OprosDocument.Services document
                ? services.describe(document)
                : List.of();
        interfaces.put(path, known);
      }
      return known;
    }

    private Optional<OprosDocument> document(String path) {
      Optional<OprosDocument> known = documents.get(path);
      if (known == null) {
        known = parse(path);
        documents.put(path, known);
      }
      return known;
    }

    private Optional<OprosDocument> parse(String path) {
      try {
        return Optional.of(OprosDocument.read(files.content(path), path));
      } catch (InvalidInputException e) {
        if (files.isRequested(path)) {
          findings.addAll(e.diagnostics());
        } else {
          findings.warnUnreadable(e.diagnostics());
        }
        return Optional.empty();
      }
    }

    private boolean looksLikeDataTypes(String path) {
      byte[] content = files.content(path);
      String head =
          new String(content, 0, Math.min(content.length, HEAD), StandardCharsets.ISO_8859_1);
      return DATA_TYPE.matcher(head).find() && !PROFILE.matcher(head).find();
    }
  }
}
