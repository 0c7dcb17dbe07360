package org.sitaf.core.model.document;

import java.io.InputStream;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.document.ElementLines;
import org.sitaf.core.document.SchemaNames;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.core.model.TestModel;
import org.sitaf.schemas.TestModelDocument;

/** Reads test model documents (schemas/test_model.xsd). */
public final class TestModelXml {
  private static final String ROOT = "test_model";
  private static final SchemaNames NAMES = SchemaNames.of("test_model.xsd", ROOT);

  private TestModelXml() {}

  /**
   * Reads a test model and checks that it is consistent.
   *
   * @param file name of the document, for diagnostics
   * @throws org.sitaf.core.diagnostic.InvalidInputException with all problems of the document
   */
  public static TestModel read(InputStream document, String file) {
    Diagnostics diagnostics = new Diagnostics();
    ElementLines lines = new ElementLines(RelationReader.HOLDS);
    TestModelDocument root =
        XmlDocuments.readStrictly(
            document, file, ROOT, TestModelDocument.class, diagnostics, lines, NAMES);
    TestModel model = new TestModelReader(file, diagnostics, lines).read(root);
    diagnostics.throwIfErrors();
    return model;
  }
}
