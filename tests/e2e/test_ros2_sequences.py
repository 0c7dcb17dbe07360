"""Sequences of calls of ROS 2 nodes: a managed node in Python and C++, messages over steps, errors and refusals."""

import re
import shutil
import xml.etree.ElementTree as ElementTree

import pytest
from needs import cpp

EXAMPLES = ["lifecycle-node", pytest.param("lifecycle-node-cpp", marks=cpp)]


def cases_of(folder, name="LifeCycle"):
    """The results of the cases, without what differs between runs."""
    result = ElementTree.parse(folder / f"{name}.xml").getroot()
    for parent in list(result.iter()):
        for time in parent.findall("processing_time"):
            parent.remove(time)
    return result.findall("test_result_list/test_result")


@pytest.mark.parametrize("example", EXAMPLES)
def test_a_managed_node_passes_with_the_same_result_each_time(sitaf, tmp_path, example):
    results = []
    for name in ("once", "twice"):
        run = sitaf("run", f"examples/{example}", "--result", tmp_path / name)
        assert run.returncode == 0, run.stdout + run.stderr
        results.append(
            [ElementTree.tostring(case) for case in cases_of(tmp_path / name)]
        )
    assert results[0] == results[1]
    steps = [
        step for case in cases_of(tmp_path / "once") for step in case.findall("step")
    ]
    assert {step.get("verdict") for step in steps} == {"PASS"}
    forbidden = [step for step in steps if step.get("class") == "forbidden"]
    assert {"Configure", "Activate", "Deactivate", "Cleanup"} <= {
        step.get("name") for step in forbidden
    }
    # Time passes in a node without a world.
    assert any(float(step.get("at")) > 0 for step in steps)


def test_a_node_that_stays_active_fails_at_its_step(sitaf, tmp_path):
    run = sitaf(
        "run", "examples/lifecycle-node-faulty", "--result", tmp_path / "result"
    )
    assert run.returncode == 1, run.stdout + run.stderr
    assert re.search(
        r"FAIL in \d+ cases?: step \d+ \(TemperatureWhileInactive\): ", run.stdout
    ), run.stdout
    cases = cases_of(tmp_path / "result")
    failed = [case for case in cases if case.get("verdict") == "FAIL"]
    assert failed
    assert any(case.get("verdict") == "PASS" for case in cases)
    for case in failed:
        steps = case.findall("step")
        first = next(i for i, step in enumerate(steps) if step.get("verdict") != "PASS")
        assert "Deactivate" in [step.get("name") for step in steps[:first]]


def test_an_exception_in_a_callback_is_an_error_of_its_step(sitaf, tmp_path):
    copy = shutil.copytree(
        sitaf.root / "examples" / "lifecycle-node", tmp_path / "copy"
    )
    node = copy / "src" / "heater" / "heater" / "heater.py"
    node.write_text(
        node.read_text().replace(
            "message.data < self.target)", "message.data < self.no_target)"
        )
    )
    run = sitaf("run", copy, "--result", tmp_path / "result")
    assert run.returncode == 1, run.stdout + run.stderr
    broken = [
        case for case in cases_of(tmp_path / "result") if case.get("verdict") == "ERROR"
    ]
    assert broken
    for case in broken:
        steps = case.findall("step")
        first = next(
            i for i, step in enumerate(steps) if step.get("verdict") == "ERROR"
        )
        assert steps[first].get("name") == "Temperature"
        assert "no_target" in steps[first].findtext("message")
        assert {step.get("verdict") for step in steps[first + 1 :]} <= {"DONT"}


def test_an_order_that_overlaps_and_inputs_of_the_start_are_refused(sitaf, tmp_path):
    copy = shutil.copytree(
        sitaf.root / "examples" / "lifecycle-node", tmp_path / "copy"
    )
    model = copy / "LifeCycle.xml"
    text = model.read_text().replace(
        '<call name="State"', '<call overlap="true" name="State"'
    )
    model.write_text(text)
    run = sitaf("run", copy)
    assert run.returncode == 2, run.stdout + run.stderr
    assert 'overlap="true" is not supported for ROS 2 nodes' in run.stderr


def test_events_of_the_world_reach_the_devices_of_a_node(sitaf, tmp_path):
    copy = shutil.copytree(sitaf.root / "examples" / "wall-stop-ros", tmp_path / "copy")
    profile = (copy / "activity.yaml").read_text()
    (copy / "activity.yaml").write_text(
        re.sub(r"(?m)^models: .*$", "models: [Steps.xml]", profile)
    )

    def drive(name, guard, expected):
        return f"""<call name="{name}" method="start" run_for="0.3"><guard>{guard}</guard>
            <input_spec_list><test_element abstract_type="NUMERIC" real_type="double"><name>start.data</name>
              <type>TDI</type><user_value_list><value>0.2</value></user_value_list></test_element></input_spec_list>
            <output_spec_list><test_element abstract_type="NUMERIC" real_type="double"><name>command.linear.x</name>
              <type>OUT</type><expected>{expected}</expected></test_element></output_spec_list></call>"""

    (copy / "Steps.xml").write_text(
        f"""<test_model><name>Steps</name><target settle="0.2"/><input_spec_list/>
        <sequence_spec length="4" order="2"><state name="near" type="boolean" initial="false"/>
          {drive("Drive", "!near", "0.2")}{drive("Wait", "near", "0.0")}
          <event name="Nears" set="fault.lidar.offset" to="-5"><guard>!near</guard>
            <update state="near">true</update></event>
          <event name="Leaves" set="fault.lidar.offset" to="0"><guard>near</guard>
            <update state="near">false</update></event>
        </sequence_spec>
        <order_of_combinations>1</order_of_combinations></test_model>"""
    )
    run = sitaf("run", copy, "--result", tmp_path / "result")
    assert run.returncode == 0, run.stdout + run.stderr
    steps = [
        step
        for case in cases_of(tmp_path / "result", "Steps")
        for step in case.findall("step")
    ]
    assert {step.get("name") for step in steps} == {"Drive", "Wait", "Nears", "Leaves"}
