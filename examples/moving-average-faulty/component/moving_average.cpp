#include "moving_average.hpp"

#include <string>

namespace filter {

double MovingAverage::MeanOfLast(const std::vector<double>& samples, std::int32_t window) const {
  const auto size = static_cast<std::int32_t>(samples.size());
  if (window < 1 || window > size) {
    throw WindowError("the window must hold 1 to " + std::to_string(size) + " samples");
  }
  std::vector<double> recent(window);
  for (std::int32_t i = 0; i <= window; ++i) {
    recent[i] = samples[size - window + i];
  }
  double sum = 0.0;
  for (const double sample : recent) {
    sum += sample;
  }
  return sum / window;
}

}  // namespace filter
