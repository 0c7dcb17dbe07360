#include "planner_adapter.hpp"

#include <stdexcept>

namespace robot {

PlannerAdapter::PlannerAdapter(sitaf::Hardware& hardware,
                               sitaf::interfaces::RangeFinder& rangeFinder)
    : hardware_(hardware), rangeFinder_(rangeFinder) {
  // Create the component here.
}

sitaf::interfaces::Path PlannerAdapter::Plan(const sitaf::interfaces::Point& goal,
                                             const std::vector<double>& weights, bool& found,
                                             std::int32_t& budget) {
  // Delegate the call to the component and return its result.
  throw std::logic_error("Plan is not implemented yet");
}

void PlannerAdapter::SetMode(sitaf::interfaces::Mode mode) {
  // Delegate the call to the component.
  // May throw exceptions of sitaf::interfaces: Busy.
  throw std::logic_error("SetMode is not implemented yet");
}

void PlannerAdapter::SetLimit(std::int32_t limit) {
  // Delegate the call to the component.
  throw std::logic_error("SetLimit is not implemented yet");
}

}  // namespace robot
