"""Commands that need no component."""

import csv
import io
import json
import os
import re
import shutil
from pathlib import Path

MODEL = "examples/ir-sensor/GetInfraredData.xml"
GOLDEN = Path(__file__).parents[1] / "golden"


def test_the_papers_suite_equals_the_golden_file(sitaf):
    generated = sitaf("generate", MODEL)
    assert generated.returncode == 0, generated.stderr
    assert generated.stdout == (GOLDEN / "GetInfraredData-2way.xml").read_text()


def test_every_format_contains_all_cases(sitaf):
    rows = list(csv.DictReader(io.StringIO(sitaf("generate", MODEL, "--format", "csv").stdout)))
    assert len(rows) == 55
    assert rows[0].keys() == {"no", "class", "IndexOfSensor", "NumOfSensor", "Distance", "expected"}
    suite = json.loads(sitaf("generate", MODEL, "--format", "json", "--invalid", "combine").stdout)
    assert len(suite["cases"]) == 49


def test_strength_all_gives_all_combinations(sitaf):
    suite = json.loads(sitaf("generate", MODEL, "--format", "json", "--strength", "all", "--invalid", "combine").stdout)
    assert len(suite["cases"]) == 7 * 7 * 7


def test_an_invalid_model_exits_with_2_and_lists_all_errors(sitaf, tmp_path):
    model = tmp_path / "bad.xml"
    model.write_text(
        "<test_model><name>Bad</name><input_spec_list>\n"
        "<test_element abstract_type='NUMERIC' real_type='int'><name>A</name><type>TDI</type>\n"
        "<test_spec type='BVA' offset='-1'><equiv_class type='NEC_NUMERIC_TWO_BOUNDARY' min='7' max='1'/></test_spec>\n"
        "</test_element></input_spec_list><order_of_combinations>2</order_of_combinations></test_model>"
    )
    generated = sitaf("generate", model)
    assert generated.returncode == 2
    assert generated.stdout == ""
    assert f"{model}:3: error: test_element A/test_spec/equiv_class: min 7 is above max 1" in generated.stderr
    assert f"{model}:3: error: test_element A/test_spec/offset: must be greater than 0, not -1" in generated.stderr


def test_the_folder_of_an_activity_with_one_model_stands_for_its_model(sitaf):
    generated = sitaf("generate", "examples/ir-sensor")
    assert generated.returncode == 0, generated.stderr
    assert generated.stdout == sitaf("generate", MODEL).stdout


def test_a_folder_with_several_models_or_none_is_refused(sitaf, tmp_path):
    several = sitaf("generate", "examples/wrist-kinematics")
    assert several.returncode == 2
    assert "has several test models; name one of examples/wrist-kinematics/Reach.xml, " in several.stderr

    none = sitaf("generate", tmp_path)
    assert none.returncode == 2
    assert f"{tmp_path}: error: is a folder without activity.yaml; name a test model" in none.stderr


def test_a_document_type_is_refused(sitaf, tmp_path):
    model = tmp_path / "hostile.xml"
    model.write_text("<!DOCTYPE test_model SYSTEM 'file:///etc/passwd'><test_model/>")
    generated = sitaf("generate", model)
    assert generated.returncode == 2
    assert "document type declarations and entities are not allowed" in generated.stderr


def test_describe_prints_the_interface(sitaf):
    described = sitaf("describe", "examples/ir-sensor/InfraredSensorService.xml")
    assert described.returncode == 0, described.stderr
    assert "GetInfraredData" in described.stdout


def test_every_command_knows_the_version(sitaf):
    released = re.search(r"^  <version>(.*?)</version>", (Path(__file__).parents[2] / "pom.xml").read_text(), re.M)
    for command in ((), ("run",), ("describe",)):
        asked = sitaf(*command, "--version")
        assert (asked.returncode, asked.stdout) == (0, f"sitaf {released[1]}\n"), asked.stderr


def test_doctor_finds_all_required_software(sitaf):
    doctor = sitaf("doctor")
    assert doctor.returncode == 0, doctor.stdout
    assert "All required software is installed" in doctor.stdout
    if shutil.which("bwrap"):
        assert re.search(r"memory +(control groups v[12]|polled by the agent) ", doctor.stdout)


def test_doctor_explains_how_to_install_missing_software(sitaf, tmp_path):
    for tool in ("bash", "dirname", "readlink", "grep", "head", "sort", "python3", "flock", "date"):
        found = next(Path(p) / tool for p in os.environ["PATH"].split(":") if (Path(p) / tool).exists())
        (tmp_path / tool).symlink_to(found)
    doctor = sitaf("doctor", env={"PATH": str(tmp_path)})
    assert doctor.returncode == 1
    assert "sudo apt-get install -y openjdk-17-jdk-headless maven" in doctor.stdout


def test_an_unknown_command_exits_with_2_and_lists_the_commands(sitaf):
    unknown = sitaf("tset")
    assert unknown.returncode == 2
    assert "unknown command 'tset'" in unknown.stderr
    assert "demo" in unknown.stderr


def test_the_server_lists_its_options_instead_of_starting(sitaf):
    listed = sitaf("server", "--help")
    assert listed.returncode == 0, listed.stderr
    options = set(re.findall(r"^ +--((?:sitaf|server|spring)[\w.-]+)=", listed.stdout, re.MULTILINE))
    assert {"server.port", "spring.grpc.server.port", "sitaf.data-directory"} <= options
    assert "SITAF_DATABASE_URL" in listed.stdout
    documented = (sitaf.root / "itaes-server/app/README.md").read_text() + (sitaf.root / "docs/security.md").read_text()
    documented += (sitaf.root / "docs/deployment.md").read_text()
    assert {option for option in options if option not in documented} == set()
