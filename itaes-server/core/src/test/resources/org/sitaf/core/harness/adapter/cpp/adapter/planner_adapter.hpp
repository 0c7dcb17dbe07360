#pragma once

#include <cstdint>
#include <vector>

#include "sitaf/hardware.hpp"
#include "sitaf/interfaces/Busy.hpp"
#include "sitaf/interfaces/Mode.hpp"
#include "sitaf/interfaces/Path.hpp"
#include "sitaf/interfaces/Planner.hpp"
#include "sitaf/interfaces/Point.hpp"
#include "sitaf/interfaces/RangeFinder.hpp"

namespace robot {

/// Adapts the component to the interfaces of its test.
class PlannerAdapter : public sitaf::interfaces::Planner {
 public:
  PlannerAdapter(sitaf::Hardware& hardware, sitaf::interfaces::RangeFinder& rangeFinder);

  sitaf::interfaces::Path Plan(const sitaf::interfaces::Point& goal,
                               const std::vector<double>& weights, bool& found,
                               std::int32_t& budget) override;
  void SetMode(sitaf::interfaces::Mode mode) override;
  void SetLimit(std::int32_t limit) override;

 private:
  sitaf::Hardware& hardware_;
  sitaf::interfaces::RangeFinder& rangeFinder_;
  // Store the component here.
};

}  // namespace robot
