package org.sitaf.core.description.idl;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.tree.ParseTree;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.BaseTypeContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.DeclaratorContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.DeclaredTypeContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.DimensionContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.EnumerationContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.MemberContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.NameContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.ScopedNameContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.StructContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.TypeDeclarationContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.TypeSpecContext;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.TypedefContext;
import org.sitaf.core.description.source.DeclaredTypes;
import org.sitaf.core.description.source.Findings;
import org.sitaf.core.description.source.Place;

/** Data types of IDL. Structs, enumerations and aliases are identified by their qualified name. */
final class IdlTypes {
  private static final int MAX_DIMENSIONS = 16;

  /** By name without spaces. */
  private static final Map<String, ScalarType> SCALARS =
      Map.ofEntries(
          Map.entry("float", ScalarType.FLOAT),
          Map.entry("double", ScalarType.DOUBLE),
          Map.entry("short", ScalarType.INT16),
          Map.entry("long", ScalarType.INT32),
          Map.entry("longlong", ScalarType.INT64),
          Map.entry("unsignedshort", ScalarType.UINT16),
          Map.entry("unsignedlong", ScalarType.UINT32),
          Map.entry("unsignedlonglong", ScalarType.UINT64),
          Map.entry("char", ScalarType.CHAR),
          Map.entry("wchar", ScalarType.CHAR),
          Map.entry("boolean", ScalarType.BOOLEAN),
          Map.entry("octet", ScalarType.UINT8),
          Map.entry("int8", ScalarType.INT8),
          Map.entry("uint8", ScalarType.UINT8),
          Map.entry("int16", ScalarType.INT16),
          Map.entry("uint16", ScalarType.UINT16),
          Map.entry("int32", ScalarType.INT32),
          Map.entry("uint32", ScalarType.UINT32),
          Map.entry("int64", ScalarType.INT64),
          Map.entry("uint64", ScalarType.UINT64));

  /** Base types without a counterpart, with the reason. */
  private static final Map<String, String> UNSUPPORTED =
      Map.of(
          "any", "a value of any type",
          "Object", "a reference to an object",
          "ValueBase", "a value type",
          "long double", "wider than 64 bits");

  private final IdlScopes scopes;
  private final IdlConstants constants;
  private final Findings findings;
  private final DeclaredTypes declared;

  IdlTypes(IdlScopes scopes, IdlConstants constants, Findings findings) {
    this.scopes = scopes;
    this.constants = constants;
    this.findings = findings;
    this.declared = new DeclaredTypes(findings);
  }

  /** Declares an interface, which is not supported as a data type. */
  void declareInterface(String qualified, Place place) {
    declared.declareOpaque(qualified, place, "an interface");
  }

  /** Declares the types of a declaration, including nested ones. */
  void declare(TypeDeclarationContext declaration, String scope, Place place, boolean requested) {
    if (declaration.struct() != null) {
      declare(declaration.struct(), scope, place, requested);
    } else if (declaration.enumeration() != null) {
      declare(declaration.enumeration(), scope, place, requested);
    } else if (declaration.typedef() != null) {
      declare(declaration.typedef(), scope, place, requested);
    } else if (declaration.union() != null) {
      opaque(declaration.union().name(), scope, place, "a union");
    } else if (declaration.bits() != null) {
      opaque(declaration.bits().name(), scope, place, "a bit set");
    } else if (declaration.name() != null) {
      opaque(declaration.name(), scope, place, "a native type");
    }
    // A forward declaration adds nothing to the declaration.
  }

  /** The structs and enumerations declared in the matching files. */
  List<DataType> declaredIn(Predicate<String> file) {
    return declared.declaredIn(file);
  }

  /** The place where a type is declared. */
  Optional<Place> place(String qualified) {
    return declared.place(qualified);
  }

  /** Whether a name in a scope is that of a type. */
  boolean isType(ScopedNameContext name, String scope) {
    return scopes.find(name, scope, declared::contains).isPresent();
  }

  /**
   * Resolves a type specification. An undefined type is reported and becomes {@link
   * DataType.Unknown}.
   */
  DataType resolve(TypeSpecContext spec, String scope, Place place) {
    if (spec.baseType() != null) {
      return base(spec.baseType(), place);
    }
    if (spec.sequence() != null) {
      DataType element = resolve(spec.sequence().typeSpec(), scope, place);
      return spec.sequence().expression() == null
          ? new DataType.Sequence(element)
          : new DataType.Sequence(
              element, constants.bound(spec.sequence().expression(), scope, place));
    }
    if (spec.stringType() != null) {
      int bound =
          spec.stringType().expression() == null
              ? 0
              : constants.bound(spec.stringType().expression(), scope, place);
      return new DataType.Scalar(ScalarType.STRING, bound);
    }
    if (spec.scopedName() != null) {
      Optional<String> qualified = scopes.find(spec.scopedName(), scope, declared::contains);
      String name = qualified.orElse(IdlScopes.text(spec.scopedName()));
      DataType found = declared.find(name).orElse(new DataType.Unknown(name));
      if (found instanceof DataType.Unknown unknown) {
        findings.unknownType(place, unknown.name(), declared.reason(unknown.name()));
      }
      return found;
    }
    String name = words(spec);
    findings.unknownType(place, name, spec.map() != null ? "a map" : "");
    return new DataType.Unknown(name);
  }

  /** Applies the dimensions of a declarator to a type. The last dimension is the innermost. */
  DataType dimensioned(DataType type, DeclaratorContext declarator, String scope, Place place) {
    List<DimensionContext> dimensions = declarator.dimension();
    if (dimensions.size() > MAX_DIMENSIONS) {
      findings.error(place, "has more than " + MAX_DIMENSIONS + " dimensions");
      return type;
    }
    DataType array = type;
    for (int i = dimensions.size() - 1; i >= 0; i--) {
      OptionalInt length = constants.length(dimensions.get(i).expression(), scope, place);
      array = length.isPresent() ? new DataType.FixedArray(array, length.getAsInt()) : array;
    }
    return array;
  }

  static Place at(Place place, ParserRuleContext context, String element) {
    return new Place(place.file(), context.getStart().getLine(), element);
  }

  private void declare(StructContext struct, String scope, Place place, boolean requested) {
    String name = IdlScopes.text(struct.name());
    String qualified = IdlScopes.inside(scope, name);
    Place named = at(place, struct, "struct " + qualified);
    struct.member().forEach(m -> declareInner(m.declaredType(), qualified, named, requested));
    unique(
        declared.declare(qualified, named, () -> struct(struct, scope, qualified, named)),
        qualified,
        named,
        requested);
  }

  private void declare(
      EnumerationContext enumeration, String scope, Place place, boolean requested) {
    String qualified = IdlScopes.inside(scope, IdlScopes.text(enumeration.name()));
    Place named = at(place, enumeration, "enum " + qualified);
    unique(
        declared.declare(
            qualified,
            named,
            () ->
                new DataType.Enumeration(
                    qualified,
                    enumeration.enumerator().stream().map(e -> IdlScopes.text(e.name())).toList())),
        qualified,
        named,
        requested);
  }

  private void declare(TypedefContext typedef, String scope, Place place, boolean requested) {
    declareInner(typedef.declaredType(), scope, place, requested);
    for (DeclaratorContext declarator : typedef.declarator()) {
      String qualified = IdlScopes.inside(scope, IdlScopes.text(declarator.name()));
      Place named = at(place, declarator, "typedef " + qualified);
      TypeSpecContext aliased = typedef.declaredType().typeSpec();
      if (aliased != null && aliased.scopedName() != null && declarator.dimension().isEmpty()) {
        scopes.declareAlias(qualified, aliased.scopedName(), scope);
      }
      unique(
          declared.declare(
              qualified,
              named,
              () ->
                  dimensioned(
                      inner(typedef.declaredType(), scope, named), declarator, scope, named)),
          qualified,
          named,
          requested);
    }
  }

  /** Declares a struct, union or enumeration that is defined inline. */
  private void declareInner(
      DeclaredTypeContext type, String scope, Place place, boolean requested) {
    if (type.struct() != null) {
      declare(type.struct(), scope, place, requested);
    } else if (type.enumeration() != null) {
      declare(type.enumeration(), scope, place, requested);
    } else if (type.union() != null) {
      opaque(type.union().name(), scope, place, "a union");
    }
  }

  private void opaque(NameContext name, String scope, Place place, String reason) {
    String qualified = IdlScopes.inside(scope, IdlScopes.text(name));
    declared.declareOpaque(qualified, at(place, name, qualified), reason);
  }

  private DataType inner(DeclaredTypeContext type, String scope, Place place) {
    if (type.typeSpec() != null) {
      return resolve(type.typeSpec(), scope, place);
    }
    NameContext name =
        type.struct() != null
            ? type.struct().name()
            : type.union() != null ? type.union().name() : type.enumeration().name();
    String qualified = IdlScopes.inside(scope, IdlScopes.text(name));
    DataType found = declared.find(qualified).orElse(new DataType.Unknown(qualified));
    if (found instanceof DataType.Unknown) {
      findings.unknownType(place, qualified, declared.reason(qualified));
    }
    return found;
  }

  private DataType struct(StructContext struct, String scope, String qualified, Place place) {
    List<DataType.Member> members = new ArrayList<>();
    if (struct.scopedName() != null) {
      Optional<String> base = scopes.find(struct.scopedName(), scope, declared::contains);
      if (base.flatMap(declared::find).orElse(null) instanceof DataType.Struct inherited) {
        members.addAll(inherited.members());
      } else {
        findings.error(
            at(place, struct.scopedName(), place.element()),
            "inherits from '" + IdlScopes.text(struct.scopedName()) + "', which is not a struct");
      }
    }
    Set<String> names = new HashSet<>();
    members.forEach(m -> names.add(m.name()));
    for (MemberContext member : struct.member()) {
      for (DeclaratorContext declarator : member.declarator()) {
        String name = IdlScopes.text(declarator.name());
        Place at = at(place, declarator, place.element() + "/" + name);
        if (!names.add(name)) {
          findings.error(at, "two members have this name");
        }
        DataType type = inner(member.declaredType(), scopeOf(member, scope, qualified), at);
        members.add(new DataType.Member(name, dimensioned(type, declarator, qualified, at)));
      }
    }
    return new DataType.Struct(qualified, members);
  }

  /** An inline type is declared in the scope of the struct. */
  private static String scopeOf(MemberContext member, String scope, String qualified) {
    return member.declaredType().typeSpec() == null ? qualified : scope;
  }

  private DataType base(BaseTypeContext base, Place place) {
    ScalarType scalar = SCALARS.get(base.getText());
    if (scalar == null) {
      findings.unknownType(place, words(base), UNSUPPORTED.getOrDefault(words(base), ""));
      return new DataType.Unknown(words(base));
    }
    return new DataType.Scalar(scalar);
  }

  private void unique(boolean isFirst, String qualified, Place place, boolean requested) {
    if (!isFirst && requested) {
      Place first = declared.place(qualified).orElse(place);
      findings.error(place, "is already declared in " + first.file() + ", line " + first.line());
    }
  }

  /** The source text of a type, with single spaces between words. */
  private static String words(ParserRuleContext context) {
    if (context.getChildCount() == 1 && context.getChild(0) instanceof ParserRuleContext only) {
      return words(only);
    }
    return context.children.stream()
        .map(ParseTree::getText)
        .collect(Collectors.joining(" "))
        .replaceAll(" ?([<>,]) ?", "$1");
  }
}
