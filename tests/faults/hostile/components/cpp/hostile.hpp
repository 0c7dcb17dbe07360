#pragma once

#include <string>

namespace hostile {

/// A component that attacks the machine that tests it, in one of many ways; what it achieves, it
/// prints as `BREACH ...`.
class HostileComponent {
 public:
  void setKind(const std::string& kind) { kind_ = kind; }

  /// Attacks, as the property `Kind` says.
  double GetInfraredData(int indexOfSensor, int numOfSensor);

 private:
  std::string kind_;
};

}  // namespace hostile
