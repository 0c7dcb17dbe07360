"""Sequences of calls: the infrared sensor that is enabled and disabled, in each language."""

import re
import shutil
import xml.etree.ElementTree as ElementTree

import pytest

COMPONENTS = {
    "java": "ir-sensor-states",
    "cpp": "ir-sensor-cpp",
    "python": "ir-sensor-python",
}


def activity_in(sitaf, language, folder):
    """The activity of sequences with the component of a language."""
    examples = sitaf.root / "examples"
    activity = shutil.copytree(examples / COMPONENTS[language], folder)
    shutil.copy(examples / "ir-sensor-states" / "LifeCycle.xml", activity)
    profile = (activity / "activity.yaml").read_text()
    profile = re.sub(r"(?m)^models: .*$", "models: [LifeCycle.xml]", profile)
    profile = re.sub(r"(?m)^  before: .*\n", "", profile)
    (activity / "activity.yaml").write_text(profile)
    return activity


def cases_of(result):
    return ElementTree.parse(result / "LifeCycle.xml").findall(
        "test_result_list/test_result"
    )


@pytest.mark.parametrize("language", COMPONENTS)
def test_sequences_pass_in_each_language(sitaf, language, tmp_path):
    activity = activity_in(sitaf, language, tmp_path / "activity")
    run = sitaf("run", activity, "--result", tmp_path / "result")
    assert run.returncode == 0, run.stdout + run.stderr
    cases = cases_of(tmp_path / "result")
    steps = [step for case in cases for step in case.findall("step")]
    assert {step.get("name") for step in steps} == {
        "Enable",
        "Disable",
        "Read",
        "ObstacleNears",
        "DropsOut",
    }
    assert {step.get("verdict") for step in steps} == {"PASS"}
    # Sequences change what a reading gives.
    readings = {step.findtext("actual") for step in steps if step.get("name") == "Read"}
    assert readings == {"-1.0", "0.5", "5.0"}


def test_a_reading_that_is_kept_fails_at_its_step(sitaf, tmp_path):
    run = sitaf(
        "run", "examples/ir-sensor-states-faulty", "--result", tmp_path / "result"
    )
    assert run.returncode == 1, run.stdout + run.stderr
    assert re.search(r"FAIL in \d+ cases?: step \d+ \(Read\): expected", run.stdout), (
        run.stdout
    )
    cases = cases_of(tmp_path / "result")
    failed = [case for case in cases if case.get("verdict") == "FAIL"]
    assert failed
    for case in failed:
        steps = case.findall("step")
        first = next(i for i, step in enumerate(steps) if step.get("verdict") != "PASS")
        # An earlier reading of the same case has set what is kept.
        assert "Read" in [step.get("name") for step in steps[:first]]
        assert all(step.get("after_failure") == "true" for step in steps[first + 1 :])
        assert case.findtext("message").startswith(f"step {first + 1} (Read): ")
    assert any(case.get("verdict") == "PASS" for case in cases)
