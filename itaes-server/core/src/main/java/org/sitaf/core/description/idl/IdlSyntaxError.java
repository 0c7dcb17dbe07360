package org.sitaf.core.description.idl;

import java.util.Map;
import org.antlr.v4.runtime.Parser;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.misc.IntervalSet;
import org.jspecify.annotations.Nullable;

/** Describes a syntax error: the construct that is being read, and what is wrong with it. */
final class IdlSyntaxError {
  private static final int MAX_SHOWN = 60;

  /** The constructs that messages name, by the rule of the grammar. */
  private static final Map<String, String> CONSTRUCTS =
      Map.ofEntries(
          Map.entry("module", "module"),
          Map.entry("interfaceDeclaration", "interface"),
          Map.entry("operation", "operation"),
          Map.entry("attribute", "attribute"),
          Map.entry("struct", "struct"),
          Map.entry("exception", "exception"),
          Map.entry("union", "union"),
          Map.entry("enumeration", "enum"),
          Map.entry("bits", "bit set"),
          Map.entry("typedef", "typedef"),
          Map.entry("constant", "constant"),
          Map.entry("annotation", "annotation"));

  private IdlSyntaxError() {}

  static String text(Parser parser, Token token) {
    String found =
        token.getType() == Token.EOF ? "the end of the file" : "'" + shortened(token) + "'";
    IntervalSet expected = parser.getExpectedTokens();
    String missing =
        expected.size() == 1
            ? parser.getVocabulary().getLiteralName(expected.getMinElement())
            : null;
    String problem =
        missing != null
            ? missing + " is missing before " + found
            : found + " does not belong here" + hint(token);
    String construct = construct(parser, parser.getContext());
    return construct.isEmpty() ? problem : "in the " + construct + ": " + problem;
  }

  private static String hint(Token token) {
    return switch (token.getText()) {
      case "class", "template", "virtual", "public:", "private:", "#", "static", "int", "size_t" ->
          "; is it C++, which #if should leave out?";
      default -> "";
    };
  }

  private static String construct(Parser parser, @Nullable ParserRuleContext context) {
    for (ParserRuleContext at = context; at != null; at = at.getParent()) {
      String construct = CONSTRUCTS.get(parser.getRuleNames()[at.getRuleIndex()]);
      if (construct != null) {
        InterfaceDefinitionParser.NameContext name =
            at.getRuleContext(InterfaceDefinitionParser.NameContext.class, 0);
        return name == null || name.getText().isBlank()
            ? construct
            : construct + " " + IdlScopes.text(name);
      }
    }
    return "";
  }

  private static String shortened(Token token) {
    String text = token.getText();
    return text.length() <= MAX_SHOWN ? text : text.substring(0, MAX_SHOWN) + "...";
  }
}
