"""The excerpts of results in the documents have the form, and where they are of an example the values, of real ones."""

import importlib.metadata
import os
import re
import shlex
import shutil
import subprocess
import sys
from xml.etree import ElementTree

import pytest
from needs import cmake
from snippets import ROOT, snippet

yaml = pytest.importorskip("yaml", reason="PyYAML is missing")

EXAMPLES = ROOT / "examples"
RANDOM = '''
import random


class Wanderer:
    def __init__(self, hardware):
        self.base = hardware.differential_drive("base")
        self.hardware = hardware

    def go(self) -> bool:
        """Drives at another speed in each run, from 0.12 s on."""
        self.base.drive(0.1, 0.0)
        self.hardware.sleep(0.118)
        speed = random.choice([0.1, 0.2, 0.3, 0.4])
        self.base.drive(speed, 0.0)
        return speed > 0.25
'''
GO = """<test_model><name>Go</name><target interface="Wanderer" method="Go" run_for="0.1"/><input_spec_list>
<test_element abstract_type="NUMERIC" real_type="double"><name>StartX</name><type>TDSD</type><user_value_list>
<value>0.1</value><value>0.2</value><value>0.3</value><value>0.4</value></user_value_list></test_element></input_spec_list>
<output_spec_list><test_element abstract_type="BOOLEAN" real_type="boolean"><name>return</name><type>RETURN</type>
<expected>true</expected></test_element></output_spec_list><order_of_combinations>1</order_of_combinations></test_model>"""


def names(element, path=""):
    """The paths of an element's descendants and their attributes."""
    own = f"{path}/{element.tag}"
    yield own
    for attribute in element.attrib:
        yield f"{own}@{attribute}"
    for child in element:
        yield from names(child, own)


def result_of(sitaf, example, model, folder):
    sitaf("run", f"examples/{example}", "--result", folder, "--no-coverage")
    return ElementTree.parse(folder / f"{model}.xml").getroot()


def test_a_broken_relation_is_in_the_result(sitaf, tmp_path):
    shown = ElementTree.fromstring(snippet("relations-2-xml"))
    result = result_of(sitaf, "angle-normalisation-faulty", "Normalise", tmp_path)
    real = [
        r
        for r in result.iter("relation")
        if r.get("name") == shown.get("name") and r.findtext("value") == shown.findtext("value")
    ]
    assert real, ElementTree.tostring(result, "unicode")
    assert (real[0].get("verdict"), real[0].findtext("actual")) == (shown.get("verdict"), shown.findtext("actual"))
    assert real[0].findtext("message").startswith(shown.findtext("message").removesuffix("..."))


def test_a_case_of_a_sequence_has_its_steps(sitaf, tmp_path):
    shown = ElementTree.fromstring(snippet("sequences-3-xml"))
    result = result_of(sitaf, "ir-sensor-states-faulty", "LifeCycle", tmp_path)
    real = {name for case in result.iter("test_result") for name in names(case)}
    assert set(names(shown)) - real == set()


def test_a_violated_condition_has_its_margin_and_time(sitaf, tmp_path):
    shown = ElementTree.fromstring(snippet("trajectory-conditions-2-xml"))
    result = result_of(sitaf, "touchless-approach-faulty", "Approach", tmp_path)
    assert shown.attrib in [t.attrib for t in result.iter("trajectory")], ElementTree.tostring(result, "unicode")


def test_cases_that_are_not_reproducible_are_listed_with_their_cause(sitaf, tmp_path):
    heading, line = snippet("explain-1-output").splitlines()
    shutil.copytree(EXAMPLES / "wall-distance" / "world", tmp_path / "world")
    (tmp_path / "component").mkdir()
    (tmp_path / "component" / "wanderer.py").write_text(RANDOM)
    (tmp_path / "wanderer.idl").write_text("interface Wanderer { boolean Go(); };\n")
    (tmp_path / "Go.xml").write_text(GO)
    (tmp_path / "activity.yaml").write_text(
        "name: wanderer\ncomponent: {language: python, sources: component/, class: wanderer.Wanderer}\n"
        "provided: [wanderer.idl]\nworld: world/maze.world.yaml\nmodels: [Go.xml]\n"
    )
    run = sitaf("run", tmp_path, "--repeat", "4", "--no-coverage")
    assert heading in run.stdout, run.stdout
    # Which cases, and their verdicts, are at random.
    form = re.escape(line).replace("\\ ", " ").replace("case 3", r"case \d")
    form = re.sub("PASS|FAIL", "(PASS|FAIL)", form)
    assert re.search(f"(?m)^{form}$", run.stdout), f"{form}\n{run.stdout}"


@cmake
def test_a_cmake_project_has_options(sitaf, tmp_path):
    folder = shutil.copytree(EXAMPLES / "acceleration-limiter", tmp_path / "limiter")
    profile = yaml.safe_load((folder / "activity.yaml").read_text())
    shown = yaml.safe_load(snippet("writing-a-component-1-yaml"))["component"]
    # The names of the target and the class are those of the example.
    shown["cmake"]["target"], shown["class"] = profile["component"]["cmake"]["target"], profile["component"]["class"]
    lists = folder / "component" / "CMakeLists.txt"
    lists.write_text(
        'option(WITH_GUI "A window" ON)\nif(WITH_GUI)\n  message(FATAL_ERROR "no window")\nendif()\n'
        + lists.read_text()
    )
    (folder / "activity.yaml").write_text(yaml.safe_dump({**profile, "component": shown}))
    run = sitaf("run", folder, "--no-coverage")
    assert run.returncode == 0, run.stdout + run.stderr


def test_a_test_application_knows_its_options(sitaf, tmp_path):
    program, *options = snippet("test-application-1-output").replace("[", "").replace("]", "").split()
    assert program == "ENTRY-POINT"
    example = EXAMPLES / "angle-normalisation"
    assert sitaf("harness", example, "-o", tmp_path / "application").returncode == 0
    assert sitaf("generate", example, "-o", tmp_path / "suite.xml").returncode == 0
    (tmp_path / "recordings").mkdir()
    values = {
        "FILE": tmp_path / "suite.xml", "FILE|fd:N": tmp_path / "results", "DIR": tmp_path / "recordings",
        "NO": 2, "N": 3, "SECONDS": 5,
    }  # fmt: skip
    # A component without a world has no simulator.
    without = {"--bridge": "TARGET", "--world": "FILE.world.yaml"}
    given = [str(values.get(word, word)) for word in options if word not in {*without, *without.values()}]
    sources = [tmp_path / "application", example / "component", ROOT / "tba-agent" / "runtime-python" / "src"]
    subprocess.run(
        [sys.executable, "-m", "sitaf_harness.normalise.concrete_test_driver", *given],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(map(str, sources))}, check=True,
    )  # fmt: skip
    records = [line for line in (tmp_path / "results").read_text().splitlines() if line]
    assert records[0].startswith('<case_record no="2" ')
    assert all("<repeated_calls>" in line for line in records)


def test_the_commands_of_the_readme_work(sitaf, tmp_path):
    """Those of "README-1-output" and "README-2-output" are run by test_demo.py, that of "README-4-output" by test_server.py."""
    try:
        robots = importlib.metadata.distribution("example-robot-data")
    except importlib.metadata.PackageNotFoundError:
        pytest.skip("needs pip install sim-bridge[robots]")
    urdf = robots.locate_file("cmeel.prefix/share/example-robot-data/robots/ur_description/urdf/ur5_robot.urdf")
    (tmp_path / "ur5e.urdf").symlink_to(urdf)
    (tmp_path / "Spin.action").write_text("float32 target_yaw\n---\nfloat32 total_elapsed_time\n---\nfloat32 angle\n")
    node = tmp_path / "ros_ws" / "src" / "my_package"
    shutil.copytree(EXAMPLES / "wall-stop-ros" / "src" / "wall_stop", node)
    for name in ("ir-sensor", "ir-sensor-faulty"):
        shutil.copytree(EXAMPLES / name, tmp_path / "examples" / name)
    lines = snippet("README-3-output").splitlines()
    assert len(lines) == 7
    for line in lines:
        command, *arguments = shlex.split(line, comments=True)
        assert command == "./sitaf"
        run = sitaf(*(a.replace("~", str(tmp_path)) for a in arguments), cwd=tmp_path)
        expected = 1 if "exit code 1" in line else 0
        assert run.returncode == expected, f"{line}\n{run.stdout}{run.stderr}"
        # The next line begins the same folder.
        shutil.rmtree(tmp_path / "my-activity", ignore_errors=True)
    assert (tmp_path / "report.xml").is_file()
    assert (tmp_path / "cases.xml").is_file()
