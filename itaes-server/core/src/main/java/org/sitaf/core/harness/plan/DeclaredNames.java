package org.sitaf.core.harness.plan;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.sitaf.core.description.DataType;
import org.sitaf.core.diagnostic.Diagnostics;

/**
 * The names of structs, enumerations, members and literals in one language. A name that the
 * language does not allow gets an underscore: the member {@code from} is {@code from_} in Python.
 * Documents and results have the name of the interface.
 */
public final class DeclaredNames {
  private final String language;
  private final Predicate<String> isType;
  private final Predicate<String> isMember;
  private final Predicate<String> isLiteral;

  /**
   * Creates the names of a language.
   *
   * @param language name of the language in messages
   * @param isType whether the language allows a name for a type in generated sources
   * @param isMember whether it allows a name for a member of a struct
   * @param isLiteral whether it allows a name for a literal of an enumeration
   */
  public DeclaredNames(
      String language,
      Predicate<String> isType,
      Predicate<String> isMember,
      Predicate<String> isLiteral) {
    this.language = language;
    this.isType = isType;
    this.isMember = isMember;
    this.isLiteral = isLiteral;
  }

  private static String named(String name, Predicate<String> isAllowed) {
    return isAllowed.test(name) ? name : name + "_";
  }

  /** The name of a struct or an enumeration. */
  public String type(DataType type) {
    return named(HarnessPlan.simpleName(type), isType);
  }

  /** The name of a member of a struct. */
  public String member(String name) {
    return named(name, isMember);
  }

  /** The name of a literal of an enumeration. */
  public String literal(String name) {
    return named(name, isLiteral);
  }

  /** Reports names that are not allowed with an underscore either, and names of two things. */
  public void check(List<DataType> types, String source, Diagnostics diagnostics) {
    Map<String, DataType> byName = new HashMap<>();
    for (DataType type : types) {
      String element = "type " + type.typeName();
      String name = type(type);
      DataType other = byName.putIfAbsent(name, type);
      if (!isType.test(name)) {
        diagnostics.error(source, 0, element, "is not a valid " + language + " type name");
      } else if (other != null) {
        diagnostics.error(
            source, 0, element, "is " + name + " in " + language + ", as " + other.typeName());
      }
      List<String> problems = List.of();
      if (type instanceof DataType.Struct struct) {
        problems =
            problems(struct.members().stream().map(DataType.Member::name).toList(), isMember);
      } else if (type instanceof DataType.Enumeration enumeration) {
        problems = problems(enumeration.literals(), isLiteral);
      }
      problems.forEach(problem -> diagnostics.error(source, 0, element, problem));
    }
  }

  private List<String> problems(List<String> names, Predicate<String> isAllowed) {
    List<String> problems = new ArrayList<>();
    Map<String, String> taken = new HashMap<>();
    for (String name : names) {
      String declared = named(name, isAllowed);
      String other = taken.putIfAbsent(declared, name);
      if (!isAllowed.test(declared)) {
        problems.add("'" + name + "' is not a valid " + language + " name");
      } else if (other != null) {
        problems.add("'" + name + "' is " + declared + " in " + language + ", as '" + other + "'");
      }
    }
    return problems;
  }
}
