package org.sitaf.agent.toolchain.java;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.Arrays;
import java.util.Random;
import org.jacoco.core.data.ExecutionData;
import org.jacoco.core.data.ExecutionDataStore;
import org.jacoco.core.data.ExecutionDataWriter;
import org.jacoco.core.data.SessionInfo;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What JaCoCo writes is read; what pretends to be that takes no more room than it has itself. */
@Timeout(60)
class ExecutionRecordTest {
  private final ExecutionRecord record = new ExecutionRecord(name -> name.startsWith("demo/"));

  private static boolean[] probes(int number) {
    boolean[] probes = new boolean[number];
    for (int i = 0; i < number; i += 3) {
      probes[i] = true;
    }
    return probes;
  }

  private static byte[] recorded() throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ExecutionDataWriter writer = new ExecutionDataWriter(out);
    writer.visitSessionInfo(new SessionInfo("a session", 1, 2));
    ExecutionDataStore store = new ExecutionDataStore();
    store.put(new ExecutionData(-5, "demo/Component", probes(200)));
    store.put(new ExecutionData(6, "demo/Größe", probes(1)));
    store.put(new ExecutionData(7, "other/Thing", probes(9)));
    store.accept(writer);
    return out.toByteArray();
  }

  @Test
  void readsWhatJacocoWritesOfTheComponentsClasses() throws IOException {
    byte[] file = recorded();
    record.add(file);
    // JaCoCo appends to its file.
    record.add(file);

    assertThat(record.store().getContents()).hasSize(2);
    assertThat(record.store().get(-5).getProbes()).isEqualTo(probes(200));
    assertThat(record.store().get(-5).getName()).isEqualTo("demo/Component");
    assertThat(record.store().get(6).getName()).isEqualTo("demo/Größe");
  }

  @Test
  void halfARecordIsReadAsFarAsItGoes() throws IOException {
    byte[] file = recorded();
    for (int length = 0; length < file.length; length++) {
      new ExecutionRecord(name -> true).add(Arrays.copyOf(file, length));
    }
    record.add(Arrays.copyOf(file, file.length - 1));

    assertThat(record.store().getContents()).isNotEmpty();
  }

  @Test
  void nonsenseMakesNothing() {
    Random random = new Random(1);
    for (int i = 0; i < 20_000; i++) {
      byte[] nonsense = new byte[random.nextInt(200)];
      random.nextBytes(nonsense);
      if (nonsense.length > 0) {
        nonsense[0] = new byte[] {1, 0x10, 0x11}[i % 3];
      }
      record.add(nonsense);
    }

    assertThat(record.store().getContents()).isEmpty();
  }

  @Test
  void aRecordThatNamesManyProbesOrClassesIsBounded() throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    DataOutputStream out = new DataOutputStream(bytes);
    for (int i = 0; i < 100_000; i++) {
      out.writeByte(0x11);
      out.writeLong(i);
      out.writeUTF("demo/C");
      out.writeByte(1);
      out.writeByte(1);
    }
    record.add(bytes.toByteArray());
    assertThat(record.store().getContents()).hasSize(50_000);

    bytes.reset();
    out.writeByte(0x11);
    out.writeLong(-1);
    out.writeUTF("demo/D");
    out.write(new byte[] {-1, -1, -1, -1, 7});
    record.add(bytes.toByteArray());
    assertThat(record.store().get(-1)).isNull();
  }
}
