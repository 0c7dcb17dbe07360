#include "kdl_adapter.hpp"

#include <cmath>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <kdl/velocityprofile_trap.hpp>

namespace {

constexpr double upperLink = 0.5;
constexpr double lowerLink = 0.3;
constexpr double maxVelocity = 1.0;
constexpr double maxAcceleration = 2.0;

/// The value that InverseKinematics returns if the solver finds no solution.
constexpr double noSolution = -1.0;

}  // namespace

KdlAdapter::KdlAdapter() {
  arm_.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::RotZ), KDL::Frame(KDL::Vector(upperLink, 0, 0))));
  arm_.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::RotZ), KDL::Frame(KDL::Vector(lowerLink, 0, 0))));
}

sitaf::interfaces::Point KdlAdapter::ForwardKinematics(double shoulder, double elbow) {
  KDL::ChainFkSolverPos_recursive solver(arm_);
  KDL::JntArray angles(2);
  angles(0) = shoulder;
  angles(1) = elbow;
  KDL::Frame tip;
  solver.JntToCart(angles, tip);
  return {tip.p.x(), tip.p.y(), tip.p.z()};
}

double KdlAdapter::InverseKinematics(double x, double y) {
  // The orientation of the tip is free: an arm with two joints cannot control it.
  Eigen::Matrix<double, 6, 1> weights;
  weights << 1, 1, 1, 0, 0, 0;
  KDL::ChainIkSolverPos_LMA solver(arm_, weights);
  KDL::JntArray start(2);
  start(0) = 0.3;
  start(1) = 0.7;
  KDL::JntArray found(2);
  const int error = solver.CartToJnt(start, KDL::Frame(KDL::Vector(x, y, 0)), found);
  if (error != KDL::SolverI::E_NOERROR) {
    return noSolution;
  }
  const sitaf::interfaces::Point tip = ForwardKinematics(found(0), found(1));
  return std::hypot(tip.x - x, tip.y - y);
}

double KdlAdapter::ProfilePosition(double distance, double time) {
  KDL::VelocityProfile_Trap profile(maxVelocity, maxAcceleration);
  profile.SetProfile(0, distance);
  return profile.Pos(time);
}
