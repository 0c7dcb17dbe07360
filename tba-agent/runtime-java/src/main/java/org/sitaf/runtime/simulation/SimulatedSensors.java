package org.sitaf.runtime.simulation;

import org.sitaf.runtime.RangeSensor;
import org.sitaf.runtime.geometry.Quaternion;
import org.sitaf.runtime.geometry.Vector;
import org.sitaf.runtime.sensor.Battery;
import org.sitaf.runtime.sensor.Camera;
import org.sitaf.runtime.sensor.ContactSensor;
import org.sitaf.runtime.sensor.ForceTorqueSensor;
import org.sitaf.runtime.sensor.ImuSensor;
import org.sitaf.runtime.sensor.LaserScanner;
import org.sitaf.runtime.sensor.Magnetometer;
import org.sitaf.runtime.sensor.PoseSensor;
import org.sitaf.runtime.simulation.SimulatedHardware.Access;
import org.sitaf.sim.v1.Reading;
import org.sitaf.sim.v1.Vector3;

/** The sensors of a simulated robot, as views of its readings. */
final class SimulatedSensors {
  private SimulatedSensors() {}

  record Range(Access access) implements SimulatedDevice, RangeSensor {
    @Override
    public double range() {
      return access.read(
          reading -> reading.hasRange() ? reading.getRange().getRangeM() : Double.NaN);
    }

    @Override
    public double minRange() {
      return access.read(
          reading -> reading.hasRange() ? reading.getRange().getMinRangeM() : Double.NaN);
    }

    @Override
    public double maxRange() {
      return access.read(
          reading -> reading.hasRange() ? reading.getRange().getMaxRangeM() : Double.NaN);
    }
  }

  record Scanner(Access access) implements SimulatedDevice, LaserScanner {
    @Override
    public double angleMin() {
      return access.read(reading -> reading.getLaserScan().getAngleMin());
    }

    @Override
    public double angleMax() {
      return access.read(reading -> reading.getLaserScan().getAngleMax());
    }

    @Override
    public double angleIncrement() {
      return access.read(reading -> reading.getLaserScan().getAngleIncrement());
    }

    @Override
    public double minRange() {
      return access.read(reading -> reading.getLaserScan().getRangeMinM());
    }

    @Override
    public double maxRange() {
      return access.read(reading -> reading.getLaserScan().getRangeMaxM());
    }

    @Override
    public double[] ranges() {
      return access.read(
          reading ->
              reading.getLaserScan().getRangesMList().stream()
                  .mapToDouble(Double::doubleValue)
                  .toArray());
    }
  }

  record Imu(Access access) implements SimulatedDevice, ImuSensor {
    @Override
    public Quaternion orientation() {
      return access.read(reading -> rotation(reading.getImu().getOrientation()));
    }

    @Override
    public Vector angularVelocity() {
      return access.read(reading -> vector(reading.getImu().getAngularVelocity()));
    }

    @Override
    public Vector linearAcceleration() {
      return access.readAfterCommands(reading -> vector(reading.getImu().getLinearAcceleration()));
    }
  }

  record Encoder(Access access) implements SimulatedJoint {}

  record Pose(Access access) implements SimulatedDevice, PoseSensor {
    @Override
    public Vector position() {
      return access.read(reading -> vector(reading.getPose().getPosition()));
    }

    @Override
    public Quaternion orientation() {
      return access.read(reading -> rotation(reading.getPose().getOrientation()));
    }
  }

  record Force(Access access) implements SimulatedDevice, ForceTorqueSensor {
    @Override
    public Vector force() {
      return access.readAfterCommands(reading -> vector(reading.getWrench().getForce()));
    }

    @Override
    public Vector torque() {
      return access.readAfterCommands(reading -> vector(reading.getWrench().getTorque()));
    }
  }

  record Bumper(Access access) implements SimulatedDevice, ContactSensor {
    @Override
    public boolean isPressed() {
      return access.readAfterCommands(reading -> reading.getContact().getPressed());
    }

    @Override
    public double force() {
      return access.readAfterCommands(reading -> reading.getContact().getForceN());
    }
  }

  record Compass(Access access) implements SimulatedDevice, Magnetometer {
    @Override
    public Vector field() {
      return access.read(reading -> vector(reading.getMagneticField().getField()));
    }
  }

  record Accumulator(Access access) implements SimulatedDevice, Battery {
    @Override
    public double voltage() {
      return access.read(reading -> reading.getBattery().getVoltageV());
    }

    @Override
    public double current() {
      return access.read(reading -> reading.getBattery().getCurrentA());
    }

    @Override
    public double charge() {
      return access.read(reading -> reading.getBattery().getChargeAh());
    }

    @Override
    public double percentage() {
      return access.read(reading -> reading.getBattery().getPercentage());
    }
  }

  record Eye(Access access) implements SimulatedDevice, Camera {
    @Override
    public Image image() {
      Reading reading = access.look();
      org.sitaf.sim.v1.Image image = reading.getImage();
      return new Image(
          image.getWidth(),
          image.getHeight(),
          image.getEncoding(),
          image.getData().asReadOnlyByteBuffer());
    }
  }

  private static Vector vector(Vector3 wire) {
    return new Vector(wire.getX(), wire.getY(), wire.getZ());
  }

  private static Quaternion rotation(org.sitaf.sim.v1.Quaternion wire) {
    return new Quaternion(wire.getX(), wire.getY(), wire.getZ(), wire.getW());
  }
}
