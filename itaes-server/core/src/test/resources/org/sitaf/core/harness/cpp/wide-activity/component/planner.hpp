#pragma once

#include "sitaf/hardware.hpp"
#include "sitaf/interfaces/Mode.hpp"
#include "sitaf/interfaces/Path.hpp"
#include "sitaf/interfaces/Point.hpp"
#include "sitaf/interfaces/RangeFinder.hpp"

class Planner {
 public:
  Planner(sitaf::interfaces::RangeFinder& finder, sitaf::Hardware& hardware);

  void setProperty(const std::string& name, const std::string& value);
  void SetMode(sitaf::interfaces::Mode mode);
  void SetLimit(std::int32_t limit);
  void onExecute();
  sitaf::interfaces::Path Plan(const sitaf::interfaces::Point& goal, const std::vector<double>& weights, bool& found,
                               std::int32_t& budget);
};
