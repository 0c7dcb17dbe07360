"""The other examples: each passes, and its faulty variant fails as described in its README."""

import json
import re
import shutil
import xml.etree.ElementTree as ElementTree

import pytest
from needs import cpp

SUMMARY = re.compile(
    r"(\w+): (\d+) cases, (\d+) PASS(?:, (\d+) FAIL, (\d+) ERROR, (\d+) DONT)?"
)


def verdicts(run):
    """The number of cases and of passed cases of the only model."""
    found = SUMMARY.search(run.stdout)
    assert found, run.stdout + run.stderr
    return int(found[2]), int(found[3])


@pytest.mark.parametrize(
    "example",
    [
        "touchless-approach",
        "wall-distance",
        "sensor-dropout",
        pytest.param("joint-settling-cpp", marks=cpp),
        "heading",
        # test_languages.py and test_compare.py run the first three, too; the others have a twin or an equal in C++ here.
        *(
            pytest.param(name, marks=pytest.mark.long)
            for name in ("navigation-step", "joint-pid", "wall-approach", "joint-settling", "path-tracking")
        ),
    ],
)
def test_an_example_passes(sitaf, example):
    run = sitaf("run", f"examples/{example}")
    assert run.returncode == 0, run.stdout + run.stderr
    cases, passed = verdicts(run)
    assert cases == passed >= 4


def test_the_stub_records_the_wheel_commands(sitaf):
    run = sitaf("run", "examples/navigation-step-faulty")
    assert run.returncode == 1, run.stdout + run.stderr
    assert (
        'post-condition violated: actual == "HALT" || calls["WheelController.Drive"][0].speed'
        in run.stdout
    )
    assert (
        'post-condition violated: calls["RangeFinder.GetRange"].size() == 2'
        in run.stdout
    )
    assert "0 ERROR" in run.stdout


def test_a_base_that_does_not_stop_fails_after_the_call(sitaf):
    run = sitaf("run", "examples/wall-approach-faulty")
    assert run.returncode == 1, run.stdout + run.stderr
    _, passed = verdicts(run)
    assert passed == 0
    assert "robot_x: expected" in run.stdout
    assert "return: expected" not in run.stdout


def test_a_controller_without_integral_misses_the_target(sitaf):
    run = sitaf("run", "examples/joint-pid-faulty")
    assert run.returncode == 1, run.stdout + run.stderr
    cases, passed = verdicts(run)
    assert passed < cases
    assert "angle_held: expected" in run.stdout


def test_a_base_that_touches_the_wall_violates_a_condition_over_time(sitaf, tmp_path):
    run = sitaf(
        "run", "examples/touchless-approach-faulty", "--signals", tmp_path / "signals"
    )
    assert run.returncode == 1, run.stdout + run.stderr
    cases, passed = verdicts(run)
    assert passed == 0
    broken = re.search(r"never touches: broken at ([0-9.]+) s: bumped is 1", run.stdout)
    assert broken, run.stdout
    lines = (tmp_path / "signals" / "1.csv").read_text().splitlines()
    names = lines[0].split(",")
    assert names[0] == "t"
    touched = [
        row.split(",")[0]
        for row in lines[1:]
        if row.split(",")[names.index("bumped")] == "1"
    ]
    assert touched[0] == broken[1]
    assert len(list((tmp_path / "signals").iterdir())) == cases


def test_a_base_that_comes_too_near_violates_a_condition_over_rays(sitaf, tmp_path):
    run = sitaf(
        "run", "examples/wall-distance-faulty", "--signals", tmp_path / "signals"
    )
    assert run.returncode == 1, run.stdout + run.stderr
    assert "keeps the distance: broken at" in run.stdout
    assert re.search(r"lidar\.ranges\[90\] is 0\.[0-9]+", run.stdout), run.stdout
    assert "expected" not in run.stdout
    _, passed = verdicts(run)
    assert passed == 0
    names = (tmp_path / "signals" / "1.csv").read_text().splitlines()[0].split(",")
    # All rays, because a condition looks at the smallest.
    rays = [name for name in names if name.startswith("lidar.ranges[")]
    assert rays == [f"lidar.ranges[{ray}]" for ray in range(181)]
    # The component reports in its data port that it went too far.
    assert re.search(r"never goes too far: broken at [0-9.]+ s: remaining is -0\.0[0-9]+", run.stdout), run.stdout
    assert "remaining" in names
    assert "arrives" not in run.stdout


def test_a_ray_that_does_not_exist_is_an_error_of_the_model(sitaf, tmp_path):
    activity = shutil.copytree(
        sitaf.root / "examples" / "wall-distance", tmp_path / "activity"
    )
    model = activity / "Approach.xml"
    model.write_text(model.read_text().replace("lidar.ranges[90]", "lidar.ranges[181]"))
    run = sitaf("run", activity)
    assert run.returncode == 2, run.stdout + run.stderr
    assert "lidar.ranges[181] does not exist" in run.stdout + run.stderr
    assert "Approach.xml:37" in run.stdout + run.stderr


def test_a_base_that_drives_without_readings_violates_a_condition(sitaf):
    run = sitaf("run", "examples/sensor-dropout-faulty")
    assert run.returncode == 1, run.stdout + run.stderr
    assert "stops without readings: broken at 0.4 s: base.linear.command is 0.4" in run.stdout
    assert "fault.lidar.dropout" in run.stdout
    _, passed = verdicts(run)
    # Without a fault, the base is right.
    assert passed > 0


def test_a_slow_controller_does_not_settle_in_time(sitaf):
    run = sitaf("run", "examples/joint-settling-faulty")
    assert run.returncode == 1, run.stdout + run.stderr
    assert re.search(r"settles: broken at [0-9.]+ s: angle_held is", run.stdout)
    assert "angle_held: expected" not in run.stdout


@pytest.mark.parametrize(
    ("example", "change", "condition"),
    [
        pytest.param("joint-settling-cpp-faulty", None, "does not swing beyond the target", marks=cpp),
        pytest.param("joint-settling-cpp", ("dt = 0.01", "dt = 0.005"), "settles", marks=cpp),
        ("path-tracking-faulty", None, "comes to the line"),
    ],
)
def test_a_fault_that_no_final_value_shows_violates_a_condition(
    sitaf, tmp_path, example, change, condition
):
    activity = shutil.copytree(sitaf.root / "examples" / example, tmp_path / "activity")
    if change:
        source = activity / "component" / "controller.cpp"
        assert change[0] in source.read_text()
        source.write_text(source.read_text().replace(*change))
    run = sitaf("run", activity)
    assert run.returncode == 1, run.stdout + run.stderr
    assert f"{condition}: broken at" in run.stdout
    _, passed = verdicts(run)
    assert passed > 0


def test_a_wrist_reaches_whole_rotations(sitaf):
    run = sitaf("run", "examples/wrist-kinematics")
    assert run.returncode == 0, run.stdout + run.stderr
    assert "Reach: 60 cases, 60 PASS" in run.stdout
    assert "AngleBetween: 100 cases, 100 PASS" in run.stdout
    assert "100 of 192 tuples are covered; most are lost by first and second" in run.stderr


def test_a_wrist_that_fails_at_quarter_turns_is_noticed(sitaf):
    run = sitaf("run", "examples/wrist-kinematics-faulty")
    assert run.returncode == 1, run.stdout + run.stderr
    assert "math domain error" in run.stdout
    for model in ("Reach", "AngleBetween"):
        found = re.search(rf"{model}: (\d+) cases, (\d+) PASS", run.stdout)
        assert found and int(found[2]) < int(found[1]), run.stdout


def test_the_outputs_of_a_reference_are_the_expected_values(sitaf, tmp_path):
    run = sitaf("run", "examples/median-filter")
    assert run.returncode == 0, run.stdout + run.stderr
    assert verdicts(run) == (11, 11)
    faulty = shutil.copytree(sitaf.root / "examples" / "median-filter-faulty", tmp_path / "activity")
    run = sitaf("run", faulty)
    assert run.returncode == 1, run.stdout + run.stderr
    assert "Median: 11 cases, 8 PASS, 3 FAIL, 0 ERROR" in run.stdout
    reference = faulty / "reference" / "median_filter.py"
    crash = "if readings == [2.5]:\n            __import__('os')._exit(9)\n        if not readings:"
    reference.write_text(reference.read_text().replace("if not readings:", crash))
    run = sitaf("run", faulty)
    assert "the expected value could not be evaluated: the reference failed" in run.stdout, run.stdout + run.stderr
    reference.write_text("syntax error")
    run = sitaf("run", faulty)
    assert run.returncode == 2
    assert "reference: " in run.stderr, run.stderr


def test_relations_compare_two_runs_of_each_case(sitaf, tmp_path):
    result = tmp_path / "result.xml"
    run = sitaf("run", "examples/angle-normalisation", "--model", "Normalise", "--result", result)
    assert run.returncode == 0, run.stdout + run.stderr
    assert "Normalise: 25 cases, 25 PASS" in run.stdout
    assert "relation 'a whole turn changes nothing': 25 checked, 0 broken, 0 skipped, 0 errors" in run.stdout
    assert result.read_text().count('<relation name="the opposite angle has the opposite result" verdict="PASS">') == 25


def test_a_fault_that_only_a_relation_shows(sitaf):
    run = sitaf("run", "examples/angle-normalisation-faulty")
    assert run.returncode == 1, run.stdout + run.stderr
    cases, passed = verdicts(run)
    assert cases == 25 and 0 < passed < cases
    assert f"relation 'a whole turn changes nothing': 25 checked, {cases - passed} broken" in run.stdout
    assert "relation 'the opposite angle has the opposite result': 25 checked, 0 broken" in run.stdout
    assert re.search(r"first run: angle=\S+ gave \S+; second run: angle=\S+ gave ", run.stdout)
    assert "post-condition violated" not in run.stdout


def test_repeated_calls_tell_a_slower_component_with_the_same_outputs(sitaf, tmp_path):
    medians = {}
    for example in ("median-filter", "median-filter-slower"):
        result = tmp_path / f"{example}.xml"
        run = sitaf("run", f"examples/{example}", "--model", "Median", "--result", result, "--table")
        assert run.returncode == 0, run.stdout + run.stderr
        assert verdicts(run) == (11, 11)
        assert "not included: the first call of the process" in run.stdout
        assert "median of 20 calls after the first and 3 more to warm up" in run.stdout
        repeated = ElementTree.parse(result).findall(".//repeated_calls")
        assert [calls.get("calls") for calls in repeated] == ["20"] * 11
        assert all(float(calls.get("low")) <= float(calls.get("median")) for calls in repeated)
        medians[example] = [float(calls.get("median")) for calls in repeated]
    # Case 4 has three readings, which one of them sorts.
    assert medians["median-filter-slower"][3] > medians["median-filter"][3]


def test_a_turn_in_one_direction_only_breaks_a_named_post_condition(sitaf):
    run = sitaf("run", "examples/heading-faulty")
    assert run.returncode == 1, run.stdout + run.stderr
    cases, passed = verdicts(run)
    assert 0 < passed < cases
    assert re.search(r"post-condition violated: turns at most half way: .*\d <= 3\.14159", run.stdout)
    assert "arrives at the heading" not in run.stdout
    assert re.search(r", \d+ by an error", run.stdout)
    assert "0 ERROR" in run.stdout


def test_falsify_finds_a_violation_that_the_suite_does_not_show(sitaf, tmp_path):
    faulty = shutil.copytree(sitaf.root / "examples" / "joint-scheduling-faulty", tmp_path / "activity")
    run = sitaf("run", faulty)
    assert "45 cases, 45 PASS" in run.stdout, run.stdout + run.stderr
    found = tmp_path / "found.json"
    run = sitaf("falsify", faulty, "--json", found, "--keep")
    assert run.returncode == 1, run.stdout + run.stderr
    result = json.loads(found.read_text())
    assert result["condition"] == "settles"
    assert result["margin"] < 0
    assert 25 < result["executions"] <= 200
    assert 0.3 < result["inputs"]["angle"] < 0.8
    again = sitaf("run", faulty)
    assert again.returncode == 1, again.stdout + again.stderr
    assert "settles: broken at" in again.stdout
    unknown = sitaf("falsify", faulty, "--condition", "holds")
    assert unknown.returncode == 2
    assert "the models have Settle: [settles]" in unknown.stderr
