package robot;

import sitaf.interfaces.Place;
import sitaf.interfaces.Refused;
import sitaf.interfaces.Sensor;

/** Records which hooks of its life cycle are called. */
public final class Probe {
  private final Sensor sensor;
  private String life = "";

  public Probe(Sensor sensor) {
    this.sensor = sensor;
  }

  public void initialise() {
    life += "initialise";
  }

  public void initialize() {
    life += "initialize";
  }

  public void start() {
    life += " start";
  }

  public void onStart() {
    life += " onStart";
  }

  public Place Locate(int kind) {
    if (kind == 2) {
      throw new Refused("kind 2");
    }
    return new Place(sensor.Read(0.5), 2, life);
  }
}
