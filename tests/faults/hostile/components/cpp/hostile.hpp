#pragma once

#include <string>

namespace hostile {

/// A component that attacks the machine that tests it, in one of many ways; it reports
/// successful attacks as `BREACH ...`.
class HostileComponent {
 public:
  void setKind(const std::string& kind) { kind_ = kind; }

  /// Runs the attack of the property `Kind`.
  double GetInfraredData(int indexOfSensor, int numOfSensor);

 private:
  std::string kind_;
};

}  // namespace hostile
