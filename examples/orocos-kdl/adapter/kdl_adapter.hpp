#pragma once

#include <kdl/chain.hpp>

#include "sitaf/interfaces/Kinematics.hpp"

/// Adapts the Kinematics and Dynamics Library to the interface under test: a planar arm with two links.
class KdlAdapter : public sitaf::interfaces::Kinematics {
 public:
  KdlAdapter();

  sitaf::interfaces::Point ForwardKinematics(double shoulder, double elbow) override;
  double InverseKinematics(double x, double y) override;
  double ProfilePosition(double distance, double time) override;

 private:
  KDL::Chain arm_;
};
