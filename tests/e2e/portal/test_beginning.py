"""Activities that begin with a proposal: from an interface, and from a ROS 2 package."""

import re

import pytest

from portal.browsing import ROOT, expect, home_of, serious, shot, zipped

SCALE = "uint8 FAST=1\nuint8 mode\nown_msgs/Limits limits\n---\nbool accepted\nfloat64 scaled\n"
NODE = """import rclpy
from rclpy.node import Node
from std_msgs.msg import Float64

class Talker(Node):
    def __init__(self):
        super().__init__("talker")
        self.create_publisher(Float64, "/speed", 10)

class Listener(Node):
    def __init__(self):
        super().__init__("listener")
        self.create_subscription(Float64, "/speed", print, 10)
"""


@pytest.fixture
def begin(page):
    """Opens the page and chooses how to begin, with the keyboard."""

    def opened(beginning, name):
        page.goto(home_of(page) + "/activities/new")
        choice = page.get_by_role("radio", name=beginning)
        choice.focus()
        choice.press("Space")
        page.get_by_label("Name of the activity").fill(name)

    return opened


def propose(page):
    page.get_by_role("button", name="Propose activity").press("Enter")
    page.get_by_role("region", name="Proposed activity").wait_for()


def create(page):
    page.get_by_role("button", name="Create activity").press("Enter")
    page.get_by_role("tab", name="Tests").wait_for()


def paths(page, name):
    return page.get_by_role("list", name=name).get_by_role("listitem").all_inner_texts()


def test_an_activity_from_an_interface_passes_at_once(page, begin):
    begin("A new component", "begun")
    page.get_by_label("Files: Interface files").set_input_files(
        {
            "name": "own_msgs.zip",
            "mimeType": "application/zip",
            "buffer": zipped({"own_msgs/srv/Scale.srv": SCALE, "own_msgs/msg/Limits.msg": "float64 max_speed\n"}),
        }
    )
    page.get_by_role("list", name="Interface files: 2 files").wait_for()
    propose(page)
    assert paths(page, "3 proposed files") == ["Scale.xml", "activity.yaml", "component/component.py"]
    assert paths(page, "2 files taken over") == ["own_msgs/msg/Limits.msg", "own_msgs/srv/Scale.srv"]
    shot(page, "proposal")
    assert serious(page) == []
    page.set_viewport_size({"width": 390, "height": 844})
    try:
        assert page.evaluate("document.documentElement.scrollWidth") <= 390
    finally:
        page.set_viewport_size({"width": 1280, "height": 900})
    create(page)
    page.get_by_role("link", name="Edit Scale").wait_for()
    page.get_by_role("button", name="Build now").click()
    page.get_by_role("heading", name="Result", exact=True).wait_for()
    answer = page.request.get(page.url.split("?")[0].replace("/builds/", "/api/v1/builds/") + "/result")
    verdicts = answer.json()["summary"]
    assert verdicts["pass"] > 0
    assert verdicts["pass"] == verdicts["total"]


def test_an_interface_of_ros_is_proposed_and_a_wrong_name_explained(page, begin):
    begin("A new component", "begun")
    page.get_by_text("ROS 2", exact=True).click()
    page.get_by_label("Interface of ROS 2").fill("nav_msgs/srv/GetPlann.srv")
    page.get_by_role("button", name="Propose activity").press("Enter")
    expect(page.get_by_role("alert", name="No activity was proposed")).to_contain_text(
        "nav_msgs/srv/GetPlann.srv: is neither a given file nor an installed interface of ROS 2"
    )
    page.get_by_label("Interface of ROS 2").fill("sensor_msgs/srv/SetCameraInfo.srv")
    propose(page)
    assert "SetCameraInfo.xml" in paths(page, re.compile("proposed files"))
    expect(page.get_by_role("list", name=re.compile("taken over"))).to_have_count(0)


def test_an_activity_of_a_ros_package_is_created(page, begin):
    begin("A ROS 2 package", "wall-stop-begun")
    page.get_by_label("Folder: ROS 2 package").set_input_files(ROOT / "examples" / "wall-stop-ros" / "src" / "wall_stop")
    page.get_by_role("list", name="ROS 2 package: ").wait_for()
    propose(page)
    assert "Topics.xml" in paths(page, "2 proposed files")
    create(page)
    page.get_by_role("link", name="Edit Topics").wait_for()
    page.get_by_role("heading", name="wall-stop-begun", level=1).wait_for()


def test_one_of_several_nodes_is_chosen(page, begin):
    begin("A ROS 2 package", "listener")
    page.get_by_label("Files: ROS 2 package").set_input_files(
        {
            "name": "pair.zip",
            "mimeType": "application/zip",
            "buffer": zipped({"pair/package.xml": "<package><name>pair</name></package>", "pair/pair/nodes.py": NODE}),
        }
    )
    page.get_by_role("list", name="ROS 2 package: 2 files").wait_for()
    page.get_by_role("button", name="Propose activity").press("Enter")
    page.get_by_label("Node", exact=True).select_option("pair.nodes:Listener")
    propose(page)
    create(page)
    page.get_by_role("heading", name="listener", level=1).wait_for()
