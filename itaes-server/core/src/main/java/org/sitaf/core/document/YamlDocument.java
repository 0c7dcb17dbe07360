package org.sitaf.core.document;

import java.io.StringReader;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.Yaml;
import org.yaml.snakeyaml.error.MarkedYAMLException;
import org.yaml.snakeyaml.error.YAMLException;
import org.yaml.snakeyaml.nodes.MappingNode;
import org.yaml.snakeyaml.nodes.Node;

/**
 * Reads the YAML files that users write by hand: {@code activity.yaml} and {@code *.world.yaml}.
 */
public final class YamlDocument {
  private static final int MAX_CHARACTERS = 1 << 20;
  private static final int MAX_ALIASES = 20;
  private static final int MAX_DEPTH = 20;

  private YamlDocument() {}

  /**
   * Reads a document whose root is a mapping. Only plain structure is read: tags never create
   * objects.
   *
   * @param diagnostics receives problems of entries when the entries are accessed
   * @throws InvalidInputException if the text is not YAML or the root is not a mapping
   */
  public static YamlMapping read(String text, String file, Diagnostics diagnostics) {
    LoaderOptions options = new LoaderOptions();
    options.setCodePointLimit(MAX_CHARACTERS);
    options.setMaxAliasesForCollections(MAX_ALIASES);
    options.setNestingDepthLimit(MAX_DEPTH);
    options.setAllowDuplicateKeys(false);
    Node root;
    try {
      root = new Yaml(options).compose(new StringReader(text));
    } catch (MarkedYAMLException e) {
      int line = e.getProblemMark() == null ? 0 : e.getProblemMark().getLine() + 1;
      throw new InvalidInputException(
          java.util.List.of(Diagnostic.error(file, line, "", "not YAML: " + e.getProblem())));
    } catch (YAMLException e) {
      throw InvalidInputException.of(file, "not YAML: " + e.getMessage());
    }
    if (!(root instanceof MappingNode mapping)) {
      throw InvalidInputException.of(file, "must be a mapping of names to values");
    }
    return new YamlMapping(mapping, file, "", diagnostics);
  }
}
