package org.sitaf.runtime;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sitaf.runtime.component.CallBeside;
import org.sitaf.runtime.component.DataPort;
import org.sitaf.runtime.component.Hooks;
import org.sitaf.runtime.suite.CaseResult;
import org.sitaf.runtime.suite.TestCase;

/**
 * Base of the generated test drivers: life cycle of the component and results.
 *
 * @param <C> class of the component under test
 */
public abstract class SuiteDriver<C> {
  private final TestRun run;
  private final LifeCycle lifeCycle;
  private final Hooks hooks;
  private @Nullable C component;
  private @Nullable Object begun;
  private @Nullable CallBeside<?> pending;
  private boolean saved;

  /**
   * A driver within a run.
   *
   * @param notHooks methods of the component's interfaces, which its life must not call
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

  /** Makes the component and sets it up. */
  protected abstract C createComponent() throws Exception;

  /** Runs before each call, when the world and the stubs are set. */
  protected void beforeCase(C instance, TestCase testCase) throws Exception {}

  /** Runs after each call, before the result is judged. */
  protected void afterCase(C instance, TestCase testCase) throws Exception {}

  /**
   * The component of this case: made now, or that of the case before where it lives as long as the
   * suite.
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

  /**
   * A component, made with whatever of the hardware and of these stubs its constructor asks for.
   */
  protected final <T extends C> T newComponent(Class<T> type, Object... stubs) throws Exception {
    List<Object> available = new ArrayList<>(Arrays.asList(stubs));
    run.hardware().ifPresent(available::add);
    return ComponentUnderTest.create(type, available.toArray());
  }

  /** Sets a property by {@code setProperty(String, String)} or by the setter of its name. */
  protected final void setProperty(C instance, String name, String value) throws Exception {
    ComponentUnderTest.setProperty(instance, name, value);
  }

  /**
   * Initialises and starts a component, where its class has methods named so. A component that
   * begins its life twice does it once.
   */
  protected final void begin(C instance) throws Exception {
    if (begun != instance) {
      begun = instance;
      hooks.begin(instance);
    }
  }

  /** Does the work of one period of a periodic component. */
  protected final void execute(C instance) throws Exception {
    hooks.execute(instance);
  }

  /** What the component last sent through an output data port. */
  protected final @Nullable Object dataPort(C instance, String port) throws Exception {
    return DataPort.read(instance, port);
  }

  /** Begins a nonblocking call of the component; it is timed on its own thread. */
  protected final <T> CallBeside<T> beside(Callable<T> call) {
    CallBeside<T> beside = CallBeside.begin(run.stopwatch(), run.simulationIfAny(), call);
    pending = beside;
    return beside;
  }

  /** Measures the call under test. */
  protected final Stopwatch stopwatch() {
    return run.stopwatch();
  }

  /** Hands the result of the case, with the time of its call, over to the results file. */
  protected final void save(CaseResult result) throws IOException {
    Stopwatch watch = run.stopwatch();
    result.setTime(watch.componentMicros(), watch.hardwareMicros(), watch.stubMicros());
    run.save(result);
    saved = true;
  }

  /** Runs a case and says whether it got as far as saving its result. */
  final boolean runAndSave(TestCase testCase, CaseResult result) throws Exception {
    saved = false;
    pending = null;
    try {
      runCase(testCase, result);
    } finally {
      CallBeside<?> begunCall = pending;
      if (begunCall != null) {
        begunCall.giveUp();
      }
    }
    return saved;
  }

  /** Whether the result of the current case is in the file. */
  final boolean isSaved() {
    return saved;
  }

  final void endCase() throws Exception {
    if (lifeCycle == LifeCycle.CASE) {
      close();
    }
  }

  /** Ends the life of the component. */
  final void close() throws Exception {
    C last = component;
    component = null;
    if (last != null) {
      hooks.end(last);
    }
  }
}
