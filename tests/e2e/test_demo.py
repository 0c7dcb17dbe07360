"""The paper's evaluation with the complete system."""

import json
import re
import signal
import subprocess
import tempfile
import urllib.error
import urllib.request
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest


@pytest.fixture(scope="module")
def demo(sitaf):
    return sitaf("demo")


def test_every_case_of_the_paper_passes(demo):
    assert demo.returncode == 0, demo.stderr
    assert "Generated 55 test cases: 25 valid, 30 with an invalid value" in demo.stdout
    assert "GetInfraredData: 55 cases, 55 PASS, 0 FAIL, 0 ERROR, 0 DONT" in demo.stdout
    assert "Generated 49 test cases" in demo.stdout
    assert "GetInfraredData: 49 cases, 49 PASS, 0 FAIL, 0 ERROR, 0 DONT" in demo.stdout


def test_the_table_equals_the_papers(demo):
    header = r"No +IndexOfSensor +NumOfSensor +Distance +ER +MR +PF +Time\(us\)"
    assert re.search(header, demo.stdout)
    row = r"^ *(\d+) +(-?\d+) +(-?\d+) +(-?[\d.]+) +(-?[\d.]+) +(-?[\d.]+) +PASS +[\d.]+$"
    rows = re.findall(row, demo.stdout, re.MULTILINE)
    assert [int(r[0]) for r in rows] == list(range(1, 56))
    for _, index, count, distance, expected, measured in rows:
        valid = 1 <= int(index) <= 7 and 1 <= int(count) <= 7 and 0 <= float(distance) <= 10
        answer = float(distance) if valid and int(index) <= int(count) else -1.0
        assert float(expected) == answer
        assert float(measured) == pytest.approx(answer, abs=1e-9)
    assert re.search(r"min [\d.]+, max [\d.]+, average [\d.]+, standard deviation [\d.]+", demo.stdout)


def test_the_demo_prints_the_path_of_the_result_document(demo, sitaf):
    path = re.search(r"Results as XML: (\S+)", demo.stdout).group(1)
    root = ElementTree.parse(path).getroot()
    assert root.tag == "test_result_descriptor"
    assert root.find("summary").attrib["pass"] == "55"
    assert len(root.findall("test_result_list/test_result")) == 55
    provenance = root.find("provenance").attrib
    assert re.fullmatch(r"[0-9a-f]{64}", provenance["component"])
    assert "MuJoCo" in provenance["bridge"]


def test_the_demo_leaves_no_processes(demo):
    processes = subprocess.run(["ps", "-eo", "args"], capture_output=True, text=True, check=True)
    assert "sitaf-demo-" not in processes.stdout


def test_a_kept_demo_shows_the_portal_and_cleans_up(sitaf):
    before = set(Path(tempfile.gettempdir()).glob("sitaf-demo-*"))
    kept = subprocess.Popen([sitaf.root / "sitaf", "demo", "--keep"], stdout=subprocess.PIPE, text=True)
    try:
        address = next(
            found.group(1) for line in kept.stdout if (found := re.search(r"The portal is at (http://\S+)", line))
        )
        link = next(
            found.group(1) for line in kept.stdout if (found := re.search(r"Sign in with this link, valid once: (\S+)", line))
        )
        browser = urllib.request.build_opener(urllib.request.HTTPCookieProcessor())
        with browser.open(link) as page:
            html = page.read().decode()
        script = re.search(r'<script[^>]* src="([^"]+)"', html).group(1)
        with browser.open(address + script) as loaded:
            assert "javascript" in loaded.headers["Content-Type"]
        with pytest.raises(urllib.error.HTTPError, match="401"):
            urllib.request.urlopen(address + "/api/v1/builds")
        with browser.open(address + "/api/v1/builds") as builds:
            states = [build["state"] for build in json.load(builds)["items"]]
        assert states == ["DONE", "DONE"]
    finally:
        # Processes in the background of a shell ignore SIGINT.
        kept.send_signal(signal.SIGTERM)
        assert kept.wait(timeout=60) in (0, 143)
    assert set(Path(tempfile.gettempdir()).glob("sitaf-demo-*")) == before
    processes = subprocess.run(["ps", "-eo", "args"], capture_output=True, text=True, check=True)
    assert address.rsplit(":", 1)[1] not in processes.stdout
    assert "sitaf-demo-" not in processes.stdout
