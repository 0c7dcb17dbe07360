"""Calls that overlap the next steps: a second goal during the first, in each language."""

import re
import shutil
import xml.etree.ElementTree as ElementTree

import pytest
from needs import cpp

JAVA = """\
package nav;

import java.time.Duration;
import org.sitaf.runtime.Hardware;
import org.sitaf.runtime.actuator.JointMotor;

public class Server {
  private final Hardware hardware;
  private final JointMotor base;
  private boolean active;
  private int number;

  public Server(Hardware hardware) {
    this.hardware = hardware;
    this.base = hardware.jointMotor("base");
  }

  public void SendGoal(double x) {}

  public String Navigate(double distance) {
    double goal = base.position() + distance;
    int mine = ++number;
    active = true;
    base.position(goal);
    while (number == mine) {
      if (Math.abs(base.position() - goal) <= 0.02) {
        active = false;
        return "REACHED";
      }
      hardware.sleep(Duration.ofMillis(20));
    }
    return "PREEMPTED";
  }

  public void Cancel() {
    if (!active) {
      throw new NoGoal();
    }
    number++;
    active = false;
    base.position(base.position());
  }

  public String Status() {
    return active ? "ACTIVE" : "IDLE";
  }

  public double Position() {
    return base.position();
  }

  /** There is no goal to cancel. */
  public static class NoGoal extends RuntimeException {}
}
"""

CPP = """\
#pragma once

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>

#include "sitaf/hardware.hpp"

namespace nav {

struct NoGoal : std::runtime_error {
  NoGoal() : std::runtime_error("send a goal first") {}
};

class Server {
 public:
  explicit Server(sitaf::Hardware& hardware) : hardware_(hardware), base_(hardware.jointMotor("base")) {}

  void SendGoal(double) {}

  std::string Navigate(double distance) {
    const double goal = base_.position() + distance;
    const int mine = ++number_;
    active_ = true;
    base_.setPosition(goal);
    while (number_ == mine) {
      if (std::abs(base_.position() - goal) <= 0.02) {
        active_ = false;
        return "REACHED";
      }
      hardware_.sleep(std::chrono::milliseconds(20));
    }
    return "PREEMPTED";
  }

  void Cancel() {
    if (!active_) {
      throw NoGoal();
    }
    ++number_;
    active_ = false;
    base_.setPosition(base_.position());
  }

  std::string Status() { return active_ ? "ACTIVE" : "IDLE"; }
  double Position() { return base_.position(); }

 private:
  sitaf::Hardware& hardware_;
  sitaf::JointMotor& base_;
  bool active_ = false;
  int number_ = 0;
};

}  // namespace nav
"""

COUNTER = """\
#pragma once

namespace count {{

class Counter {{
 public:
  void Add() {{
    for (int i = 0; i < 20000; ++i) {{
      {body}
    }}
  }}

 private:
  {member}
}};

}}  // namespace count
"""

COUNTER_MODEL = """\
<test_model>
  <name>Counting</name>
  <target interface="Counter"/>
  <input_spec_list/>
  <sequence_spec length="4" order="2" threads="2">
    <call name="Add"/>
    <call name="More" method="Add"/>
  </sequence_spec>
  <order_of_combinations>1</order_of_combinations>
</test_model>
"""


def activity_in(sitaf, language, folder):
    """The navigation server with calls that overlap, in a language."""
    activity = shutil.copytree(sitaf.root / "examples" / "navigation-goals", folder)
    profile = (activity / "activity.yaml").read_text()
    profile = profile.replace("[Goals.xml, Driving.xml]", "[Driving.xml]")
    sources = {"java": ("nav/Server.java", JAVA), "cpp": ("server.hpp", CPP)}
    if language in sources:
        path, text = sources[language]
        shutil.rmtree(activity / "component")
        (activity / "component" / path).parent.mkdir(parents=True)
        (activity / "component" / path).write_text(text)
        name = {"java": "nav.Server", "cpp": "nav::Server"}[language]
        profile = profile.replace("language: python", f"language: {language}")
        profile = profile.replace("navigation_server.NavigationServer", name)
    (activity / "activity.yaml").write_text(profile)
    return activity


def steps_of(result):
    """What each step gave, without processing times."""
    return [
        [
            (
                step.get("name"),
                step.get("verdict"),
                step.get("at"),
                step.findtext("actual"),
            )
            for step in case.findall("step")
        ]
        for case in ElementTree.parse(result / "Driving.xml").findall(
            "test_result_list/test_result"
        )
    ]


@pytest.mark.parametrize("language", ["java", pytest.param("cpp", marks=cpp), "python"])
def test_a_second_goal_preempts_the_first_one_in_each_run(sitaf, language, tmp_path):
    activity = activity_in(sitaf, language, tmp_path / "activity")
    run = sitaf("run", activity, "--result", tmp_path / "result")
    assert run.returncode == 0, run.stdout + run.stderr
    again = sitaf("run", activity, "--result", tmp_path / "again")
    assert again.returncode == 0, again.stdout + again.stderr
    cases = steps_of(tmp_path / "result")
    assert cases == steps_of(tmp_path / "again")
    returned = {
        actual for case in cases for name, _, _, actual in case if name == "Navigate"
    }
    assert returned == {"REACHED", "PREEMPTED"}
    # The next step begins at the same simulation time.
    pairs = [pair for case in cases for pair in zip(case, case[1:], strict=False)]
    assert any(first[0] == "Navigate" and first[2] == then[2] for first, then in pairs)


@pytest.mark.long
@pytest.mark.parametrize("language", ["java", pytest.param("cpp", marks=cpp), "python"])
def test_overlapping_calls_give_the_same_in_each_run(sitaf, language, tmp_path):
    activity = activity_in(sitaf, language, tmp_path / "activity")
    runs = []
    for number in range(6):
        run = sitaf("run", activity, "--result", tmp_path / f"result{number}")
        assert run.returncode == 0, run.stdout + run.stderr
        runs.append(steps_of(tmp_path / f"result{number}"))
    assert all(run == runs[0] for run in runs)


def counter_in(folder, body, member):
    """An activity without a simulation: two threads call the same counter."""
    (folder / "component").mkdir(parents=True)
    (folder / "component" / "counter.hpp").write_text(
        COUNTER.format(body=body, member=member)
    )
    (folder / "Counter.idl").write_text("interface Counter {\n  void Add();\n};\n")
    (folder / "Counting.xml").write_text(COUNTER_MODEL)
    (folder / "activity.yaml").write_text(
        "name: counter\n"
        "component:\n"
        "  language: cpp\n"
        "  sources: component/\n"
        "  class: count::Counter\n"
        "provided: [Counter.idl]\n"
        "models: [Counting.xml]\n"
        "sanitize: [thread]\n"
        "limits: {case_wall_s: 30}\n"
    )
    return folder


@cpp
def test_a_data_race_is_found_with_its_line(sitaf, tmp_path):
    run = sitaf(
        "run", counter_in(tmp_path / "activity", "++total_;", "int total_ = 0;")
    )
    assert run.returncode == 1, run.stdout + run.stderr
    assert re.search(
        r"ERROR in \d+ cases?: step \d+ \(\w+\): data race at counter.hpp:[89]",
        run.stdout,
    ), run.stdout


@cpp
def test_a_component_that_locks_has_no_data_race(sitaf, tmp_path):
    activity = counter_in(
        tmp_path / "activity",
        "const std::lock_guard<std::mutex> lock(mutex_); ++total_;",
        "int total_ = 0; std::mutex mutex_;",
    )
    header = activity / "component" / "counter.hpp"
    header.write_text(
        header.read_text().replace(
            "#pragma once\n", "#pragma once\n\n#include <mutex>\n"
        )
    )
    run = sitaf("run", activity)
    assert run.returncode == 0, run.stdout + run.stderr
