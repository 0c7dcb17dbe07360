import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.sitaf.runtime.Stopwatch;
import org.sitaf.runtime.actuator.JointMotor;
import org.sitaf.runtime.sensor.JointEncoder;
import org.sitaf.runtime.simulation.Simulation;

/** A controller of all joints at 250 Hz. Prints microseconds per tick, best of five. Arguments: target, world, joints. */
public final class Loops {
  public static void main(String[] arguments) throws Exception {
    int joints = Integer.parseInt(arguments[2]);
    Stopwatch stopwatch = new Stopwatch();
    try (Simulation simulation =
        Simulation.open(arguments[0], Path.of(arguments[1]), 1, stopwatch, count -> List.of())) {
      List<JointMotor> motors = new ArrayList<>();
      List<JointEncoder> encoders = new ArrayList<>();
      for (int i = 1; i <= joints; i++) {
        motors.add(simulation.hardware().jointMotor("motor" + i));
        encoders.add(simulation.hardware().jointEncoder("encoder" + i));
      }
      double best = Double.POSITIVE_INFINITY;
      for (int round = 0; round < 5; round++) {
        simulation.prepare(Map.of(), Duration.ZERO);
        simulation.every(
            Duration.ofMillis(4),
            () -> {
              for (int i = 0; i < joints; i++) {
                JointEncoder encoder = encoders.get(i);
                motors.get(i).effort(8 * (0.5 - encoder.position()) - encoder.velocity());
              }
            });
        long began = System.nanoTime();
        simulation.advance(Duration.ofSeconds(2));
        best = Math.min(best, (System.nanoTime() - began) / 1e3 / 500);
        if (Math.abs(encoders.get(0).position() - 0.5) > 0.1) {
          throw new IllegalStateException("not controlled: " + encoders.get(0).position());
        }
      }
      System.out.println(best);
    }
  }
}
