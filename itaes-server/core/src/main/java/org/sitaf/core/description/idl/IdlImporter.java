package org.sitaf.core.description.idl;

import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.antlr.v4.runtime.ParserRuleContext;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.ConstantContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.DefinitionContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.ExportContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.InterfaceDeclarationContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.TypeDeclarationContext;
import org.sitaf.core.description.idl.preprocessor.PreprocessedText;
import org.sitaf.core.description.idl.preprocessor.Preprocessor;
import org.sitaf.core.description.source.Findings;
import org.sitaf.core.description.source.Importer;
import org.sitaf.core.description.source.Place;
import org.sitaf.core.description.source.SourceFiles;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.Diagnostics;

/**
 * Reads OMG IDL. A requested file is read with all that it includes. Declarations of the other
 * files are known as well, so that a file without its includes can be read.
 */
public final class IdlImporter implements Importer {
  @Override
  public boolean supports(String path) {
    return path.endsWith(".idl");
  }

  @Override
  public void read(SourceFiles files, Findings findings) {
    new Reading(files, findings).read();
  }

  private static final class Reading {
    private final SourceFiles files;
    private final Findings findings;
    private final IdlScopes scopes = new IdlScopes();
    private final IdlConstants constants;
    private final IdlTypes types;
    private final Map<String, IdlInterfaces.Declared> interfaces = new LinkedHashMap<>();
    private final Set<String> exceptions = new HashSet<>();

    /** Where declarations begin; a file that several files include is declared once. */
    private final Set<String> declaredAt = new HashSet<>();

    private final Set<String> included = new HashSet<>();
    private final Set<Diagnostic> reported = new HashSet<>();

    Reading(SourceFiles files, Findings findings) {
      this.files = files;
      this.findings = findings;
      this.constants = new IdlConstants(scopes, findings);
      this.types = new IdlTypes(scopes, constants, findings);
    }

    void read() {
      // Requested files first: their declarations take precedence over duplicates.
      files.requested().forEach(this::declare);
      files.files().keySet().stream()
          .filter(path -> path.endsWith(".idl") && !files.isRequested(path))
          .filter(path -> !files.isForInclusion(path))
          .forEach(this::declare);
      IdlInterfaces reader = new IdlInterfaces(scopes, types, exceptions::contains, findings);
      Map<String, Integer> simpleNames = new HashMap<>();
      interfaces.keySet().forEach(name -> simpleNames.merge(simple(name), 1, Integer::sum));
      for (IdlInterfaces.Declared declared : interfaces.values()) {
        if (files.isRequested(declared.file())) {
          String simple = simple(declared.qualified());
          String name =
              simpleNames.getOrDefault(simple, 1) == 1
                  ? simple
                  : declared.qualified().replace("::", "_");
          Place place =
              new Place(
                  declared.file(),
                  declared.body().getStart().getLine(),
                  "interface " + declared.qualified());
          InterfaceDescription description =
              reader.describe(declared, interfaces, findings.identifier(name, place));
          findings.checkDistinct(description);
          findings.provides(description);
        }
      }
      types.declaredIn(files::isRequested).forEach(findings::type);
      constants.values().forEach(findings::constant);
    }

    private void declare(String path) {
      if (included.contains(path) && !files.isRequested(path)) {
        return;
      }
      Diagnostics problems = new Diagnostics();
      PreprocessedText text = Preprocessor.read(path, new IncludedFiles(), problems);
      Optional<IdlSyntax.Tree> tree = IdlSyntax.parse(text, problems);
      List<Diagnostic> fresh = problems.all().stream().filter(reported::add).toList();
      if (files.isRequested(path)) {
        findings.addAll(fresh);
      } else {
        findings.warnUnreadable(fresh);
      }
      tree.ifPresent(parsed -> declare(parsed.specification().definition(), "", parsed));
    }

    private final class IncludedFiles implements Preprocessor.Includes {
      @Override
      public Optional<String> find(String from, String name) {
        return files.resolve(from, name).filter(path -> path.endsWith(".idl"));
      }

      @Override
      public String text(String path) {
        included.add(path);
        return files.text(path);
      }
    }

    private void declare(List<DefinitionContext> definitions, String scope, IdlSyntax.Tree tree) {
      for (DefinitionContext definition : definitions) {
        String path = tree.file(definition);
        if (definition.module() != null) {
          String name = IdlScopes.text(definition.module().name());
          declare(definition.module().definition(), IdlScopes.inside(scope, name), tree);
        } else if (declaredAt.add(tree.place(definition))) {
          declare(definition, scope, path);
        }
      }
    }

    private void declare(DefinitionContext definition, String scope, String path) {
      if (definition.interfaceDeclaration() != null) {
        declare(definition.interfaceDeclaration(), scope, path);
      } else if (definition.typeDeclaration() != null) {
        declare(definition.typeDeclaration(), scope, path);
      } else if (definition.constant() != null) {
        declare(definition.constant(), scope, path);
      } else if (definition.exception() != null) {
        exceptions.add(IdlScopes.inside(scope, IdlScopes.text(definition.exception().name())));
      } else if (definition.other() != null && files.isRequested(path)) {
        findings.warning(
            place(path, definition.other(), definition.other().getStart().getText()),
            "is not part of an interface, ignored");
      }
    }

    private void declare(InterfaceDeclarationContext body, String scope, String path) {
      String qualified = IdlScopes.inside(scope, IdlScopes.text(body.name()));
      Place place = place(path, body, "interface " + qualified);
      IdlInterfaces.Declared first =
          interfaces.putIfAbsent(qualified, new IdlInterfaces.Declared(qualified, body, path));
      if (first != null) {
        if (files.isRequested(path)) {
          findings.error(place, "is already declared in " + first.file());
        }
        return;
      }
      scopes.declareInterface(qualified, body.scopedName());
      types.declareInterface(qualified, place);
      for (ExportContext export : body.export()) {
        if (export.typeDeclaration() != null) {
          declare(export.typeDeclaration(), qualified, path);
        } else if (export.constant() != null) {
          declare(export.constant(), qualified, path);
        } else if (export.exception() != null) {
          exceptions.add(IdlScopes.inside(qualified, IdlScopes.text(export.exception().name())));
        }
      }
    }

    private void declare(TypeDeclarationContext declaration, String scope, String path) {
      types.declare(declaration, scope, place(path, declaration, ""), files.isRequested(path));
    }

    private void declare(ConstantContext constant, String scope, String path) {
      String qualified = IdlScopes.inside(scope, IdlScopes.text(constant.name()));
      if (!constants.declare(qualified, scope, constant.expression()) && files.isRequested(path)) {
        findings.error(place(path, constant, "const " + qualified), "is already declared");
      }
    }

    private static Place place(String path, ParserRuleContext context, String element) {
      return new Place(path, context.getStart().getLine(), element);
    }

    private static String simple(String qualified) {
      return qualified.substring(qualified.lastIndexOf(':') + 1);
    }
  }
}
