"""Sequences of calls: the infrared sensor that is enabled and disabled, in each language."""

import json
import re
import shutil
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest
from needs import cpp

PARTS = Path(__file__).parent / "languages"
# The second check gets the second answer of the first one; each first check begins to count again.
COUNTING = """\
<test_model>
  <name>Counting</name>
  <target interface="CollisionGuardService"/>
  <input_spec_list/>
  <sequence_spec length="5" order="3">
    <state name="checks" type="int" initial="-1"/>
    <call name="Arm"><guard>checks &lt; 0</guard><update state="checks">0</update></call>
    <call name="First" method="Check">
      <guard>checks &gt;= 0</guard>
      <update state="checks">1</update>
      <input_spec_list>
        <test_element abstract_type="NUMERIC" real_type="double"><name>Battery.Level</name><type>TDTS</type>
          <user_value_list><value>0.9</value></user_value_list></test_element>
        <test_element abstract_type="NUMERIC" real_type="double"><name>Battery.Level#2</name><type>TDTS</type>
          <user_value_list><value>!error:NoContact</value></user_value_list></test_element>
      </input_spec_list>
      <output_spec_list><test_element abstract_type="STRING" real_type="string"><name>return</name>
        <type>RETURN</type><expected>'CLEAR'</expected></test_element></output_spec_list>
    </call>
    <call name="Second" method="Check">
      <guard>checks &gt; 0</guard>
      <update state="checks">2</update>
      <output_spec_list><test_element abstract_type="STRING" real_type="string"><name>return</name>
        <type>RETURN</type><expected>'LOW'</expected></test_element></output_spec_list>
    </call>
  </sequence_spec>
  <order_of_combinations>1</order_of_combinations>
</test_model>
"""
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


@pytest.mark.parametrize("language", ["java", pytest.param("cpp", marks=cpp), "python"])
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
    assert re.search(
        r"FAIL in \d+ cases?(; case \d+)?: step \d+ \(Read\): expected", run.stdout
    ), run.stdout
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


def test_an_exception_in_a_constructor_is_no_error_of_the_first_step(sitaf, tmp_path):
    activity = activity_in(sitaf, "python", tmp_path / "activity")
    source = activity / "component" / "infrared_sensor.py"
    source.write_text(
        source.read_text().replace(
            "        self._hardware = hardware\n",
            "        raise OSError('no such port')\n",
        )
    )
    run = sitaf("run", activity, "--result", tmp_path / "result")
    assert run.returncode == 1, run.stdout + run.stderr
    assert "before the first step: OSError: no such port" in run.stdout
    for case in cases_of(tmp_path / "result"):
        assert case.get("verdict") == "ERROR"
        assert {step.get("verdict") for step in case.findall("step")} == {"DONT"}


def guard_in(sitaf, language, folder):
    """The collision guard in a language."""
    activity = shutil.copytree(sitaf.root / "examples" / "collision-guard", folder)
    if language != "python":
        shutil.rmtree(activity / "component")
        shutil.copytree(PARTS / "guard" / language, activity / "component")
        name = {"java": "robot.CollisionGuard", "cpp": "robot::CollisionGuard"}[
            language
        ]
        profile = (activity / "activity.yaml").read_text()
        profile = profile.replace("language: python", f"language: {language}")
        profile = profile.replace("collision_guard.CollisionGuard", name)
        (activity / "activity.yaml").write_text(profile)
    return activity


@pytest.mark.parametrize("language", ["java", pytest.param("cpp", marks=cpp), "python"])
def test_each_call_sets_the_world_and_the_answers_of_stubs(sitaf, language, tmp_path):
    activity = guard_in(sitaf, language, tmp_path / "activity")
    (activity / "Counting.xml").write_text(COUNTING)
    profile = activity / "activity.yaml"
    profile.write_text(
        profile.read_text().replace("[Watching.xml]", "[Watching.xml, Counting.xml]")
    )
    run = sitaf("run", activity, "--result", tmp_path / "result")
    assert run.returncode == 0, run.stdout + run.stderr
    assert "Counting: " in run.stdout
    cases = ElementTree.parse(tmp_path / "result" / "Watching.xml").findall(
        "test_result_list/test_result"
    )
    checks = {
        (*(value.text for value in step.findall("value")), step.findtext("actual"))
        for case in cases
        for step in case.findall("step")
        if step.get("name") == "Check"
    }
    assert {(float(distance), *rest) for distance, *rest in checks} >= {
        (2.0, "0.9", "CLEAR"),
        (2.0, "0.1", "LOW"),
        (2.0, "!error:NoContact", "LOW"),
        (0.3, "0.9", "STOP"),
    }
    # A call with a distance of its own and one without: the guard remembers the stop.
    stopped = [
        step
        for case in cases
        for step in case.findall("step")
        if step.get("name") == "CheckStopped"
    ]
    assert {step.findtext("actual") for step in stopped} == {"STOP"}
    assert {float(step.findtext("value")) for step in stopped} == {0.3, 2.0}


def test_a_stop_that_a_battery_hides_fails_at_its_step(sitaf):
    run = sitaf("run", "examples/collision-guard-faulty")
    assert run.returncode == 1, run.stdout + run.stderr
    assert re.search(
        r"step \d+ \(CheckStopped\): expected 'STOP', but was 'LOW'", run.stdout
    ), run.stdout
    assert re.search(
        r"(?m)^ +> +\d+ +FAIL +CheckStopped\(.*NoContact.*\)", run.stdout
    ), run.stdout
    assert ", 0 ERROR," in run.stdout


def test_a_parameter_that_the_world_does_not_have_is_refused_at_its_call(
    sitaf, tmp_path
):
    activity = guard_in(sitaf, "python", tmp_path / "activity")
    model = activity / "Watching.xml"
    model.write_text(model.read_text().replace("<name>Distance<", "<name>Distanse<"))
    run = sitaf("run", activity)
    assert run.returncode == 2, run.stdout + run.stderr
    assert re.search(r"Watching\.xml:\d+: .*Distanse.*no such parameter", run.stderr)


def test_an_object_that_is_taken_away_is_noticed(sitaf):
    run = sitaf("run", "examples/gripper")
    assert run.returncode == 0, run.stdout + run.stderr


def test_a_gripper_that_remembers_its_object_fails_at_the_second_look(sitaf, tmp_path):
    run = sitaf("run", "examples/gripper-faulty", "--result", tmp_path / "result")
    assert run.returncode == 1, run.stdout + run.stderr
    assert re.search(r"step \d+ \(Look\): expected false, but was true", run.stdout)
    assert re.search(r"(?m)^ +> +\d+ +FAIL +Look\(\)", run.stdout), run.stdout
    cases = ElementTree.parse(tmp_path / "result" / "Handling.xml").findall(
        "test_result_list/test_result"
    )
    failed = [case for case in cases if case.get("verdict") == "FAIL"]
    assert failed
    for case in failed:
        steps = case.findall("step")
        first = next(i for i, step in enumerate(steps) if step.get("verdict") != "PASS")
        names = [step.get("name") for step in steps[:first]]
        # It was held, looked at, and taken away.
        looked = names.index("Look")
        assert "Grasp" in names[: names.index("TakenAway")]
        assert looked < len(names) - 1 - names[::-1].index("TakenAway")
        assert steps[first].get("before") == "closed=true, present=false"
    assert any(case.get("verdict") == "PASS" for case in cases)


def test_a_navigation_server_passes_with_preempted_goals(sitaf):
    run = sitaf("run", "examples/navigation-goals")
    assert run.returncode == 0, run.stdout + run.stderr


def test_a_preempted_goal_that_is_resumed_fails_after_the_cancel(sitaf):
    run = sitaf("run", "examples/navigation-goals-faulty")
    assert run.returncode == 1, run.stdout + run.stderr
    assert re.search(
        r"step \d+ \(StayIdle\): expected 'IDLE', but was 'REACHED'", run.stdout
    )
    assert re.search(
        r"step \d+ \(Cancel, forbidden\): expected the error NoGoal, but it returned",
        run.stdout,
    )
    assert ", 0 ERROR," in run.stdout
    # Where calls overlap, the goal that is canceled is that of the second call.
    assert re.search(r"step \d+ \(Cancel\): navigation_server.NoGoal", run.stdout), (
        run.stdout
    )


def test_a_release_of_a_package_that_resumes_wrongly_fails_at_its_step(sitaf):
    run = sitaf("run", "examples/py-trees")
    assert run.returncode == 0, run.stdout + run.stderr
    run = sitaf("run", "examples/py-trees-2.1.1")
    assert run.returncode == 1, run.stdout + run.stderr
    assert re.search(
        r"step \d+ \(Resume\): visited: expected 1, but was 2", run.stdout
    ), run.stdout
    assert ", 0 ERROR," in run.stdout


def test_known_faults_in_the_state_of_packages_are_found(sitaf):
    run = sitaf("bench", "states", "--short")
    assert run.returncode == 0, run.stdout + run.stderr
    assert "every fault found, and its step named" in run.stdout
    assert "RemoveOnce" in run.stdout


def test_compare_names_the_first_step_that_differs(sitaf, tmp_path):
    report = tmp_path / "compared.json"
    run = sitaf(
        "compare",
        "examples/gripper",
        "examples/gripper-faulty",
        "--json",
        report,
    )
    assert run.returncode == 1, run.stdout + run.stderr
    assert re.search(r"first step \d+, Look\(\)", run.stdout), run.stdout
    found = json.loads(report.read_text())["differences"]
    assert found
    for difference in found:
        assert difference["output"] == "Look.return"
        assert difference["call"] == "Look()"
        assert (difference["base"], difference["new"]) == ("false", "true")


def test_explain_shortens_a_failure_to_its_steps(sitaf, tmp_path):
    report = tmp_path / "causes.json"
    run = sitaf("explain", "examples/gripper-faulty", "--json", report)
    assert run.returncode == 0, run.stdout + run.stderr
    assert "fails at the end of: Grasp(), Look(), TakenAway(), Look()" in run.stdout, (
        run.stdout
    )
    (cause,) = json.loads(report.read_text())["causes"]
    assert cause["steps"] == ["Grasp()", "Look()", "TakenAway()", "Look()"]
