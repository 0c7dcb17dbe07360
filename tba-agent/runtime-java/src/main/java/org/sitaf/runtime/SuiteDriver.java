package org.sitaf.runtime;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.Callable;
import java.util.concurrent.ConcurrentHashMap;
import org.jspecify.annotations.Nullable;
import org.sitaf.runtime.component.DataPort;
import org.sitaf.runtime.component.Hooks;
import org.sitaf.runtime.component.NonblockingCall;
import org.sitaf.runtime.suite.CaseResult;
import org.sitaf.runtime.suite.TestCase;

/**
 * Base class of the generated test drivers: life cycle of the component and results.
 *
 * @param <C> class of the component under test
 */
public abstract class SuiteDriver<C> {
  private final TestRun run;
  private final LifeCycle lifeCycle;
  private final Hooks hooks;
  private @Nullable C component;
  private @Nullable Object started;

  /** Nonblocking calls whose outcome is not yet collected, by the thread that began each. */
  private final Map<Thread, NonblockingCall<?>> pending = new ConcurrentHashMap<>();

  private boolean saved;

  /**
   * Creates the driver of a run.
   *
   * @param notHooks methods of the component's interfaces; they are never called as hooks
   */
  protected SuiteDriver(TestRun run, LifeCycle lifeCycle, String... notHooks) {
    this.hooks = new Hooks(notHooks);
    this.run = Objects.requireNonNull(run);
    this.lifeCycle = Objects.requireNonNull(lifeCycle);
  }

  /**
   * Runs one case and saves its result, in the five steps of Fig. 10.
   *
   * @throws Exception what the component throws
   */
  protected abstract void runCase(TestCase testCase, CaseResult result) throws Exception;

  /** Creates the component and sets its properties. */
  protected abstract C createComponent() throws Exception;

  /** Called before each call under test, after the world and the stubs are set up. */
  protected void beforeCase(C instance, TestCase testCase) throws Exception {}

  /** Called after each call under test, before the result is saved. */
  protected void afterCase(C instance, TestCase testCase) throws Exception {}

  /**
   * The component of this case: a new one, or that of the previous case when one instance serves
   * the whole suite.
   */
  protected final C component() throws Exception {
    C current = component;
    if (current == null) {
      current = createComponent();
      component = current;
      begin(current);
    }
    return current;
  }

  /** Creates a component; its constructor gets the hardware and the stubs that it needs. */
  protected final <T extends C> T newComponent(Class<T> type, Object... stubs) throws Exception {
    List<Object> available = new ArrayList<>(Arrays.asList(stubs));
    run.hardware().ifPresent(available::add);
    return ComponentUnderTest.create(type, available.toArray());
  }

  /** Sets a property with {@code setProperty(String, String)} or with the setter of its name. */
  protected final void setProperty(C instance, String name, String value) throws Exception {
    ComponentUnderTest.setProperty(instance, name, value);
  }

  /**
   * Initialises and starts a component if its class has the methods. Further calls for the same
   * component do nothing.
   */
  protected final void begin(C instance) throws Exception {
    if (started != instance) {
      started = instance;
      hooks.begin(instance);
    }
  }

  /** Executes one period of a periodic component. */
  protected final void execute(C instance) throws Exception {
    hooks.execute(instance);
  }

  /** The last value that the component sent through an output data port. */
  protected final @Nullable Object dataPort(C instance, String port) throws Exception {
    return DataPort.read(instance, port);
  }

  /** Records an output data port, or the part that {@code signal} names, when it changes. */
  protected final void watch(String signal, Callable<?> read) throws Exception {
    run.watch(signal, () -> CaseResult.literalOfPart(signal, read.call()));
  }

  /** Starts a nonblocking call of the component; it is measured on its own thread. */
  protected final <T> NonblockingCall<T> callNonblocking(Callable<T> call) {
    NonblockingCall<T> nonblocking =
        NonblockingCall.begin(run.stopwatch(), run.simulationIfAny(), call);
    pending.put(Thread.currentThread(), nonblocking);
    return nonblocking;
  }

  /** Measures the call under test. */
  protected final Stopwatch stopwatch() {
    return run.stopwatch().ofThisThread();
  }

  /** Writes the result of the case, with the time of its call, to the results file. */
  protected final void save(CaseResult result) throws Exception {
    run.readPorts();
    Stopwatch watch = run.stopwatch();
    result.setTime(watch.componentMicros(), watch.hardwareMicros(), watch.stubMicros());
    run.save(result);
    saved = true;
  }

  /** Writes the end of a sequence, whose steps have their own times. */
  final void saveSequence(CaseResult result) throws Exception {
    run.readPorts();
    run.save(result);
    saved = true;
  }

  final TestRun run() {
    return run;
  }

  /** Ends a nonblocking call whose outcome was not collected. */
  final void giveUpCall() throws InterruptedException {
    NonblockingCall<?> begunCall = pending.remove(Thread.currentThread());
    if (begunCall != null) {
      begunCall.giveUp();
    }
  }

  /** Runs a case and returns whether its result was saved. */
  final boolean runAndSave(TestCase testCase, CaseResult result) throws Exception {
    saved = false;
    pending.clear();
    try {
      runCase(testCase, result);
    } finally {
      giveUpCall();
    }
    return saved;
  }

  /** Whether the result of the current case was saved. */
  final boolean isSaved() {
    return saved;
  }

  final void endCase() throws Exception {
    if (lifeCycle == LifeCycle.CASE) {
      close();
    }
  }

  /** Stops and closes the component. */
  final void close() throws Exception {
    C last = component;
    component = null;
    if (last != null) {
      hooks.end(last);
    }
  }
}
