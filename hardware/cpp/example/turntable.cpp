// Provides a turntable to tests, as a motor and an encoder: usage: turntable ADDRESS
//
// The turntable of this example turns in real time in this process; replace the four lines that use it.
#include <mutex>

#include "sitaf/hardware.hpp"

namespace hw = sitaf::hardware;
using Clock = std::chrono::steady_clock;

class Turntable {
 public:
  double angle() {
    const std::lock_guard guard(lock_);
    move();
    return angle_;
  }

  void turn(double velocity) {
    const std::lock_guard guard(lock_);
    move();
    velocity_ = velocity;
  }

  double velocity() {
    const std::lock_guard guard(lock_);
    return velocity_;
  }

 private:
  void move() {
    const auto now = Clock::now();
    angle_ += velocity_ * std::chrono::duration<double>(now - at_).count();
    at_ = now;
  }

  std::mutex lock_;
  Clock::time_point at_ = Clock::now();
  double angle_ = 0;
  double velocity_ = 0;
};

class Motor : public hw::Device {
 public:
  explicit Motor(std::shared_ptr<Turntable> table) : table_(std::move(table)) {}

  [[nodiscard]] hw::Description describe() const override {
    return {"joint_motor",
            {{"position", "rad"}, {"velocity", "rad/s"}, {"effort", "N m"}},
            {{"velocity", "rad/s", -2, 2}},
            {}};
  }

  hw::Reading read() override { return {{table_->angle(), table_->velocity(), 0.0}}; }
  void command(const std::map<std::string, double>& numbers) override { table_->turn(numbers.at("velocity")); }
  void stop() override { table_->turn(0); }

 private:
  std::shared_ptr<Turntable> table_;
};

int main(int /*count*/, char** arguments) {
  hw::serve({{"motor", std::make_shared<Motor>(std::make_shared<Turntable>())}}, arguments[1], "turntable");
}
