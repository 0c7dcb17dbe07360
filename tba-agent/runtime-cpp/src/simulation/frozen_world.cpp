#include "simulation/frozen_world.hpp"

#include <algorithm>
#include <limits>

namespace sitaf::simulation {
namespace {

namespace wire = sim::v1;

/// Appends a reading's numbers in the order of the kind's fields.
class Numbers {
 public:
  Numbers(double* place, std::size_t count) : place_(place), left_(count) {}

  Numbers& operator<<(double number) {
    if (left_ > 0) {
      *place_++ = number;
      --left_;
    }
    return *this;
  }
  Numbers& operator<<(const wire::Vector3& v) { return *this << v.x() << v.y() << v.z(); }
  Numbers& operator<<(const wire::Quaternion& q) { return *this << q.x() << q.y() << q.z() << q.w(); }

 private:
  double* place_;
  std::size_t left_;
};

void flattenOne(const wire::Reading& reading, Numbers numbers) {
  switch (reading.value_case()) {
    case wire::Reading::kRange:
      numbers << reading.range().range_m();
      break;
    case wire::Reading::kLaserScan:
      for (const double range : reading.laser_scan().ranges_m()) {
        numbers << range;
      }
      break;
    case wire::Reading::kImu:
      numbers << reading.imu().orientation() << reading.imu().angular_velocity() << reading.imu().linear_acceleration();
      break;
    case wire::Reading::kJoint:
      numbers << reading.joint().position() << reading.joint().velocity() << reading.joint().effort();
      break;
    case wire::Reading::kPose:
      numbers << reading.pose().position() << reading.pose().orientation();
      break;
    case wire::Reading::kWrench:
      numbers << reading.wrench().force() << reading.wrench().torque();
      break;
    case wire::Reading::kContact:
      numbers << (reading.contact().pressed() ? 1.0 : 0.0) << reading.contact().force_n();
      break;
    case wire::Reading::kDrive:
      numbers << reading.drive().linear() << reading.drive().angular() << reading.drive().left_position()
              << reading.drive().right_position();
      break;
    case wire::Reading::kGripper:
      numbers << reading.gripper().width_m() << reading.gripper().effort_n();
      break;
    case wire::Reading::kMagneticField:
      numbers << reading.magnetic_field().field();
      break;
    case wire::Reading::kBattery:
      numbers << reading.battery().voltage_v() << reading.battery().current_a() << reading.battery().charge_ah()
              << reading.battery().percentage();
      break;
    case wire::Reading::kLevel:
      numbers << (reading.level() ? 1.0 : 0.0);
      break;
    case wire::Reading::kImage:
    case wire::Reading::VALUE_NOT_SET:
      break;
  }
}

std::vector<double> constantsOf(const wire::Reading& reading) {
  if (reading.has_range()) {
    return {reading.range().min_range_m(), reading.range().max_range_m()};
  }
  if (reading.has_laser_scan()) {
    const wire::LaserScan& scan = reading.laser_scan();
    return {scan.angle_min(), scan.angle_max(), scan.angle_increment(), scan.range_min_m(), scan.range_max_m()};
  }
  return {};
}

}  // namespace

Layout::Layout(const wire::CreateSessionResponse& created) {
  for (const wire::DeviceDescription& description : created.world().devices()) {
    Device device{description.name(), description.kind(), columns_.size(), static_cast<std::size_t>(description.fields_size()), {}};
    for (const std::string& field : description.fields()) {
      columns_.push_back(description.name() + "." + field);
    }
    for (const wire::Reading& reading : created.state().readings()) {
      if (reading.device() == device.name) {
        device.constants = constantsOf(reading);
      }
    }
    devices_.push_back(std::move(device));
  }
  firstObservation_ = columns_.size();
  for (const wire::ObservationDescription& description : created.world().observations()) {
    observations_.push_back(description.name());
    columns_.push_back(description.name());
  }
}

const Device* Layout::device(std::string_view name) const {
  const auto found = std::find_if(devices_.begin(), devices_.end(), [&](const Device& device) { return device.name == name; });
  return found == devices_.end() ? nullptr : &*found;
}

void Layout::flatten(const wire::WorldState& state, std::vector<double>& row) const {
  row.assign(width(), std::numeric_limits<double>::quiet_NaN());
  std::size_t next = 0;
  for (const wire::Reading& reading : state.readings()) {
    // Readings usually come in the order of the devices; search only when they do not.
    while (next < devices_.size() && devices_[next].name != reading.device()) {
      ++next;
    }
    const Device* device = next < devices_.size() ? &devices_[next] : this->device(reading.device());
    next = next < devices_.size() ? next + 1 : 0;
    if (device != nullptr) {
      flattenOne(reading, Numbers(row.data() + device->first, device->count));
    }
  }
  for (const wire::Observation& observation : state.observations()) {
    const auto found = std::find(observations_.begin(), observations_.end(), observation.name());
    if (found != observations_.end()) {
      row[firstObservation_ + static_cast<std::size_t>(found - observations_.begin())] = observation.value();
    }
  }
}

void FrozenWorld::freeze(const wire::WorldState& state) {
  std::vector<double> row;
  layout_.flatten(state, row);
  const std::lock_guard<std::mutex> lock(mutex_);
  numbers_.swap(row);
  time_ = std::chrono::nanoseconds(state.time_ns());
}

void FrozenWorld::freeze(std::chrono::nanoseconds time, const double* row) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::copy(row, row + layout_.width(), numbers_.begin());
  time_ = time;
}

std::chrono::nanoseconds FrozenWorld::time() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return time_;
}

}  // namespace sitaf::simulation
