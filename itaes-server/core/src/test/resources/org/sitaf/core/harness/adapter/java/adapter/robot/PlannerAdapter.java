package robot;

import org.sitaf.runtime.Hardware;
import org.sitaf.runtime.Out;
import sitaf.interfaces.Busy;
import sitaf.interfaces.Mode;
import sitaf.interfaces.Path;
import sitaf.interfaces.Planner;
import sitaf.interfaces.Point;
import sitaf.interfaces.RangeFinder;

/** Binds the component to the interfaces of its test. */
public final class PlannerAdapter implements Planner {
  public PlannerAdapter(Hardware hardware, RangeFinder rangeFinder) {
    // Make the component here, and keep it in a field.
    // Through the hardware it reaches the simulated devices.
    // The test stub answers for what it requires.
  }

  @Override
  public Path Plan(Point goal, double[] weights, Out<Boolean> found, Out<Integer> budget) {
    // Pass the call on to the component, and return what it answers.
    // What comes back in a parameter goes there by set().
    throw new UnsupportedOperationException("Plan is not passed on yet");
  }

  @Override
  public void SetMode(Mode mode) throws Busy {
    // Pass the call on to the component.
    throw new UnsupportedOperationException("SetMode is not passed on yet");
  }

  @Override
  public void SetLimit(int limit) {
    // Pass the call on to the component.
    throw new UnsupportedOperationException("SetLimit is not passed on yet");
  }
}
