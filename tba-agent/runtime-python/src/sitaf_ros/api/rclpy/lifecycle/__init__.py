"""Lifecycle nodes; see https://design.ros2.org/articles/node_lifecycle.html."""

from .managed_entity import ManagedEntity, SimpleManagedEntity
from .node import LifecycleNode, LifecycleNodeMixin
from .node import LifecycleNode as Node
from .publisher import LifecyclePublisher
from .publisher import LifecyclePublisher as Publisher
from .states import LifecycleState, TransitionCallbackReturn
from .states import LifecycleState as State

__all__ = [
    "LifecycleNode",
    "LifecycleNodeMixin",
    "LifecyclePublisher",
    "LifecycleState",
    "ManagedEntity",
    "Node",
    "Publisher",
    "SimpleManagedEntity",
    "State",
    "TransitionCallbackReturn",
]
