package org.sitaf.core.description.opros;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.TypeGrammar;
import org.sitaf.core.description.source.DeclaredTypes;
import org.sitaf.core.description.source.Findings;
import org.sitaf.core.description.source.Place;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.schemas.DataItemType;
import org.sitaf.schemas.DataStructType;
import org.sitaf.schemas.LocatedText;

/** Resolves C++ type names and the structs of {@code data_type} files. */
final class OprosTypes {
  private final Findings findings;
  private final DeclaredTypes declared;

  OprosTypes(Findings findings) {
    this.findings = findings;
    this.declared = new DeclaredTypes(findings);
  }

  /** Declares the structs of a file. The first of several declarations is used. */
  void declare(OprosDocument.DataTypes document) {
    for (DataStructType struct : document.structs()) {
      Place place = new Place(document.file(), XmlDocuments.line(struct), "struct");
      String name = findings.identifier(struct.getName(), place);
      Place named = new Place(place.file(), place.line(), "struct " + name);
      if (!declared.declare(name, named, () -> body(name, struct, named))) {
        String other = declared.place(name).map(Place::file).orElse("");
        findings.warning(
            named, "is already declared in " + other + "; the first declaration is used");
      }
    }
  }

  /** The structs declared in the matching files. */
  List<DataType> declaredIn(java.util.function.Predicate<String> file) {
    return declared.declaredIn(file);
  }

  /** Resolves a type name. An undefined type is reported and becomes {@link DataType.Unknown}. */
  TypeGrammar.ParsedType resolve(@Nullable LocatedText text, Place owner) {
    String typeText = text(text);
    Place place = text == null ? owner : at(owner, text);
    if (typeText.isEmpty()) {
      findings.error(place, "has no type");
      return new TypeGrammar.ParsedType(new DataType.Unknown(""), false);
    }
    return resolve(typeText, place);
  }

  /** Resolves a type name. An undefined type is reported and becomes {@link DataType.Unknown}. */
  TypeGrammar.ParsedType resolve(String typeText, Place place) {
    TypeGrammar.ParsedType parsed = TypeGrammar.parse(typeText);
    return new TypeGrammar.ParsedType(known(parsed.type(), place), parsed.byReference());
  }

  private DataType known(DataType type, Place place) {
    if (type instanceof DataType.Sequence sequence) {
      return new DataType.Sequence(known(sequence.element(), place), sequence.bound());
    }
    if (type instanceof DataType.FixedArray array) {
      return new DataType.FixedArray(known(array.element(), place), array.length());
    }
    if (type instanceof DataType.Unknown unknown) {
      DataType found = declared.find(unknown.name()).orElse(unknown);
      if (found instanceof DataType.Unknown) {
        findings.unknownType(place, unknown.name(), declared.reason(unknown.name()));
      }
      return found;
    }
    return type;
  }

  private DataType body(String name, DataStructType struct, Place place) {
    Set<String> names = new HashSet<>();
    List<DataType.Member> members = new ArrayList<>();
    if (struct.getItems().isEmpty()) {
      findings.error(place, "has no <item>");
    }
    for (DataItemType item : struct.getItems()) {
      int line = XmlDocuments.line(item);
      String element = place.element() + "/item";
      String itemName =
          findings.identifier(item.getValue(), new Place(place.file(), line, element));
      Place at = new Place(place.file(), line, element + " " + itemName);
      if (!names.add(itemName)) {
        findings.error(at, "two items have this name");
      }
      String typeText = item.getType() == null ? "" : item.getType();
      if (typeText.isEmpty()) {
        findings.error(at, "has no type");
      }
      members.add(new DataType.Member(itemName, resolve(typeText, at).type()));
    }
    return new DataType.Struct(name, members);
  }

  static String text(@Nullable LocatedText text) {
    return text == null || text.getValue() == null ? "" : text.getValue();
  }

  static Place at(Place owner, LocatedText text) {
    int line = XmlDocuments.line(text);
    return line == 0 ? owner : new Place(owner.file(), line, owner.element());
  }
}
