package org.sitaf.hostile;

import java.io.File;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.RandomAccessFile;
import java.lang.reflect.Field;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;

/**
 * A component that attacks the machine that tests it, in one of many ways; it reports
 * successful attacks as {@code BREACH ...}.
 */
public final class HostileComponent {
  private static final int MIB = 1 << 20;
  private static final long MUCH = 3L << 30;
  private static final String PORTS = "@PORTS@";

  private String kind = "";

  public void setKind(String kind) {
    this.kind = kind;
  }

  /** Runs the attack of the property {@code Kind}. */
  public double GetInfraredData(int indexOfSensor, int numOfSensor) throws Exception {
    return switch (kind) {
      case "reads-agent-key" -> readsAgentKey();
      case "reads-secrets" -> readsSecrets();
      case "reads-environment" -> readsEnvironment();
      case "reads-processes" -> readsProcesses();
      case "other-builds" -> otherBuilds();
      case "writes-outside" -> writesOutside();
      case "set-user-id" -> shell("cp /bin/sh s; chmod 4777 s; chown 0:0 s && echo BREACH gives a file to root");
      case "links-left" -> linksLeft();
      case "pipes-left" -> inEachFolder(f -> shell("cd '" + f + "' && for n in 1.glb 2.glb 3.glb results jacoco.exec; do rm -f $n; mkfifo $n; done"));
      case "deep-folders" -> deepFolders();
      case "closed-folders" -> inEachFolder(HostileComponent::close);
      case "many-files" -> inEachFolder(HostileComponent::manyFiles);
      case "much-disk" -> muchDisk();
      case "sparse-files" -> inEachFolder(HostileComponent::sparse);
      case "odd-names" -> inEachFolder(f -> shell("cd '" + f + "' && touch 'a\nb' -- -rf '$(id)' \"$(printf '\\377\\376')\" \"$(printf '\\033[2J')\""));
      case "network-local" -> networkLocal();
      case "network-interfaces" -> networkInterfaces();
      case "kills-all" -> shell("kill -9 1; kill -9 $PPID; kill -9 -1");
      case "fork-bomb" -> shell("i=0; while [ $i -lt 5000 ]; do sleep 30 & i=$((i+1)); done; echo BREACH $i processes");
      case "orphans" -> shell("setsid sh -c 'trap \"\" TERM; exec 0<&- 1>&- 2>&-; sleep 3600; : sitaf-hostile-orphan' & sleep 0.3");
      case "orphans-with-output" -> shell("setsid sleep 3600 & sleep 0.2");
      case "hangs" -> hang();
      case "stops" -> shell("kill -STOP $PPID");
      case "burns-threads", "busy-threads" -> burnsThreads();
      case "exits" -> halt(0);
      case "exits-like-driver" -> exitsLikeDriver();
      case "crashes" -> shell("kill -SEGV $PPID");
      case "hangs-at-exit" -> hangsAtExit();
      case "memory" -> memory();
      case "memory-direct" -> memoryDirect();
      case "memory-of-children" -> shell("for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16; do (head -c 200000000 /dev/zero | tail -c 200000000 | (sleep 8; wc -c)) & done | awk '{s+=$1} END {if (s > 2147483648) print \"BREACH memory of children\", s}'");
      case "memory-dev-shm" -> memoryDevShm();
      case "threads" -> threads();
      case "user-namespaces" -> shell("unshare -Ur true && echo BREACH runs unshare -Ur");
      case "mounts" -> shell("mount -t tmpfs x /tmp && echo BREACH mounts");
      case "limits-raised" -> shell("ulimit -H -u unlimited 2>/dev/null && echo BREACH raises its limits");
      case "forges-results" -> forgesResults();
      case "forges-and-exits" -> forgesAndExits();
      case "forges-by-reflection" -> forgesByReflection();
      case "repeats-results" -> everywhere(forged(1).repeat(3).getBytes(StandardCharsets.UTF_8), 1);
      case "floods-results" -> everywhere("\n".repeat(MIB).getBytes(StandardCharsets.UTF_8), 250);
      case "garbles-results" -> everywhere("<not a result\n".repeat(MIB / 14).getBytes(StandardCharsets.UTF_8), 4);
      case "tears-results" -> everywhere("<case_record no=\"1\" outc".getBytes(StandardCharsets.UTF_8), 1);
      case "floods-output" -> floodsOutput();
      case "floods-marks" -> floodsMarks();
      case "long-message" -> throw new IllegalStateException("m".repeat(20 * MIB));
      case "odd-message" -> throw new IllegalStateException("]]><script>alert(1)</script>\0\u001b[2J\u202e\ud800&amp;\r\n=cmd|' /C calc'!A0");
      case "throws-error" -> throw new StackOverflowError("an error");
      default -> throw new IllegalArgumentException("there is no kind '" + kind + "'");
    };
  }

  @FunctionalInterface
  private interface Work {
    Object in(String folder) throws Exception;
  }

  private static void breach(String text) {
    System.out.println("BREACH " + text);
    System.out.flush();
  }

  private static double shell(String commands) throws Exception {
    Process process = new ProcessBuilder("/bin/sh", "-c", commands).inheritIO().start();
    process.waitFor(20, TimeUnit.SECONDS);
    return -1;
  }

  private static Set<String> writableFolders() throws IOException {
    Set<String> known = new LinkedHashSet<>();
    known.add(new File("").getAbsolutePath());
    known.add(System.getProperty("java.io.tmpdir"));
    for (String line : Files.readAllLines(Path.of("/proc/self/mountinfo"))) {
      known.add(line.split(" ")[4]);
    }
    known.removeIf(folder -> !new File(folder).isDirectory() || !new File(folder).canWrite());
    return known;
  }

  private static double inEachFolder(Work work) throws Exception {
    for (String folder : writableFolders()) {
      try {
        work.in(folder);
      } catch (IOException e) {
        // The next folder.
      }
    }
    return -1;
  }

  private static double readsAgentKey() {
    for (Path at = Path.of("").toAbsolutePath(); at != null; at = at.getParent()) {
      for (String name : List.of("key", "agent.key", "spool")) {
        try {
          Path path = at.resolve(name);
          if (Files.isDirectory(path) ? Files.list(path).count() >= 0 : Files.readAllBytes(path).length > 0) {
            breach("reads " + path);
          }
        } catch (IOException e) {
          // Expected.
        }
      }
    }
    return -1;
  }

  private static double readsSecrets() {
    for (String name : List.of("/etc/shadow", "/root/.ssh", "/root/.m2/settings.xml", "/var/lib/sitaf", "/etc/sitaf")) {
      if (new File(name).canRead()) {
        breach("reads " + name);
      }
    }
    return -1;
  }

  private static double readsEnvironment() {
    for (String name : System.getenv().keySet()) {
      if (name.matches(".*(TOKEN|SECRET|ENROL|PASSWORD).*")) {
        breach("sees the variable " + name);
      }
    }
    return -1;
  }

  private static double readsProcesses() {
    ProcessHandle.allProcesses()
        .filter(p -> p.info().commandLine().orElse("").matches(".*(agent\\.jar|sitaf-server).*"))
        .forEach(p -> breach("sees process " + p.pid()));
    return -1;
  }

  private static double otherBuilds() {
    Path own = Path.of("").toAbsolutePath();
    for (Path parent = own.getParent(); parent != null; parent = parent.getParent()) {
      File[] entries = parent.toFile().listFiles();
      for (File entry : entries == null ? new File[0] : entries) {
        if (entry.isDirectory() && !own.startsWith(entry.toPath()) && entry.getName().contains("attempt") && entry.list() != null) {
          breach("sees " + entry);
        }
      }
    }
    return -1;
  }

  private static double writesOutside() {
    List<String> places = new ArrayList<>(List.of("/etc", "/usr", "/opt", "/var/tmp", "/root", "/home", "/"));
    for (Path parent = Path.of("").toAbsolutePath().getParent(); parent != null; parent = parent.getParent()) {
      places.add(parent.toString());
    }
    for (String place : places) {
      File canary = new File(place, "sitaf-hostile-canary");
      try {
        if (canary.createNewFile()) {
          canary.delete();
        }
      } catch (IOException e) {
        // Expected.
      }
    }
    return -1;
  }

  private static double linksLeft() throws Exception {
    return inEachFolder(
        folder -> {
          for (String name : List.of("1.glb", "2.glb", "results", "jacoco.exec", "build.log")) {
            Files.createSymbolicLink(Path.of(folder, name), Path.of("/etc/passwd"));
          }
          return null;
        });
  }

  private static double deepFolders() throws Exception {
    return inEachFolder(
        folder ->
            shell("cd '" + folder + "'; i=0; d=" + "d".repeat(100) + "; while [ $i -lt 1000 ]; do mkdir $d && cd -P $d || break; i=$((i+1)); done 2>/dev/null"));
  }

  private static Object close(String folder) throws IOException {
    Path inner = Files.createDirectories(Path.of(folder, "closed", "inner"));
    Files.createFile(inner.resolve("file"));
    for (Path path : List.of(inner, inner.getParent(), Path.of(folder))) {
      Files.setPosixFilePermissions(path, PosixFilePermissions.fromString("---------"));
    }
    return null;
  }

  private static Object manyFiles(String folder) {
    int made = 0;
    try {
      for (; made < 300_000; made++) {
        Files.createFile(Path.of(folder, "f" + made));
      }
    } catch (IOException e) {
      // Expected: a limit was reached.
    }
    if (made >= 200_000) {
      breach("makes " + made + " files in " + folder);
    }
    return null;
  }

  private static double muchDisk() throws IOException {
    byte[] block = new byte[MIB];
    long total = 0;
    for (String folder : writableFolders()) {
      total += write(folder, block, MUCH - total);
    }
    tooMuch("disk", total);
    return -1;
  }

  private static long write(String folder, byte[] block, long most) {
    long total = 0;
    for (int i = 0; i < 20; i++) {
      try (OutputStream out = new FileOutputStream(new File(folder, "big" + i))) {
        for (int j = 0; j < 200 && total < most; j++) {
          out.write(block);
          total += block.length;
        }
      } catch (IOException e) {
        return total;
      }
    }
    return total;
  }

  private static Object sparse(String folder) throws IOException {
    try (RandomAccessFile file = new RandomAccessFile(new File(folder, "1.glb"), "rw")) {
      file.setLength(1L << 40);
    }
    return null;
  }

  private static void tooMuch(String what, long bytes) {
    if (bytes >= 2L << 30) {
      breach(what + ": " + bytes / MIB + " MiB");
    }
  }

  private static double networkLocal() {
    for (String port : PORTS.split(" ")) {
      for (String host : List.of("127.0.0.1", "::1")) {
        try (Socket socket = new Socket()) {
          socket.connect(new InetSocketAddress(host, Integer.parseInt(port)), 1000);
          breach("connects to " + host + ":" + port);
        } catch (IOException e) {
          // Expected.
        }
      }
    }
    return -1;
  }

  private static double networkInterfaces() throws IOException {
    for (NetworkInterface found : Collections.list(NetworkInterface.getNetworkInterfaces())) {
      if (!found.isLoopback()) {
        breach("sees the interface " + found.getName());
      }
    }
    return -1;
  }

  @SuppressWarnings("InfiniteLoopStatement")
  private static double hang() {
    while (true) {
      try {
        Thread.sleep(1000);
      } catch (InterruptedException e) {
        // Ignored.
      }
    }
  }

  private static double burnsThreads() throws InterruptedException {
    for (int i = 0; i < 400; i++) {
      Thread thread = new Thread(HostileComponent::spin);
      thread.setDaemon(true);
      try {
        thread.start();
      } catch (OutOfMemoryError e) {
        break;
      }
    }
    Thread.sleep(8000);
    return -1;
  }

  private static void spin() {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
    while (System.nanoTime() < end) {
      Thread.onSpinWait();
    }
  }

  private static double threads() throws InterruptedException {
    int started = 0;
    try {
      for (; started < 5000; started++) {
        Thread thread = new Thread(HostileComponent::hang);
        thread.setDaemon(true);
        thread.start();
      }
    } catch (OutOfMemoryError e) {
      // Expected: a limit was reached.
    }
    if (started >= 5000) {
      breach(started + " threads");
    }
    return -1;
  }

  private static double halt(int code) {
    Runtime.getRuntime().halt(code);
    return -1;
  }

  private static double exitsLikeDriver() {
    System.err.println("sitaf: the simulator is gone");
    System.err.flush();
    return halt(3);
  }

  private static double hangsAtExit() {
    Runtime.getRuntime().addShutdownHook(new Thread(HostileComponent::hang));
    return -1;
  }

  private static double memory() {
    List<byte[]> kept = new ArrayList<>();
    try {
      while (kept.size() < 3000) {
        byte[] block = new byte[MIB];
        Arrays.fill(block, (byte) kept.size());
        kept.add(block);
      }
    } catch (OutOfMemoryError e) {
      // Expected: a limit was reached.
    }
    tooMuch("memory", (long) kept.size() * MIB);
    return -1;
  }

  private static double memoryDirect() {
    List<ByteBuffer> kept = new ArrayList<>();
    try {
      while (kept.size() < 3000) {
        ByteBuffer block = ByteBuffer.allocateDirect(MIB);
        while (block.hasRemaining()) {
          block.putLong(-1);
        }
        kept.add(block);
      }
    } catch (OutOfMemoryError e) {
      // Expected: a limit was reached.
    }
    tooMuch("direct memory", (long) kept.size() * MIB);
    return -1;
  }

  private static double memoryDevShm() {
    tooMuch("/dev/shm", write("/dev/shm", new byte[MIB], MUCH));
    return -1;
  }

  private static String forged(int no) {
    return "<case_record no=\"" + no + "\" outcome=\"RETURNED\"><actual name=\"return\">1.0</actual>"
        + "</case_record>\n";
  }

  /** Writes to all possible destinations of results. */
  private static double everywhere(byte[] content, int times) throws IOException {
    List<Path> targets = new ArrayList<>();
    try (var found = Files.newDirectoryStream(Path.of("/proc/self/fd"))) {
      found.forEach(
          fd -> {
            if (Integer.parseInt(fd.getFileName().toString()) > 2) {
              targets.add(fd);
            }
          });
    }
    String[] words = Files.readString(Path.of("/proc/self/cmdline")).split("\0");
    int at = Arrays.asList(words).indexOf("--results");
    if (at >= 0) {
      targets.add(Path.of(words[at + 1]));
    }
    for (int i = 0; i < times; i++) {
      for (Path target : targets) {
        try (FileChannel out = FileChannel.open(target, StandardOpenOption.WRITE, StandardOpenOption.APPEND)) {
          if (!Files.isSymbolicLink(target) || !Files.readSymbolicLink(target).toString().startsWith("socket:")) {
            out.write(ByteBuffer.wrap(content));
          }
        } catch (IOException | UnsupportedOperationException | IllegalArgumentException e) {
          // The next one.
        }
      }
    }
    return -1;
  }

  private static double forgesResults() throws IOException {
    for (int no = 1; no < 60; no++) {
      everywhere(forged(no).getBytes(StandardCharsets.UTF_8), 1);
    }
    return -999;
  }

  private static double forgesAndExits() throws IOException {
    forgesResults();
    return halt(0);
  }

  /** Searches static fields of the runtime's classes for streams and writes to them. */
  private static double forgesByReflection() throws Exception {
    for (StackTraceElement frame : new Throwable().getStackTrace()) {
      Class<?> type = Class.forName(frame.getClassName());
      for (Field field : type.getDeclaredFields()) {
        try {
          field.setAccessible(true);
          Object value = field.get(null);
          if (value instanceof OutputStream out) {
            for (int no = 1; no < 60; no++) {
              out.write(forged(no).getBytes(StandardCharsets.UTF_8));
            }
            out.flush();
          }
        } catch (RuntimeException | IOException e) {
          // Not static, or not open.
        }
      }
    }
    return -999;
  }

  private static double floodsOutput() {
    String block = "line of output\n".repeat(70_000);
    for (int i = 0; i < 500; i++) {
      System.out.print(block);
      System.err.print(block);
    }
    return -1;
  }

  private static double floodsMarks() {
    String block = "\u001ecase 1\nx\n\u001ecase 2\ny\n".repeat(1000);
    for (int i = 0; i < 200; i++) {
      System.out.print(block);
    }
    return -1;
  }
}
