package org.sitaf.agent.toolchain.cpp.inputs;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.Collections;
import java.util.NavigableMap;
import java.util.NavigableSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.sitaf.core.digest.Sha256;

/**
 * The inputs of a compiled file.
 *
 * @param application SHA-256 of the application's files that were opened, by path in its layout
 * @param files files of this machine that were opened, by printed path
 * @param folders folders of this machine that were searched
 * @param asked names that files of this machine searched in all include folders
 * @param found digest of the application's files that the names refer to
 */
public record Inputs(
    NavigableMap<String, String> application,
    NavigableMap<String, MachineFile> files,
    NavigableMap<String, Stamp> folders,
    NavigableSet<String> asked,
    String found) {
  /** Digest if no name refers to a file. */
  private static final String NOTHING = Sha256.hex(new byte[0]);

  private static final int MAX_COUNT = 200_000;

  public Inputs {
    application = Collections.unmodifiableNavigableMap(new TreeMap<>(application));
    files = Collections.unmodifiableNavigableMap(new TreeMap<>(files));
    folders = Collections.unmodifiableNavigableMap(new TreeMap<>(folders));
    asked = Collections.unmodifiableNavigableSet(new TreeSet<>(asked));
  }

  /** State of a file of this machine; the digest is empty if any modification counts. */
  record MachineFile(Stamp stamp, String sha256) {}

  /** Merges the files and folders of this machine; those of the application are dropped. */
  public Inputs ofMachineWith(Inputs more) {
    NavigableMap<String, MachineFile> allFiles = new TreeMap<>(files);
    allFiles.putAll(more.files);
    NavigableMap<String, Stamp> allFolders = new TreeMap<>(folders);
    allFolders.putAll(more.folders);
    return new Inputs(new TreeMap<>(), allFiles, allFolders, new TreeSet<>(), NOTHING);
  }

  /** SHA-256 of the files of this machine, by path. */
  public NavigableMap<String, String> digestsOnMachine() {
    NavigableMap<String, String> digests = new TreeMap<>();
    files.forEach((path, file) -> digests.put(path, file.sha256()));
    return digests;
  }

  /** Writes all fields. */
  public void write(DataOutputStream out) throws IOException {
    out.writeInt(application.size());
    for (var entry : application.entrySet()) {
      out.writeUTF(entry.getKey());
      out.writeUTF(entry.getValue());
    }
    out.writeUTF(found);
    out.writeInt(files.size());
    for (var entry : files.entrySet()) {
      out.writeUTF(entry.getKey());
      entry.getValue().stamp().write(out);
      out.writeUTF(entry.getValue().sha256());
    }
    out.writeInt(folders.size());
    for (var entry : folders.entrySet()) {
      out.writeUTF(entry.getKey());
      entry.getValue().write(out);
    }
    out.writeInt(asked.size());
    for (String name : asked) {
      out.writeUTF(name);
    }
  }

  /** Reads what {@link #write} wrote. */
  public static Inputs read(DataInputStream in) throws IOException {
    NavigableMap<String, String> application = new TreeMap<>();
    for (int i = count(in); i > 0; i--) {
      application.put(in.readUTF(), in.readUTF());
    }
    String found = in.readUTF();
    NavigableMap<String, MachineFile> files = new TreeMap<>();
    for (int i = count(in); i > 0; i--) {
      files.put(in.readUTF(), new MachineFile(Stamp.read(in), in.readUTF()));
    }
    NavigableMap<String, Stamp> folders = new TreeMap<>();
    for (int i = count(in); i > 0; i--) {
      folders.put(in.readUTF(), Stamp.read(in));
    }
    NavigableSet<String> asked = new TreeSet<>();
    for (int i = count(in); i > 0; i--) {
      asked.add(in.readUTF());
    }
    return new Inputs(application, files, folders, asked, found);
  }

  private static int count(DataInputStream in) throws IOException {
    int count = in.readInt();
    if (count < 0 || count > MAX_COUNT) {
      throw new IOException("not a list of inputs");
    }
    return count;
  }
}
