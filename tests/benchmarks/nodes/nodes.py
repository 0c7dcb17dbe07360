"""A ROS 2 node in C++ with a timer of 100 Hz and a scan of 360 beams: simulated seconds per second.

Two cases of different length are run; the difference of their times is that of the simulation, without the build.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(os.environ["SITAF_HOME"])
EXAMPLE = ROOT / "examples" / "wall-stop-ros-cpp"
SHORT_S, LONG_S = 5, 45
FASTER = 20
MODEL = """<test_model><name>Drive</name><target interface="topics" method="start" settle="0.2" run_for="{seconds}"/>
<input_spec_list><test_element abstract_type="NUMERIC" real_type="double"><name>start.data</name><type>TDI</type>
<user_value_list><value>0.1</value></user_value_list></test_element></input_spec_list>
<output_spec_list><test_element abstract_type="NUMERIC" real_type="double"><name>command.count</name><type>OUT</type>
<expected>{messages}</expected></test_element></output_spec_list><order_of_combinations>1</order_of_combinations>
</test_model>
"""


def replaced(file, pattern, by):
    """Replace a part of a file that must be there."""
    text, count = re.subn(pattern, by, file.read_text())
    if count != 1:
        sys.exit(f"{file}: {pattern} is there {count} times")
    file.write_text(text)


def activity(folder):
    """The example with the node's work in a timer, and more beams."""
    shutil.copytree(EXAMPLE, folder)
    replaced(
        folder / "world" / "maze.world.yaml",
        r"rays: \d+, min: 0.05, max: 6, rate_hz: \d+",
        "rays: 360, min: 0.05, max: 6, rate_hz: 10",
    )
    source = folder / "src" / "wall_stop" / "src" / "wall_stop.cpp"
    replaced(
        source,
        r"std::bind\(&WallStop::on_scan, this, std::placeholders::_1\)\);",
        "[this](sensor_msgs::msg::LaserScan::ConstSharedPtr scan) {last_ = scan;});\n"
        "    timer_ = create_wall_timer(std::chrono::milliseconds(10), [this] {if (last_) {on_scan(last_);}});",
    )
    replaced(
        source,
        r"private:\n",
        "private:\n  rclcpp::TimerBase::SharedPtr timer_;\n  sensor_msgs::msg::LaserScan::ConstSharedPtr last_;\n",
    )
    replaced(folder / "activity.yaml", r"limits: .*", "limits: {case_wall_s: 100, case_sim_s: 100}")
    return folder


def seconds(folder, length):
    """The time of a run whose case has this simulated length, and that passes."""
    (folder / "Stop.xml").write_text(MODEL.format(seconds=length, messages=100 * length))
    began = time.monotonic()
    command = [ROOT / "sitaf", "run", folder, "--no-coverage"]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode:
        sys.exit(f"{run.stdout}{run.stderr}")
    return time.monotonic() - began


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--runs", type=int, default=3, help="runs of each length, of which the fastest counts")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        folder = activity(Path(temporary) / "activity")
        seconds(folder, SHORT_S)  # compiles the runtime
        best = {length: min(seconds(folder, length) for _ in range(arguments.runs)) for length in (SHORT_S, LONG_S)}
    took = best[LONG_S] - best[SHORT_S]
    faster = (LONG_S - SHORT_S) / took
    held = faster >= FASTER
    print(f"{LONG_S - SHORT_S} simulated seconds of a node at 100 Hz with a scan of 360 beams: {took:.2f} s")
    print(f"times faster than real time: {faster:.1f} (target: {FASTER}) {'held' if held else 'SHORT'}")
    return 0 if held else 1


if __name__ == "__main__":
    sys.exit(main())
