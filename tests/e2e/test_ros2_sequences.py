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


def test_a_call_sets_the_faults_of_devices_when_it_begins(sitaf, tmp_path):
    copy = shutil.copytree(sitaf.root / "examples" / "wall-stop-ros", tmp_path / "copy")
    profile = (copy / "activity.yaml").read_text()
    (copy / "activity.yaml").write_text(
        re.sub(r"(?m)^models: .*$", "models: [Steps.xml]", profile)
    )
    (copy / "Steps.xml").write_text(
        """<test_model><name>Steps</name><target settle="0.2"/><input_spec_list/>
        <sequence_spec length="4" order="2">
          <call name="Drive" method="start" run_for="0.3">
            <input_spec_list>
              <test_element abstract_type="NUMERIC" real_type="double"><name>start.data</name>
                <type>TDI</type><user_value_list><value>0.2</value></user_value_list></test_element>
              <test_element abstract_type="NUMERIC" real_type="double"><name>fault.lidar.offset</name>
                <type>TDSD</type><user_value_list><value>-5</value><value>0</value></user_value_list></test_element>
            </input_spec_list>
            <output_spec_list><test_element abstract_type="NUMERIC" real_type="double"><name>command.linear.x</name>
              <type>OUT</type><expected>fault.lidar.offset &lt; 0.0 ? 0.0 : 0.2</expected></test_element></output_spec_list>
          </call>
          <call name="Again" method="start" run_for="0.3"/>
        </sequence_spec>
        <order_of_combinations>1</order_of_combinations></test_model>"""
    )
    run = sitaf("run", copy, "--result", tmp_path / "result")
    assert run.returncode == 0, run.stdout + run.stderr
    driven = {
        (step.find("value[@name='fault.lidar.offset']").text, step.findtext("actual"))
        for case in cases_of(tmp_path / "result", "Steps")
        for step in case.findall("step")
        if step.get("name") == "Drive"
    }
    assert {(float(offset), float(speed)) for offset, speed in driven} == {
        (-5.0, 0.0),
        (0.0, 0.2),
    }


ASKING = """\
from rclpy.node import Node
from std_msgs.msg import Bool, Float64
from std_srvs.srv import Trigger


class Asking(Node):
    def __init__(self):
        super().__init__("asking")
        self._ready = self.create_client(Trigger, "/ready")
        self._answer = self.create_publisher(Bool, "/answer", 1)
        self.create_subscription(Float64, "/start", self._start, 1)

    def _start(self, _):
        self._ready.call_async(Trigger.Request()).add_done_callback(self._answered)

    def _answered(self, future):
        self._answer.publish(Bool(data=future.result().success))
"""


def test_a_call_replaces_the_answers_of_a_required_service(sitaf, tmp_path):
    folder = tmp_path / "asking"
    package = folder / "src" / "asking"
    (package / "asking").mkdir(parents=True)
    (package / "asking" / "__init__.py").touch()
    (package / "asking" / "node.py").write_text(ASKING)
    (package / "package.xml").write_text(
        "<package format='3'><name>asking</name><version>1.0.0</version><description>asks</description>"
        "<maintainer email='a@b.org'>a</maintainer><license>Apache-2.0</license>"
        "<depend>rclpy</depend><depend>std_msgs</depend><depend>std_srvs</depend></package>"
    )
    (folder / "activity.yaml").write_text(
        "name: asking\n"
        "component:\n"
        "  language: ros2-python\n"
        "  sources: src/asking\n"
        "  class: asking.node:Asking\n"
        "topics:\n"
        "  /start: {with: input.start, type: std_msgs/msg/Float64}\n"
        "  /answer: {with: output.answer, type: std_msgs/msg/Bool}\n"
        "required: [{type: std_srvs/srv/Trigger.srv, name: /ready}]\n"
        "models: [Asking.xml]\n"
    )
    (folder / "Asking.xml").write_text(
        """<test_model><name>Asking</name><target/><input_spec_list/>
        <sequence_spec length="5" order="2">
          <state name="ready" type="boolean" initial="false"/>
          <call name="Start" method="start" run_for="0.1">
            <update state="ready">std_srvs.Trigger.success</update>
            <input_spec_list>
              <test_element abstract_type="BOOLEAN" real_type="boolean"><name>std_srvs.Trigger.success</name>
                <type>TDTS</type><user_value_list><value>true</value><value>false</value></user_value_list></test_element>
            </input_spec_list>
            <output_spec_list><test_element abstract_type="BOOLEAN" real_type="boolean"><name>answer.data</name>
              <type>OUT</type><expected>std_srvs.Trigger.success</expected></test_element></output_spec_list>
          </call>
          <call name="StartReady" method="start" run_for="0.1"><guard>ready</guard>
            <output_spec_list><test_element abstract_type="BOOLEAN" real_type="boolean"><name>answer.data</name>
              <type>OUT</type><expected>true</expected></test_element></output_spec_list>
          </call>
          <call name="StartUnready" method="start" run_for="0.1"><guard>!ready</guard>
            <output_spec_list><test_element abstract_type="BOOLEAN" real_type="boolean"><name>answer.data</name>
              <type>OUT</type><expected>false</expected></test_element></output_spec_list>
          </call>
        </sequence_spec>
        <order_of_combinations>1</order_of_combinations></test_model>"""
    )
    run = sitaf("run", folder, "--result", tmp_path / "result")
    assert run.returncode == 0, run.stdout + run.stderr
    steps = [
        step
        for case in cases_of(tmp_path / "result", "Asking")
        for step in case.findall("step")
    ]
    # Calls without an answer of their own get the one of the call before.
    assert {
        (name, step.findtext("actual")) for step in steps if (name := step.get("name"))
    } == {
        ("Start", "true"),
        ("Start", "false"),
        ("StartReady", "true"),
        ("StartUnready", "false"),
    }
