package org.sitaf.cli.file;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;
import org.sitaf.agent.spool.LeastRecentlyUsed;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.Severity;
import org.sitaf.core.digest.Sha256;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GeneratedSuite;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.suite.document.TestSuiteXml;

/**
 * Suites that were generated before, since a search for few cases may take seconds. The key covers
 * the model with its resolved types, the options, and the files of the generator. Files are added
 * and removed by renaming, so processes share the folder without locks.
 */
public final class SuiteCache {
  private static final int MAX_CASES = 20_000;
  private static final LeastRecentlyUsed BOUNDS = new LeastRecentlyUsed(256L << 20, 200);
  private static final int MAX_BYTES = 64 << 20;
  private static final String SUFFIX = ".suite";

  private final Path folder;

  /** Uses a folder, which is created if missing. */
  public SuiteCache(Path folder) {
    this.folder = folder;
  }

  /**
   * Generates the cases of a model, or finds them.
   *
   * @throws org.sitaf.core.diagnostic.InvalidInputException as the generator
   */
  public GeneratedSuite generate(TestModel model, GenerationOptions options) {
    Path file = folder.resolve(key(model, options) + SUFFIX);
    Optional<GeneratedSuite> known = read(file);
    if (known.isPresent()) {
      return known.get();
    }
    GeneratedSuite generated = TestCaseGenerator.generate(model, options);
    if (generated.suite().cases().size() <= MAX_CASES) {
      store(generated, file);
    }
    return generated;
  }

  private static String key(TestModel model, GenerationOptions options) {
    MessageDigest digest = Sha256.newDigest();
    for (String part : List.of(model.toString(), options.toString(), generator())) {
      digest.update(part.getBytes(StandardCharsets.UTF_8));
      digest.update((byte) 0);
    }
    return Sha256.hex(digest);
  }

  /** The file of the generator with its size and time, which differ between builds of a version. */
  private static String generator() {
    try {
      Path code =
          Path.of(
              TestCaseGenerator.class.getProtectionDomain().getCodeSource().getLocation().toURI());
      return code + " " + Files.size(code) + " " + Files.getLastModifiedTime(code);
    } catch (java.net.URISyntaxException | IOException e) {
      // Without an identity, nothing is found again.
      return String.valueOf(System.nanoTime());
    }
  }

  private static Optional<GeneratedSuite> read(Path file) {
    if (!Files.isRegularFile(file)) {
      return Optional.empty();
    }
    try (DataInputStream in =
        new DataInputStream(
            new GZIPInputStream(new BufferedInputStream(Files.newInputStream(file))))) {
      List<Diagnostic> notes = new ArrayList<>();
      for (int left = in.readInt(); left > 0; left--) {
        notes.add(
            new Diagnostic(
                Severity.valueOf(in.readUTF()),
                in.readUTF(),
                in.readInt(),
                in.readUTF(),
                in.readUTF()));
      }
      TestSuite suite =
          TestSuiteXml.read(
              new ByteArrayInputStream(in.readNBytes(MAX_BYTES)), file.getFileName().toString());
      // Files that were not used for long are removed first.
      LeastRecentlyUsed.touch(file);
      return Optional.of(new GeneratedSuite(suite, notes));
    } catch (IOException | IllegalArgumentException e) {
      return Optional.empty();
    } catch (org.sitaf.core.diagnostic.InvalidInputException e) {
      return Optional.empty();
    }
  }

  /**
   * Stores a suite, if it is the same after reading. A folder that cannot be written is no error.
   */
  private void store(GeneratedSuite generated, Path file) {
    try {
      Files.createDirectories(folder);
      Path temporary = Files.createTempFile(folder, "new", ".tmp");
      try {
        try (DataOutputStream out =
            new DataOutputStream(
                new GZIPOutputStream(new BufferedOutputStream(Files.newOutputStream(temporary))))) {
          out.writeInt(generated.notes().size());
          for (Diagnostic note : generated.notes()) {
            out.writeUTF(note.severity().name());
            out.writeUTF(note.file());
            out.writeInt(note.line());
            out.writeUTF(note.element());
            out.writeUTF(note.message());
          }
          ByteArrayOutputStream document = new ByteArrayOutputStream();
          TestSuiteXml.write(generated.suite(), document);
          out.write(document.toByteArray());
        }
        if (read(temporary).equals(Optional.of(generated))) {
          Files.move(temporary, file, StandardCopyOption.ATOMIC_MOVE);
          removeOldest();
        }
      } finally {
        Files.deleteIfExists(temporary);
      }
    } catch (IOException | IllegalArgumentException e) {
      // The suite is generated again next time.
    }
  }

  private void removeOldest() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      BOUNDS.shrink(
          files.filter(f -> f.toString().endsWith(SUFFIX)).toList(),
          file -> file.toFile().length(),
          Files::deleteIfExists);
    }
  }
}
