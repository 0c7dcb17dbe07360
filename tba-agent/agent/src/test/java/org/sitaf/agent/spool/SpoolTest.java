package org.sitaf.agent.spool;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SpoolTest {
  @TempDir private Path directory;

  @Test
  void keepsAnEntryAndItsLogAcrossRestarts() throws Exception {
    Path log = Files.writeString(directory.resolve("build.log"), "lines");
    Spool.open(directory.resolve("spool")).put("a", "result".getBytes(UTF_8), log, null);
    Files.delete(log);

    Spool.Entry entry = Spool.open(directory.resolve("spool")).entries().get(0);
    assertThat(entry.name()).isEqualTo("a");
    assertThat(entry.message()).asString(UTF_8).isEqualTo("result");
    assertThat(entry.log()).hasContent("lines");
  }

  @Test
  void keepsTheAttachmentsOfAnEntry() throws Exception {
    Path folder = Files.createDirectory(directory.resolve("recordings"));
    Files.writeString(folder.resolve("7.glb"), "seven");
    Spool spool = Spool.open(directory.resolve("spool"));
    spool.put("a", new byte[] {1}, null, folder);

    Spool.Entry entry = Spool.open(directory.resolve("spool")).entries().get(0);
    assertThat(entry.attachments())
        .singleElement()
        .satisfies(f -> assertThat(f).hasContent("seven"));
    assertThat(spool.put("b", new byte[] {1}, null, directory.resolve("nowhere")).attachments())
        .isEmpty();
  }

  @Test
  void ignoresAnIncompleteEntry() throws Exception {
    Path spool = directory.resolve("spool");
    Files.createDirectories(spool.resolve("tmp.half"));
    Files.writeString(spool.resolve("tmp.half/message"), "ha");

    assertThat(Spool.open(spool).entries()).isEmpty();
    assertThat(spool).isEmptyDirectory();
  }

  @Test
  void deletesAnEntry() throws Exception {
    Spool spool = Spool.open(directory);
    spool.delete(spool.put("a", new byte[] {1}, null, null));

    assertThat(spool.entries()).isEmpty();
    assertThat(directory).isEmptyDirectory();
  }

  @Test
  void keepsARejectedEntryOutOfTheEntries() throws Exception {
    Spool spool = Spool.open(directory);
    Path aside = spool.reject(spool.put("a", new byte[] {1}, null, null));

    assertThat(spool.entries()).isEmpty();
    assertThat(aside.resolve("message")).hasBinaryContent(new byte[] {1});
    assertThat(Spool.open(directory).entries()).isEmpty();
    assertThat(aside).exists();
  }

  @Test
  void setsAReplacedEntryAsideAndKeepsItsLogInBoth() throws Exception {
    Spool spool = Spool.open(directory.resolve("spool"));
    Path log = Files.writeString(directory.resolve("build.log"), "lines");
    Spool.Entry replaced = spool.replace(spool.put("a", new byte[] {1}, log, null), new byte[] {2});

    assertThat(spool.entries()).containsExactly(replaced);
    assertThat(replaced.message()).containsExactly(2);
    assertThat(replaced.log()).hasContent("lines");
    assertThat(directory.resolve("spool/rejected.a/message")).hasBinaryContent(new byte[] {1});
    assertThat(directory.resolve("spool/rejected.a/log")).hasContent("lines");
  }

  @Test
  void keepsTwoRejectedEntriesOfTheSameName() throws Exception {
    Spool spool = Spool.open(directory);
    Path first = spool.reject(spool.put("a", new byte[] {1}, null, null));
    Path second = spool.reject(spool.put("a", new byte[] {2}, null, null));

    assertThat(first.resolve("message")).hasBinaryContent(new byte[] {1});
    assertThat(second.resolve("message")).hasBinaryContent(new byte[] {2});
    assertThat(spool.entries()).isEmpty();
  }

  @Test
  void setsAnEntryWithoutAMessageAside() throws Exception {
    Spool spool = Spool.open(directory);
    spool.put("b", new byte[] {1}, null, null);
    Files.createDirectory(directory.resolve("a"));
    Files.createDirectories(directory.resolve("c").resolve("message"));
    Files.writeString(directory.resolve("d"), "a file");

    assertThat(spool.entries()).extracting(Spool.Entry::name).containsExactly("b");
    assertThat(directory.resolve("rejected.a")).exists();
    assertThat(directory.resolve("rejected.c")).exists();
    assertThat(Spool.open(directory).entries()).hasSize(1);
  }

  @Test
  void replacesAnEntryOfTheSameName() throws Exception {
    Spool spool = Spool.open(directory);
    spool.put("a", new byte[] {1}, null, null);
    spool.put("a", new byte[] {2}, null, null);

    assertThat(spool.entries()).hasSize(1);
    assertThat(spool.entries().get(0).message()).containsExactly(2);
  }

  @Test
  void rejectsAPathAsName() throws Exception {
    Spool spool = Spool.open(directory);

    assertThatThrownBy(() -> spool.put("../a", new byte[0], null, null))
        .isInstanceOf(IllegalArgumentException.class);
  }
}
