package org.sitaf.agent.sandbox;

import java.io.IOException;
import java.util.Map;

/** No sandbox: the process has this user's rights, but nothing of the agent's environment. */
record NoSandbox() implements Sandbox {
  @Override
  public String description() {
    return "none";
  }

  @Override
  public ConfinedProcess start(Confinement confinement) throws IOException {
    ProcessBuilder builder = new ProcessBuilder(confinement.command());
    builder.directory(confinement.working().toFile());
    // Nothing of the agent's environment is the component's business; what it holds may be secret.
    Map<String, String> environment = builder.environment();
    String path = environment.getOrDefault("PATH", "/usr/bin:/bin");
    environment.clear();
    environment.put("PATH", path);
    environment.put("HOME", confinement.working().toString());
    environment.put("TMPDIR", confinement.temporary().toString());
    environment.put("LANG", "C.UTF-8");
    environment.putAll(confinement.environment());
    ProcessGroup group = new ProcessGroup(ProcessGroup.markOf(confinement.working()));
    environment.put(ProcessGroup.VARIABLE, group.mark());
    Process process = builder.start();
    process.getOutputStream().close();
    return new ConfinedProcess(process, group);
  }
}
