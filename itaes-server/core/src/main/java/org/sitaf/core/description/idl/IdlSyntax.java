package org.sitaf.core.description.idl;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.antlr.v4.runtime.BaseErrorListener;
import org.antlr.v4.runtime.CharStreams;
import org.antlr.v4.runtime.CommonToken;
import org.antlr.v4.runtime.CommonTokenStream;
import org.antlr.v4.runtime.Parser;
import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.RecognitionException;
import org.antlr.v4.runtime.Recognizer;
import org.antlr.v4.runtime.Token;
import org.antlr.v4.runtime.misc.ParseCancellationException;
import org.sitaf.core.description.idl.InterfaceDefinitionParser.SpecificationContext;
import org.sitaf.core.description.idl.preprocessor.PreprocessedText;
import org.sitaf.core.diagnostic.Diagnostics;

/** Parses OMG IDL. */
final class IdlSyntax {
  /** Maximum nesting of brackets. The parser recurses once per level. */
  private static final int MAX_DEPTH = 40;

  /**
   * Maximum number of scopes in a name. The parser looks ahead to the end of the name at each
   * scope, which takes quadratic time.
   */
  private static final int MAX_SCOPES = 40;

  /** Parsing stops after this number of errors. */
  private static final int MAX_ERRORS = 20;

  private IdlSyntax() {}

  /**
   * A parse tree, whose positions are those of the files that its text came from.
   *
   * @param files of the tokens, by index
   */
  record Tree(SpecificationContext specification, List<String> files) {
    Tree {
      files = List.copyOf(files);
    }

    /** The file in which a construct begins. */
    String file(ParserRuleContext context) {
      return files.get(context.getStart().getTokenIndex());
    }

    /** Where a construct begins; equal for the same construct of a file that is read twice. */
    String place(ParserRuleContext context) {
      Token start = context.getStart();
      return file(context) + ":" + start.getLine() + ":" + start.getCharPositionInLine();
    }
  }

  /** Returns the parse tree, or empty after syntax errors, which are added to the diagnostics. */
  static Optional<Tree> parse(PreprocessedText text, Diagnostics diagnostics) {
    var lexer = new InterfaceDefinitionLexer(CharStreams.fromString(text.text()));
    lexer.removeErrorListeners();
    var tokens = new CommonTokenStream(lexer);
    tokens.fill();
    List<String> files = new ArrayList<>();
    for (Token token : tokens.getTokens()) {
      PreprocessedText.Origin origin = text.origin(token.getLine());
      files.add(origin.file());
      ((CommonToken) token).setLine(origin.line());
    }
    if (!isShallow(tokens, files, diagnostics)) {
      return Optional.empty();
    }
    var parser = new InterfaceDefinitionParser(tokens);
    parser.removeErrorListeners();
    parser.addErrorListener(new Reporter(files, diagnostics));
    try {
      SpecificationContext tree = parser.specification();
      return parser.getNumberOfSyntaxErrors() == 0 && !diagnostics.hasErrors()
          ? Optional.of(new Tree(tree, files))
          : Optional.empty();
    } catch (ParseCancellationException e) {
      return Optional.empty();
    }
  }

  private static boolean isShallow(
      CommonTokenStream tokens, List<String> files, Diagnostics diagnostics) {
    int depth = 0;
    int angles = 0;
    int scopes = 0;
    for (Token token : tokens.getTokens()) {
      if (token.getText().equals("::")) {
        scopes++;
      } else if (token.getType() != InterfaceDefinitionLexer.IDENTIFIER) {
        scopes = 0;
      }
      switch (token.getText()) {
        case "{" -> {
          depth++;
          angles = 0;
        }
        case "(", "[" -> depth++;
        case ")", "]" -> depth = Math.max(0, depth - 1);
        case "}" -> {
          depth = Math.max(0, depth - 1);
          angles = 0;
        }
        // A shift operator has no closing bracket; it ends with its statement.
        case ";" -> angles = 0;
        case "<" -> angles++;
        case ">" -> angles = Math.max(0, angles - 1);
        default -> {
          // Other tokens do not change the nesting.
        }
      }
      if (depth + angles > MAX_DEPTH) {
        diagnostics.error(
            files.get(token.getTokenIndex()),
            token.getLine(),
            "",
            "brackets nest deeper than " + MAX_DEPTH + " levels");
        return false;
      }
      if (scopes > MAX_SCOPES) {
        diagnostics.error(
            files.get(token.getTokenIndex()),
            token.getLine(),
            "",
            "a name has more than " + MAX_SCOPES + " scopes");
        return false;
      }
    }
    return true;
  }

  private static final class Reporter extends BaseErrorListener {
    private final List<String> files;
    private final Diagnostics diagnostics;
    private int errors;

    Reporter(List<String> files, Diagnostics diagnostics) {
      this.files = files;
      this.diagnostics = diagnostics;
    }

    @Override
    public void syntaxError(
        Recognizer<?, ?> recognizer,
        Object symbol,
        int line,
        int column,
        String message,
        RecognitionException cause) {
      Token token = (Token) symbol;
      String file = files.get(token.getTokenIndex());
      diagnostics.error(
          file,
          token.getLine(),
          "",
          "column " + (column + 1) + ": " + IdlSyntaxError.text((Parser) recognizer, token));
      errors++;
      if (errors >= MAX_ERRORS) {
        diagnostics.error(file, token.getLine(), "", "too many errors; the rest was not read");
        throw new ParseCancellationException();
      }
    }
  }
}
