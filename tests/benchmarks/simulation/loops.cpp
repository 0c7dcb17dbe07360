// A controller of all joints at 250 Hz. Prints microseconds per tick, best of five. Arguments: target, world, joints.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "sitaf/hardware.hpp"
#include "sitaf/runtime/stopwatch.hpp"
#include "sitaf/simulation/simulation.hpp"

int main(int, char** arguments) {
  using namespace std::chrono_literals;
  sitaf::runtime::Stopwatch stopwatch;
  sitaf::simulation::Simulation simulation(arguments[1], arguments[2], 1, stopwatch);
  std::vector<sitaf::JointMotor*> motors;
  std::vector<sitaf::JointEncoder*> encoders;
  for (int i = 1; i <= std::atoi(arguments[3]); ++i) {
    motors.push_back(&simulation.hardware().jointMotor("motor" + std::to_string(i)));
    encoders.push_back(&simulation.hardware().jointEncoder("encoder" + std::to_string(i)));
  }
  double best = INFINITY;
  for (int round = 0; round < 5; ++round) {
    simulation.prepare({}, {}, 0ns);
    simulation.every(4ms, [&] {
      for (std::size_t i = 0; i < motors.size(); ++i) {
        motors[i]->setEffort(8 * (0.5 - encoders[i]->position()) - encoders[i]->velocity());
      }
    });
    const auto began = std::chrono::steady_clock::now();
    simulation.advance(2s);
    best = std::min(best, std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - began).count() / 500);
    if (std::abs(encoders[0]->position() - 0.5) > 0.1) {
      std::fprintf(stderr, "not controlled: %g\n", encoders[0]->position());
      return 1;
    }
  }
  std::printf("%g\n", best);
}
