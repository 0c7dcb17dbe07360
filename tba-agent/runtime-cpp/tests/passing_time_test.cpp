#include "simulation/passing_time.hpp"

#include <doctest/doctest.h>

#include <chrono>
#include <cstdint>
#include <future>
#include <memory>
#include <thread>
#include <vector>

#include "sitaf/simulation/simulation_error.hpp"

using sitaf::simulation::CaseTooLong;
using sitaf::simulation::PassingTime;
using sitaf::simulation::SimulationError;
using std::chrono::milliseconds;
using Moments = std::vector<std::uint64_t>;

namespace {

/// A simulation that only counts its steps of 2 ms.
struct World {
  std::uint64_t now = 0;
  PassingTime time{milliseconds(2), [this](std::uint64_t steps) { now += steps; }};

  /// Acts and waits 6 ms, repeatedly.
  void act(Moments& acted, int times) {
    for (int i = 0; i < times; ++i) {
      acted.push_back(now);
      time.pass(milliseconds(6));
    }
  }

  /// A thread that is followed from its start.
  template <class Work>
  std::thread follow(Work work) {
    auto begin = std::make_shared<std::promise<void>>();
    std::thread thread([this, work, begun = begin->get_future().share()] {
      begun.wait();
      work();
      time.leave();
    });
    time.follow(thread.get_id());
    begin->set_value();
    return thread;
  }
};

}  // namespace

TEST_CASE("ticks run at the first step at or after each period") {
  World world;
  Moments ticks;
  world.time.every(milliseconds(5), [&] { ticks.push_back(world.now); });
  world.time.pass(milliseconds(13));
  world.time.pass(milliseconds(6));
  CHECK(ticks == Moments{3, 5, 8, 10});
}

TEST_CASE("a followed thread acts at the same times in every run, and time passes until it leaves") {
  World world;
  Moments acted;
  std::thread component = world.follow([&] { world.act(acted, 5); });
  world.time.pass(milliseconds(20));
  CHECK(acted == Moments{0, 3, 6, 9});
  const std::thread::id id = component.get_id();
  world.time.passUntilLeaves(id);
  component.join();
  CHECK(acted == Moments{0, 3, 6, 9, 12});
  CHECK(world.now == 15);
  world.time.passUntilLeaves(id);
  CHECK(world.now == 15);
}

TEST_CASE("giving up a thread ends its waits") {
  World world;
  world.time.limit(milliseconds(20));
  Moments acted;
  bool reported = false;
  std::thread component = world.follow([&] {
    try {
      world.act(acted, 1000000);
    } catch (const SimulationError&) {
      reported = true;
    }
  });
  CHECK_THROWS_WITH_AS(world.time.passUntilLeaves(component.get_id()), "the case took more than 0.02 s of simulation time", CaseTooLong);
  world.time.giveUp(component.get_id());
  component.join();
  CHECK(reported);
  CHECK(acted == Moments{0, 3, 6, 9});
}

TEST_CASE("followed threads continue in the order of their beginning") {
  World world;
  std::vector<std::pair<int, std::uint64_t>> acted;
  std::vector<std::thread> components;
  for (int number = 1; number <= 3; ++number) {
    components.push_back(world.follow([&world, &acted, number] {
      for (int i = 0; i < 3; ++i) {
        world.time.pass(milliseconds(6));
        // The others would act meanwhile if they ran at the same time.
        std::this_thread::yield();
        acted.emplace_back(number, world.now);
      }
    }));
    world.time.awaitTurnOf(components.back().get_id());
  }
  for (std::thread& component : components) {
    world.time.passUntilLeaves(component.get_id());
    component.join();
  }
  CHECK(acted == std::vector<std::pair<int, std::uint64_t>>{{1, 3}, {2, 3}, {3, 3}, {1, 6}, {2, 6}, {3, 6}, {1, 9}, {2, 9}, {3, 9}});
}

TEST_CASE("a followed thread waits until another leaves") {
  World world;
  Moments acted;
  std::thread inner;
  std::thread outer = world.follow([&] {
    inner = world.follow([&] { world.act(acted, 2); });
    world.time.awaitTurnOf(inner.get_id());
    world.time.passUntilLeaves(inner.get_id());
    acted.push_back(100 + world.now);
  });
  world.time.passUntilLeaves(outer.get_id());
  outer.join();
  inner.join();
  CHECK(acted == Moments{0, 3, 106});
}

TEST_CASE("the settle time counts towards the limit of a case") {
  World world;
  world.time.limit(milliseconds(20));
  world.time.restart(milliseconds(12));
  world.time.pass(milliseconds(8));
  CHECK_THROWS_AS(world.time.pass(milliseconds(2)), CaseTooLong);
}
