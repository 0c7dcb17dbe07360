package org.sitaf.core.description.source;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;

/**
 * The named types of all files. Types are resolved on first use, so the order of declarations does
 * not matter. Recursive types and types that are too large are reported and become {@link
 * DataType.Unknown}: a struct contains the types of its members, so a recursive type would be
 * infinite, and a few lines of nested arrays can describe a type that does not fit into memory.
 */
public final class DeclaredTypes {
  /** Maximum nesting depth of a type. */
  public static final int MAX_DEPTH = 64;

  /** Maximum number of parts of a type, on all levels together. */
  public static final int MAX_PARTS = 100_000;

  private final Findings findings;
  private final Map<String, Declaration> declarations = new LinkedHashMap<>();
  private final IdentityHashMap<DataType, Extent> extents = new IdentityHashMap<>();
  private final Deque<String> resolving = new ArrayDeque<>();

  public DeclaredTypes(Findings findings) {
    this.findings = findings;
  }

  /**
   * Declares a type. The body is built on first use.
   *
   * @param name qualified name
   * @return false if the name is already declared; the first declaration is kept
   */
  public boolean declare(String name, Place place, Supplier<DataType> body) {
    return declarations.putIfAbsent(name, new Declaration(place, body, "")) == null;
  }

  /**
   * Declares a type that cannot be represented as a {@link DataType}.
   *
   * @param reason why, such as {@code a union}
   */
  public boolean declareOpaque(String name, Place place, String reason) {
    return declarations.putIfAbsent(
            name, new Declaration(place, () -> new DataType.Unknown(name), reason))
        == null;
  }

  /** Whether a type is declared. */
  public boolean contains(String name) {
    return declarations.containsKey(name);
  }

  /** The place of a declaration. */
  public Optional<Place> place(String name) {
    return Optional.ofNullable(declarations.get(name)).map(d -> d.place);
  }

  /** Why a declared type cannot be represented; empty if there is no known reason. */
  public String reason(String name) {
    Declaration declaration = declarations.get(name);
    return declaration == null ? "" : declaration.reason;
  }

  /** Resolves a name. The result is {@link DataType.Unknown} if the type cannot be represented. */
  public Optional<DataType> find(String name) {
    Declaration declaration = declarations.get(name);
    if (declaration == null) {
      return Optional.empty();
    }
    DataType known = declaration.type;
    if (known != null) {
      return Optional.of(known);
    }
    if (declaration.isOpen) {
      declaration.reason = "part of itself";
      return Optional.of(new DataType.Unknown(name));
    }
    if (resolving.size() >= MAX_DEPTH) {
      return Optional.of(tooLarge(name, declaration));
    }
    declaration.isOpen = true;
    resolving.push(name);
    DataType type = declaration.body.get();
    resolving.pop();
    declaration.isOpen = false;
    Extent extent = extent(type, 0);
    if (extent.depth > MAX_DEPTH || extent.parts > MAX_PARTS) {
      type = tooLarge(name, declaration);
    }
    declaration.type = type;
    return Optional.of(type);
  }

  /** The structs and enumerations declared in the matching files, in the order of declaration. */
  public List<DataType> declaredIn(java.util.function.Predicate<String> file) {
    List<DataType> types = new ArrayList<>();
    for (String name : List.copyOf(declarations.keySet())) {
      Place place = place(name).orElseThrow();
      if (file.test(place.file())) {
        find(name)
            .filter(t -> t instanceof DataType.Struct || t instanceof DataType.Enumeration)
            .filter(t -> t.typeName().equals(name))
            .ifPresent(types::add);
      }
    }
    return types;
  }

  private DataType tooLarge(String name, Declaration declaration) {
    if (!declaration.isRefused) {
      declaration.isRefused = true;
      declaration.reason = "too large";
      findings.error(
          declaration.place,
          "nests deeper than "
              + MAX_DEPTH
              + " levels or has more than "
              + MAX_PARTS
              + " parts; split the type");
    }
    DataType unknown = new DataType.Unknown(name);
    declaration.type = unknown;
    return unknown;
  }

  /** Measures each distinct type only once. */
  private Extent extent(DataType type, int level) {
    if (level > MAX_DEPTH) {
      return new Extent(MAX_DEPTH + 1, 1);
    }
    Extent known = extents.get(type);
    if (known != null) {
      return known;
    }
    int depth = 0;
    long parts = 1;
    for (DataType part : type.parts()) {
      Extent inner = extent(part, level + 1);
      depth = Math.max(depth, inner.depth);
      parts = Math.min(parts + inner.parts, Integer.MAX_VALUE);
    }
    Extent extent = new Extent(depth + 1, parts);
    extents.put(type, extent);
    return extent;
  }

  private record Extent(int depth, long parts) {}

  private static final class Declaration {
    private final Place place;
    private final Supplier<DataType> body;
    private String reason;
    private @Nullable DataType type;
    private boolean isOpen;
    private boolean isRefused;

    Declaration(Place place, Supplier<DataType> body, String reason) {
      this.place = place;
      this.body = body;
      this.reason = reason;
    }
  }
}
