package org.sitaf.agent.toolchain.cpp.inputs;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.Collections;
import java.util.NavigableMap;
import java.util.NavigableSet;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * What went into something that was compiled.
 *
 * @param application SHA-256 of the application's files that were opened, by path in its layout
 * @param files of the machine that were opened, by the path that the tool printed
 * @param folders of the machine in which a name was looked for
 * @param asked names that other files than the application's looked for in all include folders
 * @param found digest of what each name means in the application
 */
public record Inputs(
    NavigableMap<String, String> application,
    NavigableMap<String, MachineFile> files,
    NavigableMap<String, Stamp> folders,
    NavigableSet<String> asked,
    String found) {
  /** What no names mean. */
  private static final String NOTHING = Machine.sha256(new byte[0]);

  private static final int AT_MOST = 200_000;

  public Inputs {
    application = Collections.unmodifiableNavigableMap(new TreeMap<>(application));
    files = Collections.unmodifiableNavigableMap(new TreeMap<>(files));
    folders = Collections.unmodifiableNavigableMap(new TreeMap<>(folders));
    asked = Collections.unmodifiableNavigableSet(new TreeSet<>(asked));
  }

  /** A file of the machine as it was; the digest is empty where any change of it counts. */
  record MachineFile(Stamp stamp, String sha256) {}

  /** These and more files and folders of the machine; what is of the application is left out. */
  public Inputs ofMachineWith(Inputs more) {
    NavigableMap<String, MachineFile> allFiles = new TreeMap<>(files);
    allFiles.putAll(more.files);
    NavigableMap<String, Stamp> allFolders = new TreeMap<>(folders);
    allFolders.putAll(more.folders);
    return new Inputs(new TreeMap<>(), allFiles, allFolders, new TreeSet<>(), NOTHING);
  }

  /** SHA-256 of each file of the machine, by path. */
  public NavigableMap<String, String> digestsOnMachine() {
    NavigableMap<String, String> digests = new TreeMap<>();
    files.forEach((path, file) -> digests.put(path, file.sha256()));
    return digests;
  }

  /** Writes all of it. */
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

  /** Reads what was written. */
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
    if (count < 0 || count > AT_MOST) {
      throw new IOException("not a list of inputs");
    }
    return count;
  }
}
