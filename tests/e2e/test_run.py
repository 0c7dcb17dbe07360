"""`./sitaf run` on this machine."""

import os
import re
import shutil
import signal
import subprocess
import time
import xml.etree.ElementTree as ElementTree

import pytest


def replace(path, old, new):
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))


def test_the_infrared_sensor_passes_and_its_coverage_is_printed(sitaf, tmp_path):
    run = sitaf("run", "examples/ir-sensor", "--result", tmp_path / "results")
    assert run.returncode == 0, run.stdout + run.stderr
    assert "GetInfraredData: 55 cases, 55 PASS" in run.stdout
    root = ElementTree.parse(tmp_path / "results" / "GetInfraredData.xml").getroot()
    assert root.find("summary").attrib["total"] == "55"

    assert re.search(r"coverage of the component: [\d.]+ % of statements, [\d.]+ % of branches", run.stdout)
    assert 50 < float(root.find("summary/coverage").attrib["statement"]) <= 100
    (file,) = root.findall("coverage_list/file")
    assert file.attrib["path"] == "component/org/sitaf/examples/ir/InfraredSensor.java"
    assert {line.attrib["reached"] for line in file} == {"true", "false"}


def test_required_sandbox_must_exist(sitaf, tmp_path):
    for tool in ("bash", "java", "javac", "dirname", "readlink", "flock", "mkdir", "find", "touch", "python3", "mvn", "npm"):
        if found := shutil.which(tool):
            (tmp_path / tool).symlink_to(found)
    run = sitaf("run", "examples/ir-sensor", "--sandbox", "required", env={"PATH": str(tmp_path)})
    assert run.returncode == 2
    assert "bubblewrap is not installed; install it with: apt-get install bubblewrap" in run.stderr


def test_the_faulty_sensor_fails_exactly_the_affected_cases(sitaf, tmp_path):
    report = tmp_path / "report.xml"
    run = sitaf("run", "examples/ir-sensor-faulty", "--junit", report)
    assert run.returncode == 1, run.stdout + run.stderr
    rows = re.findall(r"^ *\d+ +FAIL +(-?\d+) +(-?\d+) +(-?[\d.]+) ", run.stdout, re.MULTILINE)
    # The fault: the last of the sensors in use is never read (see the example's README).
    assert sorted((int(i), int(n)) for i, n, _ in rows) == [(1, 1), (2, 2), (4, 4), (6, 6), (7, 7)]
    assert "GetInfraredData: 55 cases, 50 PASS, 5 FAIL, 0 ERROR, 0 DONT" in run.stdout
    suite = ElementTree.parse(report).getroot().find("testsuite")
    assert suite.attrib["tests"] == "55"
    assert suite.attrib["failures"] == "5"
    assert len(suite.findall("testcase/failure")) == 5


def test_single_cases_and_those_that_failed_run_again(sitaf, tmp_path):
    report = tmp_path / "report.xml"
    example = "examples/ir-sensor-faulty"
    run = sitaf("run", example, "--case", "13,2-3", "--repeat", "2", "--junit", report)
    assert run.returncode == 1, run.stdout + run.stderr
    assert "GetInfraredData: 3 cases, 2 PASS, 1 FAIL" in run.stdout
    assert "in 2 runs each case had the same verdict and the same values" in run.stdout
    names = [case.attrib["name"] for case in ElementTree.parse(report).iter("testcase")]
    assert [name.split(":")[0] for name in names] == ["2", "3", "13"]

    result = tmp_path / "result.xml"
    assert sitaf("run", example, "--model", "GetInfraredData", "--result", result).returncode == 1
    folder = tmp_path / "results"
    folder.mkdir()
    (folder / "GetInfraredData.xml").symlink_to(result)
    assert "5 cases, 0 PASS, 5 FAIL" in sitaf("run", example, "--failed", folder).stdout
    again = sitaf("run", example, "--failed", result, "--until-failure")
    assert "run 1" in again.stderr and "run 2" not in again.stderr
    assert "GetInfraredData: 5 cases, 0 PASS, 5 FAIL" in again.stdout
    assert "GetInfraredData: 5 cases, 0 PASS, 5 FAIL" in sitaf("run", example, "--failed").stdout


@pytest.mark.parametrize("name", ["motor-jitter", "error-with-lambda"])
def test_unstable_components_are_told_from_stable_ones(sitaf, name):
    """Of `./sitaf bench flaky`: commands at random, and an error whose message has an address."""
    run = sitaf("bench", "flaky", "--only", name)
    assert run.returncode == 0, run.stdout + run.stderr
    assert "1 components in" in run.stdout


@pytest.mark.long  # Two components of the table are tests of their own.
def test_a_part_of_the_table_of_unstable_components_is_attributed_rightly(sitaf):
    run = sitaf("bench", "flaky", "--short")
    assert run.returncode == 0, run.stdout + run.stderr


def test_a_case_that_does_not_exist_is_reported(sitaf):
    run = sitaf("run", "examples/ir-sensor", "--model", "GetInfraredData", "--case", "3,56-60")
    assert run.returncode == 2
    assert "--case 56-60: error: does not exist; GetInfraredData has 55 cases, numbered 1 to 55" in run.stderr


def test_an_interrupted_run_keeps_the_finished_cases(sitaf, activity, tmp_path):
    source = next(activity.glob("component/**/InfraredSensor.java"))
    text = source.read_text()
    body = re.search(r"double GetInfraredData\([^)]*\) \{", text)
    wait = " if (indexOfSensor == 8) { while (true) Thread.onSpinWait(); }"
    source.write_text(text[: body.end()] + wait + text[body.end() :])
    result = tmp_path / "result.xml"
    process = subprocess.Popen(
        [sitaf.root / "sitaf", "run", activity, "--model", "GetInfraredData", "--result", result, "--signals", tmp_path],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        start_new_session=True,
    )
    # The valid cases end at once; the first case with index 8 never does.
    while not (tmp_path / "25.csv").exists():
        assert process.poll() is None
        time.sleep(0.1)
    os.killpg(process.pid, signal.SIGTERM)
    out, _ = process.communicate(timeout=60)
    assert "DONT (not executed)" in out
    verdicts = [r.attrib["verdict"] for r in ElementTree.parse(result).iter("test_result")]
    assert len(verdicts) == 55
    assert verdicts.count("PASS") >= 25 and verdicts[-1] == "DONT"


def test_a_compiler_error_is_reported_with_file_and_line(sitaf, activity):
    source = next(activity.glob("component/**/InfraredSensor.java"))
    lines = source.read_text().splitlines()
    at = next(i for i, line in enumerate(lines) if line.strip().startswith("return "))
    lines[at] = "    return nonsense;"
    source.write_text("\n".join(lines))
    run = sitaf("run", activity)
    assert run.returncode == 2
    assert re.search(rf"InfraredSensor\.java:{at + 1}:\d+: error: .*cannot find symbol", run.stderr), run.stderr


def test_an_exception_is_an_error(sitaf, activity):
    source = next(activity.glob("component/**/InfraredSensor.java"))
    text = source.read_text()
    body = re.search(r"double GetInfraredData\([^)]*\) \{", text)
    source.write_text(text[: body.end()] + " if (indexOfSensor == 2) throw new IllegalStateException(\"gone\");" + text[body.end():])
    run = sitaf("run", activity)
    assert run.returncode == 1, run.stderr
    assert re.search(r"0 FAIL, [1-9]\d* ERROR", run.stdout)
    assert "IllegalStateException" in run.stdout


def test_a_component_that_forges_results_does_not_pass(sitaf, activity, tmp_path):
    source = next(activity.glob("component/**/InfraredSensor.java"))
    text = source.read_text()
    body = re.search(r"double GetInfraredData\([^)]*\) \{", text)
    forging = (
        ' try (var results = new java.io.FileOutputStream("/dev/fd/3")) {'
        ' results.write("<case_record no=\'1\' outcome=\'RETURNED\'/>\\n".getBytes());'
        " } catch (java.io.IOException e) { throw new java.io.UncheckedIOException(e); }"
    )
    source.write_text(text[: body.end()] + forging + text[body.end() :])
    report = tmp_path / "report.xml"
    run = sitaf("run", activity, "--junit", report, "--result", tmp_path / "results")
    assert run.returncode == 1, run.stdout + run.stderr
    assert "GetInfraredData: SUSPECT, the verdicts cannot be trusted:" in run.stdout
    assert "a line without number and token" in run.stdout
    assert "55 cases, 55 PASS" in run.stdout
    assert ElementTree.parse(report).getroot().find("testsuite").attrib["errors"] == "1"
    result = ElementTree.parse(tmp_path / "results" / "GetInfraredData.xml").getroot()
    assert len(result.findall("suspicion")) == 1


def test_a_component_that_exits_affects_only_its_case(sitaf, activity):
    source = next(activity.glob("component/**/InfraredSensor.java"))
    text = source.read_text()
    body = re.search(r"double GetInfraredData\([^)]*\) \{", text)
    source.write_text(text[: body.end()] + " if (indexOfSensor == 8 && numOfSensor == 1) System.exit(7);" + text[body.end():])
    run = sitaf("run", activity)
    assert run.returncode == 1, run.stderr
    assert "55 cases, 54 PASS, 0 FAIL, 1 ERROR, 0 DONT" in run.stdout


def test_a_missing_class_is_reported_before_the_compilation(sitaf, activity):
    replace(activity / "activity.yaml", "InfraredSensor\n", "Sonar\n")
    run = sitaf("run", activity)
    assert run.returncode == 2
    assert "component.class" in run.stderr and "Sonar" in run.stderr


def test_an_unknown_world_parameter_is_reported(sitaf, activity):
    replace(activity / "GetInfraredData.xml", "<name>Distance</name>", "<name>Gap</name>")
    run = sitaf("run", activity)
    assert run.returncode == 2
    assert "test_element Gap: world/ir.world.yaml has no such parameter; it has Distance" in run.stderr


def test_a_world_rejected_by_the_simulator_is_reported(sitaf, activity):
    replace(activity / "world" / "ir.xml", "<mujoco", "<mujoko")
    run = sitaf("run", activity)
    assert run.returncode == 2
    assert "the simulator rejects the world" in run.stderr


def test_an_unknown_method_is_reported(sitaf, activity):
    replace(activity / "GetInfraredData.xml", 'method="GetInfraredData"', 'method="GetSonarData"')
    run = sitaf("run", activity)
    assert run.returncode == 2
    assert "no method GetSonarData" in run.stderr


def test_what_the_command_loads_is_archived(sitaf, tmp_path):
    folder, loaded = sitaf.root / ".sitaf" / "dist" / "cli", tmp_path / "loaded"
    # The launcher turns the JVM's log off.
    run = subprocess.run(
        ["java", f"-XX:SharedArchiveFile={folder / 'cli.jsa'}", f"-Xlog:class+load:file={loaded}", "-XX:TieredStopAtLevel=1",
         f"-Dsitaf.home={sitaf.root}", "-jar", folder / "cli.jar", "run", sitaf.root / "examples" / "ir-sensor"],
        capture_output=True, text=True, check=False,
    )
    assert run.returncode == 0, run.stdout + run.stderr
    channel = next(line for line in loaded.read_text().splitlines() if "netty.NettyChannelBuilder " in line)
    assert "shared objects file (top)" in channel
