"""Runs unchanged ROS 2 nodes in Python without ROS, over simulated time."""

from sitaf_ros.action_test import ActionAnswer
from sitaf_ros.application import RosApplication
from sitaf_ros.definitions import DefinitionError, MessageTypes, TypeFolders
from sitaf_ros.errors import NodeError, RosLoadError
from sitaf_ros.settings import RosSettings
from sitaf_ros.system import NodeView, RosSystem, TopicView
from sitaf_ros.test_side import Delayed
from sitaf_ros.unobserved import RosReport

__all__ = [
    "ActionAnswer",
    "DefinitionError",
    "Delayed",
    "MessageTypes",
    "NodeError",
    "NodeView",
    "RosApplication",
    "RosLoadError",
    "RosReport",
    "RosSettings",
    "RosSystem",
    "TopicView",
    "TypeFolders",
]
