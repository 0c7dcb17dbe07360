"""The same activity with its component in Java, C++ and Python: the same cases, the same verdicts, the same values."""

import re
import shutil
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest

from needs import cpp

PARTS = Path(__file__).parent / "languages"
LANGUAGES = ["java", pytest.param("cpp", marks=cpp), "python"]


@pytest.fixture(params=LANGUAGES[1:])
def language(request):
    return request.param


def from_example(sitaf, folder, example, language, class_name, part):
    """The activity of an example with another component."""
    shutil.copytree(sitaf.root / "examples" / example, folder)
    shutil.rmtree(folder / "component")
    shutil.copytree(PARTS / part / language, folder / "component")
    profile = folder / "activity.yaml"
    text = profile.read_text().replace("language: java", f"language: {language}")
    profile.write_text(re.sub(r"class: \S+", f"class: {class_name}", text))
    return folder


def arm(sitaf, folder, language):
    """An arm with nonblocking calls."""
    shutil.copytree(PARTS / "arm" / language, folder / "component")
    shutil.copytree(sitaf.root / "examples" / "joint-pid" / "world", folder / "world")
    for file in [*(PARTS / "arm").glob("*.xml"), *(PARTS / "arm" / "interfaces").iterdir(), PARTS / "arm" / "activity.yaml"]:
        shutil.copy(file, folder / file.name)
    profile = folder / "activity.yaml"
    names = {"java": "robot.Arm", "cpp": "robot::Arm", "python": "arm.Arm"}
    profile.write_text(profile.read_text().replace("LANGUAGE", language).replace("CLASS", names[language]))
    return folder


def results(sitaf, folder, *models):
    """The exit code, and the outcome of each case of one model or of all."""
    found = {}
    into = folder / (f"{models[0]}.result.xml" if len(models) == 1 else "results")
    run = sitaf("run", folder, *(["--model", *models] if len(models) == 1 else []), "--result", into)
    for model in models:
        file = into / f"{model}.xml" if into.is_dir() else into
        assert file.exists(), run.stdout + run.stderr
        for result in ElementTree.parse(file).getroot().iter("test_result"):
            found[model, int(result.attrib["no"])] = observed(result)
    return run.returncode, found


def observed(result):
    def outputs(element):
        return [(e.attrib.get("name", ""), e.text) for e in result.findall(element)]

    verdict = result.attrib["verdict"]
    calls = [(call.attrib["method"], [(a.attrib["name"], a.text) for a in call]) for call in result.findall("call")]
    # Exceptions are described differently in each language; other messages are equal.
    message = result.findtext("message") or ""
    same = verdict == "FAIL" or "simulation time" in message
    return {
        "verdict": verdict,
        "values": [value.text for value in result.findall("value")],
        "expected": outputs("expected"),
        "actual": [(name, rounded(text)) for name, text in outputs("actual")],
        "calls": calls,
        "message": rounded(message) if same else "",
    }


def rounded(text):
    """Round numbers, which may differ after the ninth decimal."""
    return re.sub(r"-?\d+\.\d+(?:[eE]-?\d+)?", lambda n: f"{float(n.group()):.9f}".replace("-0.000000000", "0.000000000"), text or "")


def verdicts(found):
    return [result["verdict"] for result in found.values()]


def replace(path, old, new):
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))


def only_some_drives(folder):
    """A condition on the stub's record that some cases violate."""
    replace(folder / "Step.xml", 'calls["RangeFinder.GetRange"].size() == 2', 'calls["WheelController.Drive"].size() == 1')
    return folder


@pytest.fixture(scope="module")
def navigation_in_java(sitaf, tmp_path_factory):
    """The results in Java, before and after the change of the condition."""
    folder = shutil.copytree(sitaf.root / "examples" / "navigation-step", tmp_path_factory.mktemp("navigation") / "java")
    return results(sitaf, folder, "Step"), results(sitaf, only_some_drives(folder), "Step")


def test_answers_sequences_errors_and_delays_of_stubs_are_the_same_in_every_language(sitaf, tmp_path, language, navigation_in_java):
    names = {"cpp": "robot::NavigationStep", "python": "navigation_step.NavigationStep"}
    other = from_example(sitaf, tmp_path / language, "navigation-step", language, names[language], "navigation")
    before, after = navigation_in_java
    assert before[0] == 0
    assert results(sitaf, other, "Step") == before
    assert after[0] == 1
    assert set(verdicts(after[1])) == {"PASS", "FAIL"}
    assert results(sitaf, only_some_drives(other), "Step") == after


@pytest.fixture(scope="module")
def joint_in_java(sitaf, tmp_path_factory):
    folder = shutil.copytree(sitaf.root / "examples" / "joint-pid", tmp_path_factory.mktemp("joint") / "java")
    return results(sitaf, folder, "Hold")


def test_a_periodic_component_is_the_same_in_every_language(sitaf, tmp_path, language, joint_in_java):
    names = {"cpp": "robot::JointController", "python": "joint_controller.JointController"}
    other = from_example(sitaf, tmp_path / language, "joint-pid", language, names[language], "joint")
    code, found = results(sitaf, other, "Hold")
    assert (code, set(verdicts(found))) == (0, {"PASS"})
    assert (code, found) == joint_in_java


def test_an_exception_in_a_period_makes_the_case_an_error(sitaf, tmp_path, language):
    names = {"cpp": "robot::JointController", "python": "joint_controller.JointController"}
    folder = from_example(sitaf, tmp_path / language, "joint-pid", language, names[language], "joint")
    if language == "cpp":
        replace(folder / "component/joint_controller.hpp", "++periods_;", '++periods_;\n    if (target_ > 0.9) throw "slipped";')
    else:
        replace(
            folder / "component/joint_controller.py",
            "self._periods += 1",
            "self._periods += 1\n        assert self._target <= 0.9, 'slipped'",
        )
    _, found = results(sitaf, folder, "Hold")
    at_one = [result["verdict"] for result in found.values() if result["values"][0] in ("1", "1.0")]
    assert set(at_one) == {"ERROR"}
    assert verdicts(found).count("PASS") == len(found) - len(at_one) > 0


MODELS = ["Swing", "Watch", "Limit", "start"]


@pytest.fixture(scope="module")
def arm_in_java(sitaf, tmp_path_factory):
    folder = arm(sitaf, tmp_path_factory.mktemp("arm"), "java")
    return results(sitaf, folder, *MODELS)


def test_a_nonblocking_call_runs_while_time_advances_in_java(arm_in_java):
    code, found = arm_in_java
    assert (code, set(verdicts(found))) == (0, {"PASS"})
    # The call's effort moves the joint; if time advances after the call, so does its end.
    swing, watch = (found[model, 1]["actual"] for model in ("Swing", "Watch"))
    assert dict(swing)["angle_held"] != dict(watch)["angle_held"]
    assert dict(swing)["angles"].count(",") == 9


def test_nonblocking_calls_and_data_ports_are_the_same_in_every_language(sitaf, tmp_path, arm_in_java, language):
    assert results(sitaf, arm(sitaf, tmp_path, language), *MODELS) == arm_in_java


CONDITIONS_OVER_PORTS = """</post_condition_spec_list>
  <trajectory_condition_spec_list>
    <trajectory_condition name="limited">always(most == 6.0)</trajectory_condition>
    <trajectory_condition name="swings once">eventually(always(state.swings == 1.0))</trajectory_condition>
    <trajectory_condition name="never swings">always(state.swings == 0.0)</trajectory_condition>
  </trajectory_condition_spec_list>"""


@pytest.mark.parametrize("tested", LANGUAGES)
def test_conditions_over_time_see_data_ports_in_every_language(sitaf, tmp_path, tested):
    folder = arm(sitaf, tmp_path / "arm", tested)
    replace(folder / "Swing.xml", "</post_condition_spec_list>", CONDITIONS_OVER_PORTS)
    run = sitaf("run", folder, "--model", "Swing", "--result", tmp_path / "result.xml", "--signals", tmp_path / "signals")
    assert run.returncode == 1, run.stdout + run.stderr
    judged = {}
    for result in ElementTree.parse(tmp_path / "result.xml").getroot().iter("test_result"):
        conditions = {c.attrib["name"]: (c.attrib["verdict"], c.attrib["at"]) for c in result.findall("trajectory")}
        judged[result.findall("value")[2].text] = conditions
        if conditions and conditions["never swings"][0] == "FAIL":
            rows = [row.split(",") for row in (tmp_path / "signals" / f"{result.attrib['no']}.csv").read_text().splitlines()]
            swings, most, time = (rows[0].index(name) for name in ("state.swings", "most", "t"))
            since = float(conditions["never swings"][1])
            assert {(row[swings], row[most]) for row in rows[1:] if float(row[time]) >= since} == {("1", "6")}
            assert all(row[swings] == "0" for row in rows[1:] if float(row[time]) < since)
    # The clock takes time in one case, so the swing begins later.
    assert judged["2.0"]["limited"][0] == judged["2.0"]["swings once"][0] == "PASS"
    assert judged["2.0"]["never swings"] == ("FAIL", "0.0")
    assert judged["!delay:0.25 3.5"]["never swings"] == ("FAIL", "0.25")


@pytest.mark.parametrize("spoilt", LANGUAGES)
def test_a_call_that_never_ends_is_an_error_and_the_next_case_runs(sitaf, tmp_path, spoilt):
    folder = arm(sitaf, tmp_path, spoilt)
    replace(folder / "Swing.xml", "<value>1.5</value>", "<value>0</value>")
    _, found = results(sitaf, folder, "Swing")
    by_effort = {(float(r["values"][0]), r["values"][2] == "!error:NoClock"): r for r in found.values()}
    endless = by_effort[0.0, False]
    assert (endless["verdict"], endless["message"]) == ("ERROR", "the case took more than 4 s of simulation time")
    assert {by_effort[0.0, True]["verdict"], by_effort[7.0, True]["verdict"], by_effort[7.0, False]["verdict"]} == {"PASS"}
    assert verdicts(found).count("ERROR") == 4


@pytest.mark.parametrize("spoilt", LANGUAGES)
def test_a_method_without_a_value_that_does_not_throw_as_expected_fails(sitaf, tmp_path, spoilt):
    folder = arm(sitaf, tmp_path, spoilt)
    replace(folder / "Limit.xml", 'valid ? null : "!error:TooStrong"', 'most == 4.0 ? "!error:TooStrong" : null')
    _, found = results(sitaf, folder, "Limit")
    judged = {float(result["values"][0]): (result["verdict"], result["message"]) for result in found.values()}
    assert judged[4.0] == ("FAIL", "return: expected the error TooStrong, but it returned")
    assert [value for value, (verdict, _) in judged.items() if verdict == "ERROR"] == [-0.5, 8.5]
    assert verdicts(found).count("PASS") == len(found) - 3


@pytest.mark.parametrize("example", ["ir-sensor-python", pytest.param("ir-sensor-cpp", marks=[cpp, pytest.mark.long])])
def test_the_motion_of_each_case_is_recorded(sitaf, tmp_path, example):
    run = sitaf("run", f"examples/{example}", "--recording", tmp_path)
    assert run.returncode == 0, run.stdout + run.stderr
    files = list((tmp_path / "GetInfraredData").iterdir())
    assert {file.name for file in files} == {f"{no}.glb" for no in range(1, 56)}
    assert all(file.read_bytes().startswith(b"glTF") for file in files)
