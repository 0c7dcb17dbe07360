package org.sitaf.runtime.simulation.frozen;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sitaf.sim.v1.CreateSessionResponse;
import org.sitaf.sim.v1.DeviceDescription;
import org.sitaf.sim.v1.ObservationDescription;
import org.sitaf.sim.v1.Quaternion;
import org.sitaf.sim.v1.Reading;
import org.sitaf.sim.v1.Vector3;

/**
 * The columns of a row in the response of PrepareMany: {@code device.field} for each number of each
 * device, then the observations.
 */
final class Layout {
  private record Place(int begin, int end, Reading first) {}

  private final List<String> columns = new ArrayList<>();
  private final Map<String, Place> devices = new HashMap<>();
  private final Map<String, Integer> observations = new LinkedHashMap<>();

  /** The layout of a session. Constants such as a sensor's limits come from its first state. */
  Layout(CreateSessionResponse created) {
    Map<String, Reading> first = new HashMap<>();
    created.getState().getReadingsList().forEach(r -> first.put(r.getDevice(), r));
    for (DeviceDescription device : created.getWorld().getDevicesList()) {
      int begin = columns.size();
      device.getFieldsList().forEach(field -> columns.add(device.getName() + "." + field));
      Reading reading = first.get(device.getName());
      if (reading != null) {
        devices.put(device.getName(), new Place(begin, columns.size(), reading));
      }
    }
    for (ObservationDescription observation : created.getWorld().getObservationsList()) {
      observations.put(observation.getName(), columns.size());
      columns.add(observation.getName());
    }
  }

  List<String> columns() {
    return columns;
  }

  Map<String, Double> observations(List<Double> row) {
    Map<String, Double> values = new LinkedHashMap<>();
    observations.forEach((name, column) -> values.put(name, row.get(column)));
    return values;
  }

  Reading reading(String device, List<Double> row) {
    Place place = devices.get(device);
    return place == null || place.begin() == place.end()
        ? Reading.getDefaultInstance()
        : reading(place.first(), row.subList(place.begin(), place.end()));
  }

  /** Builds a reading from numbers in the order of DeviceDescription.fields. */
  private static Reading reading(Reading first, List<Double> n) {
    Reading.Builder reading = first.toBuilder();
    switch (first.getValueCase()) {
      case RANGE -> reading.getRangeBuilder().setRangeM(n.get(0));
      case LASER_SCAN -> reading.getLaserScanBuilder().clearRangesM().addAllRangesM(n);
      case IMU ->
          reading
              .getImuBuilder()
              .setOrientation(rotation(n, 0))
              .setAngularVelocity(vector(n, 4))
              .setLinearAcceleration(vector(n, 7));
      case JOINT -> {
        reading.getJointBuilder().setPosition(n.get(0)).setVelocity(n.get(1));
        if (n.size() > 2) {
          reading.getJointBuilder().setEffort(n.get(2));
        }
      }
      case POSE ->
          reading.getPoseBuilder().setPosition(vector(n, 0)).setOrientation(rotation(n, 3));
      case WRENCH -> reading.getWrenchBuilder().setForce(vector(n, 0)).setTorque(vector(n, 3));
      case CONTACT -> reading.getContactBuilder().setPressed(n.get(0) != 0).setForceN(n.get(1));
      case DRIVE ->
          reading
              .getDriveBuilder()
              .setLinear(n.get(0))
              .setAngular(n.get(1))
              .setLeftPosition(n.get(2))
              .setRightPosition(n.get(3));
      case GRIPPER -> reading.getGripperBuilder().setWidthM(n.get(0)).setEffortN(n.get(1));
      case MAGNETIC_FIELD -> reading.getMagneticFieldBuilder().setField(vector(n, 0));
      case BATTERY ->
          reading
              .getBatteryBuilder()
              .setVoltageV(n.get(0))
              .setCurrentA(n.get(1))
              .setChargeAh(n.get(2))
              .setPercentage(n.get(3));
      case LEVEL -> reading.setLevel(n.get(0) != 0);
      case IMAGE, VALUE_NOT_SET -> {
        // Images are read separately from the simulator.
      }
    }
    return reading.build();
  }

  private static Vector3 vector(List<Double> n, int at) {
    return Vector3.newBuilder().setX(n.get(at)).setY(n.get(at + 1)).setZ(n.get(at + 2)).build();
  }

  private static Quaternion rotation(List<Double> n, int at) {
    return Quaternion.newBuilder()
        .setX(n.get(at))
        .setY(n.get(at + 1))
        .setZ(n.get(at + 2))
        .setW(n.get(at + 3))
        .build();
  }
}
