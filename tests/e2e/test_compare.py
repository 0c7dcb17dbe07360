"""`./sitaf compare`: two versions without expected values."""

import json
import os
import re
import shutil
import subprocess
import xml.etree.ElementTree as ElementTree

import pytest

ACTIVITY = """\
name: counter
component:
  language: python
  sources: component/
  class: counter.Counter
provided: [counter.idl]
models: [Read.xml]
"""
IDL = "interface Counter { double Read(in double gain, in boolean inverted); };\n"
MODEL = """\
<test_model><name>Read</name>
  <input_spec_list>
    <test_element abstract_type="NUMERIC" real_type="double"><name>gain</name><type>TDI</type>
      <user_value_list><value>1</value><value>2</value><value>3</value></user_value_list></test_element>
    <test_element abstract_type="BOOLEAN" real_type="boolean"><name>inverted</name><type>TDI</type>
      <test_spec type="ECP"><equiv_class type="NEC_BOOLEAN"/></test_spec></test_element>
  </input_spec_list>
  <output_spec_list/>
  <order_of_combinations>all</order_of_combinations>
</test_model>
"""
STABLE = "return -gain if inverted else gain"


def write(folder, body, imports="", idl=IDL, model=MODEL):
    (folder / "component").mkdir(parents=True, exist_ok=True)
    (folder / "activity.yaml").write_text(ACTIVITY)
    (folder / "counter.idl").write_text(idl)
    (folder / "Read.xml").write_text(model)
    lines = "\n        ".join(body.splitlines())
    (folder / "component" / "counter.py").write_text(
        f"{imports}\n\n\nclass Counter:\n    def read(self, gain, inverted):\n        {lines}\n"
    )
    return folder


@pytest.fixture
def compare(sitaf, tmp_path):
    """Compares and returns the exit code, the JSON and the output."""

    def run(*arguments):
        file = tmp_path / "comparison.json"
        file.unlink(missing_ok=True)
        done = sitaf("compare", *arguments, "--json", file)
        found = json.loads(file.read_text()) if file.exists() else None
        return done.returncode, found, done.stdout + done.stderr

    return run


def test_a_regression_that_no_expected_value_shows(compare, tmp_path):
    report = tmp_path / "report.xml"
    code, found, output = compare("examples/speed-profile", "examples/speed-profile-next", "--junit", report)
    assert code == 1, output
    assert found["cases"] == 24
    assert {(d["class"], d["output"]) for d in found["differences"]} == {("value", "return")}
    assert len(found["differences"]) == len(found["last_bits"]) == 4
    assert found["unstable"] == found["not_comparable"] == []
    assert "4 values of return up to 0.0063 off" in output
    suite = ElementTree.parse(report).getroot().find("testsuite")
    assert (suite.attrib["tests"], suite.attrib["failures"]) == ("24", "4")


def test_the_same_version_has_no_differences(sitaf, compare, tmp_path):
    archive = shutil.make_archive(tmp_path / "profile", "zip", sitaf.root / "examples" / "speed-profile")
    code, found, output = compare("examples/speed-profile", archive, "--ulp", "0")
    assert code == 0, output
    assert found["cases"] == 24
    assert [found[key] for key in ("differences", "groups", "last_bits", "unstable", "slower")] == [[]] * 5
    assert "24 cases compared, no differences" in output


def test_differences_are_grouped_with_the_largest_last(compare, tmp_path):
    base = write(tmp_path / "base", STABLE)
    body = "if inverted and gain == 3:\n    raise ValueError(f'no {self}')\nreturn gain * (1.5 if gain > 1 else 1 + 2e-16)"
    code, found, output = compare(base, write(tmp_path / "new", body))
    assert code == 1, output
    assert [group["class"] for group in found["groups"]] == ["error", "value"]
    assert "1 × ValueError in NEW only" in found["groups"][0]["text"]
    errors = [d for d in found["differences"] if d["class"] == "error"]
    assert errors[0]["inputs"] == {"gain": "3.0", "inverted": "true"}
    assert errors[0]["base"] == "return = -3.0"
    assert errors[0]["new"].startswith("ValueError: no <counter.Counter object at 0x")
    assert found["unstable"] == []


@pytest.mark.parametrize(
    ("imports", "body"),
    [
        ("import random", "return random.random()"),
        pytest.param("import time", "return float(time.time_ns() % 1000003)", marks=pytest.mark.long),
        pytest.param(
            "",
            "return float(next(iter({'a', 'b', 'c', 'd', 'e', 'f', 'g', 'h'})) == 'a') + hash('x') % 97",
            marks=pytest.mark.long,
        ),
        ("import ctypes", "size = 1 << 20\nmalloc = ctypes.CDLL(None).malloc\nmalloc.restype = ctypes.c_void_p\nreturn float((ctypes.c_ubyte * size).from_address(malloc(size >> 8))[2000])"),
        pytest.param(
            "import sys, threading\n\nsys.setswitchinterval(1e-6)",
            "order = []\nall = [threading.Thread(target=lambda n=n: [order.append(n) for _ in range(5000)]) for n in range(4)]\n"
            "[t.start() for t in all]\n[t.join() for t in all]\nreturn float(hash(tuple(order)) % 1000003)",
            marks=pytest.mark.long,
        ),
    ],
    ids=["random", "time", "hashes", "memory", "threads"],
)
def test_an_unstable_component_has_no_differences(compare, tmp_path, imports, body):
    folder = write(tmp_path / "unstable", body, imports)
    code, found, output = compare(folder, folder)
    assert code == 0, output
    assert found["differences"] == []
    assert {(d["class"], d["output"]) for d in found["unstable"]} == {("value", "return")}
    assert "unstable: runs of the same version disagree" in output


def test_unstable_components_in_three_languages_have_no_differences(sitaf):
    run = sitaf("bench", "unstable", "--runs", "5")
    assert run.returncode == 0, run.stdout + run.stderr


def test_a_state_between_cases_does_not_hide_a_difference(compare, tmp_path):
    imports = "calls = []"
    base = write(tmp_path / "base", "calls.append(1)\nreturn len(calls) * 10.0", imports)
    new = write(tmp_path / "new", "calls.append(1)\nreturn len(calls) * 10.0 + (len(calls) > 4)", imports)
    code, found, output = compare(base, new)
    assert code == 1, output
    assert [d["no"] for d in found["differences"]] == [5, 6]
    assert found["unstable"] == []


def test_revisions_of_a_git_repository(compare, tmp_path):
    repository = tmp_path / "repository"
    folder = write(repository / "activities" / "counter", STABLE)
    environment = {**os.environ, "GIT_CONFIG_GLOBAL": "/dev/null", "GIT_CONFIG_SYSTEM": "/dev/null"}

    def git(*arguments):
        identity = ["-c", "user.name=t", "-c", "user.email=t@example.org"]
        subprocess.run(["git", *identity, *arguments], cwd=repository, check=True, capture_output=True, env=environment)

    git("init", "-q", "-b", "main")
    git("add", ".")
    git("commit", "-q", "-m", "first")
    git("config", "filter.evil.smudge", f"touch {tmp_path}/ran")
    (repository / ".gitattributes").write_text("* filter=evil\n")
    write(folder, "return gain")
    code, found, output = compare(f"{folder}@HEAD", folder)
    assert code == 1, output
    assert {d["inputs"]["inverted"] for d in found["differences"]} == {"true"}
    assert found["groups"][0]["text"].endswith("off where inverted = true")
    assert not (tmp_path / "ran").exists()
    code, found, output = compare(f"{folder}@main", f"{folder}@HEAD@{{0}}")
    assert code == 0, output
    code, _, output = compare(f"{folder}@nowhere", folder)
    assert code == 2
    assert "'nowhere' is no revision of the repository" in output
    code, _, output = compare(f"{repository}/other@HEAD", folder)
    assert code == 2
    assert "the folder other does not exist at this revision" in output


def test_what_only_one_version_has_is_not_comparable(compare, tmp_path):
    new = write(tmp_path / "new", STABLE)
    renamed = write(tmp_path / "renamed", STABLE, idl=IDL.replace("Read(", "Measure("), model=MODEL.replace("<name>Read</name>", "<name>Measure</name>"))
    code, found, output = compare(renamed, new)
    assert code == 2, output
    reasons = {entry["model"]: entry["reason"] for entry in found["not_comparable"]}
    assert reasons["Measure"] == "NEW does not have this model"
    assert "no method Read; known methods: Counter.Measure" in reasons["Read"]
    broken = write(tmp_path / "broken", "return (")
    code, found, output = compare(broken, new)
    assert code == 2, output
    assert found["not_comparable"][0]["reason"].startswith("BASE: ")
    assert "counter.py" in found["not_comparable"][0]["reason"]


def test_lines_that_are_no_longer_executed(compare, tmp_path):
    base = write(tmp_path / "base", "if gain > 1:\n    gain = gain + 0\n    gain = gain * 1\nreturn gain")
    new = write(tmp_path / "new", "# Never.\nif gain > 9:\n    gain = gain + 0\n    gain = gain * 1\nreturn gain")
    code, found, output = compare(base, new)
    assert code == 1, output
    (lost,) = found["differences"]
    assert (lost["class"], lost["output"], lost["no"]) == ("coverage_lost", "component/counter.py", 0)
    assert lost["base"] == "executes lines 8-9"
    assert "lines of component/counter.py are no longer executed" in output


def test_another_release_of_a_package(compare):
    code, found, output = compare("examples/simple-pid", "examples/simple-pid", "--new-package", "simple-pid==0.1.0")
    assert code == 1, output
    assert found["cases"] == 54
    # The adapter does not fit the interface of this early release.
    assert {d["class"] for d in found["differences"]} == {"error"}
    assert len(found["differences"]) == 54
    assert "NEW does not use the same packages and tools:\n  simple-pid 2.0.1 -> 0.1.0\n" in output


def test_a_component_that_cannot_be_created_is_not_comparable(compare, tmp_path):
    folder = write(tmp_path / "broken", STABLE, "import no_such_module")
    code, found, output = compare(folder, folder)
    assert code == 2, output
    assert found["cases"] == 0
    assert "no_such_module" in found["not_comparable"][0]["reason"]


@pytest.mark.parametrize("values", ["one", pytest.param("all", marks=pytest.mark.long)])
def test_a_motion_diverges_at_its_first_step(compare, sitaf, tmp_path, values):
    faulty = shutil.copytree(sitaf.root / "examples" / "wall-approach-faulty", tmp_path / "faulty")
    if values == "one":
        model = faulty / "Approach.xml"
        text, removed = re.subn(r"(<value>[^<]*</value>)(?:<value>[^<]*</value>)+", r"\1", model.read_text())
        assert removed == 3
        model.write_text(text)
    code, found, output = compare("examples/wall-approach", faulty)
    assert code == 1, output
    by_class = {d["class"]: d for d in found["differences"] if d["no"] == found["differences"][0]["no"]}
    assert {"commands", "observed", "trajectory"} <= set(by_class)
    assert by_class["commands"]["output"] == "base.linear.command"
    assert 0 <= by_class["commands"]["at_s"] <= by_class["trajectory"]["at_s"]
