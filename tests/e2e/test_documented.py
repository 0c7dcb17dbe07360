"""The documents' commands give the output that is shown, and their fragments are parts of activities that run."""

import json
import os
import re
import shlex
import shutil
import subprocess
from pathlib import Path
from xml.etree import ElementTree

import pytest
from snippets import ROOT, SNIPPETS, expect_lines, is_part, sessions, snippet

yaml = pytest.importorskip("yaml", reason="PyYAML is missing")

EXAMPLES = ROOT / "examples"
# Sessions with a debugger, two simulators or a repository of their own.
RUN_ELSEWHERE = {
    "compare-2-output": "test_compare_simulators.py",
    "compare-4-output": "test_bisect.py",
    "debugging-1-output": "test_debug.py",
    "debugging-2-output": "test_debug.py",
}
# The same command with --json.
JSON = {
    "campaign-1-output": "campaign-2-json",
    "compare-1-output": "compare-3-json",
    "score-1-output": "score-4-output",
}
# Where a fragment of a document belongs: an example, its file, the place there, and how the fragment and the place are combined.
PLACES = {
    "faults-1-xml": ("ir-sensor", "GetInfraredData.xml", "</input_spec_list>", "{1}{0}"),
    "faults-2-xml": ("sensor-dropout", "Approach.xml", r"<trajectory_condition name=.*</trajectory_condition>", "{1}"),
    "relations-1-xml": ("angle-normalisation", "Normalise.xml", "<relation_list>.*</relation_list>", "{1}"),
    "sequences-1-xml": ("ir-sensor-states", "LifeCycle.xml", "<test_model>.*</test_model>", "{1}"),
    "sequences-2-xml": ("collision-guard", "Watching.xml", '<call name="Check" .*?</call>', "{1}"),
    "test-values-1-xml": ("wrist-kinematics", "Reach.xml", "<test_element.*?</test_element>", "{1}"),
    "test-values-2-xml": (
        "speed-profile",
        "Duration.xml",
        "<user_value_list><value>0.5</value><value>1.3</value></user_value_list>",
        "{1}",
    ),
    "timing-1-yaml": ("median-filter", "activity.yaml", "timing:.*?\n", "{1}\n"),
    "timing-2-xml": ("angle-normalisation", "Normalise.xml", "<order_of_combinations>", "{1}{0}"),
    "trajectory-conditions-1-xml": ("wall-approach", "Approach.xml", "<order_of_combinations>", "{1}{0}"),
}

RETURN = """<output_spec_list><test_element abstract_type="NUMERIC" real_type="double"><name>return</name><type>RETURN</type>
</test_element></output_spec_list>"""


def example(name, folder):
    """A copy of an example, below the folder as below the root."""
    place = folder / "examples" / name
    shutil.copytree(EXAMPLES / name, place)
    return place


@pytest.mark.parametrize("name", [s.name for s in SNIPPETS if s.is_session and s.name not in RUN_ELSEWHERE])
def test_a_command_prints_what_is_shown(sitaf, name, tmp_path):
    for command, _, expected in sessions(snippet(name)):
        arguments = shlex.split(command)[1:]
        for argument in arguments:
            if argument.startswith("examples/"):
                example(Path(argument).name, tmp_path)
        file = tmp_path / "shown.json"
        ran = sitaf(*arguments, *(["--json", file] if name in JSON else []), cwd=tmp_path)
        print(ran.stderr, ran.returncode)
        expect_lines(expected, ran.stdout)
        if name in JSON:
            assert is_part(json.loads(snippet(JSON[name])), json.loads(file.read_text())), file.read_text()


def test_a_lock_has_what_is_shown(sitaf, tmp_path):
    example("simple-pid", tmp_path)
    assert sitaf("lock", "examples/simple-pid", cwd=tmp_path).returncode == 0
    lock = yaml.safe_load((tmp_path / "examples" / "simple-pid" / "activity.lock").read_text())
    assert is_part(yaml.safe_load(snippet("packages-2-yaml")), lock), lock


def inserted(name, folder):
    """A copy of an example with the fragment of a document in its place."""
    example_name, file, place, how = PLACES[name]
    text = snippet(name).strip()
    copy = example(example_name, folder)
    model = (copy / file).read_text()
    found = re.search(place, model, re.DOTALL)
    assert found, f"{file} has no {place}"
    # What a document leaves out is that of the example.
    for left_out in re.findall(r"<(\w+)>\.\.\.</\w+>", text):
        if left_out == "output_spec_list" and name == "sequences-1-xml":
            # That of the example uses states which the document does not have.
            text = text.replace(f"<{left_out}>...</{left_out}>", RETURN)
            continue
        whole = re.search(
            rf"<{left_out}>(?:(?!<{left_out}>).)*?</{left_out}>(?=(?:(?!<call).)*</call>)", model, re.DOTALL
        )
        text = text.replace(f"<{left_out}>...</{left_out}>", whole[0], 1)
    (copy / file).write_text(model[: found.start()] + how.format(found[0], text) + model[found.end() :])
    return copy


@pytest.mark.parametrize("name", PLACES)
def test_a_fragment_is_part_of_an_activity_that_runs(sitaf, name, tmp_path):
    ran = sitaf("run", inserted(name, tmp_path), "--no-coverage")
    assert ran.returncode in (0, 1), ran.stderr
    assert re.search(r": [1-9]\d* cases, ", ran.stdout), ran.stdout
    assert " 0 ERROR" in ran.stdout, ran.stdout


def test_the_activity_of_the_reference_is_that_of_an_example():
    shown = yaml.safe_load(snippet("activity-1-yaml"))
    example_has = yaml.safe_load((EXAMPLES / "ir-sensor" / "activity.yaml").read_text())
    assert shown.pop("component").items() <= example_has["component"].items()
    assert shown.items() <= example_has.items()


def pipelines():
    """The commands of each pipeline of the documents, with the place of the checkout as the pipeline names it."""
    workflow = yaml.safe_load(snippet("continuous-integration-1-yaml"))
    steps = [step["run"] for step in workflow["jobs"]["sitaf"]["steps"] if "run" in step]
    yield "GitHub", [step for step in steps if "/sitaf/sitaf " in step]
    yield "GitLab", yaml.safe_load(snippet("continuous-integration-2-yaml"))["interface-tests"]["script"]
    yield "Jenkins", re.findall(r"sh '(\"\$SITAF/sitaf\" .*?)'", snippet("continuous-integration-3-groovy"))


@pytest.mark.parametrize(("name", "commands"), pipelines(), ids=lambda value: value if isinstance(value, str) else "")
def test_a_pipeline_tests_an_activity_and_compares_it_with_its_base(name, commands, tmp_path):
    # Any activity will do; this one takes seconds.
    shutil.copytree(EXAMPLES / "acceleration-limiter", tmp_path / "robot-tests" / "gripper")

    def git(*arguments):
        who = ["-c", "user.name=Ada", "-c", "user.email=ada@robots.example"]
        done = subprocess.run(["git", *who, *arguments], cwd=tmp_path, capture_output=True, text=True, check=True)
        return done.stdout.strip()

    git("init", "-q")
    git("add", ".")
    git("commit", "-q", "-m", "The base")
    base = git("rev-parse", "HEAD")
    places = {
        "$RUNNER_TEMP/sitaf": str(ROOT),
        "/opt/sitaf": str(ROOT),
        "${{ github.event.pull_request.base.sha }}": base,
    }
    for command in commands:
        for place, there in places.items():
            command = command.replace(place, there)
        env = {**os.environ, "SITAF": str(ROOT), "CI_MERGE_REQUEST_DIFF_BASE_SHA": base}
        ran = subprocess.run(
            ["bash", "-ec", command], cwd=tmp_path, env=env, capture_output=True, text=True, check=False
        )
        assert ran.returncode == 0, ran.stdout + ran.stderr
        if " compare " in command:
            assert "no differences" in ran.stdout, ran.stdout
    assert len(commands) == (1 if name == "Jenkins" else 2)
    report = ElementTree.parse(tmp_path / "report.xml").getroot()
    assert len(list(report.iter("testcase"))) > 5
