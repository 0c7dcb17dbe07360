"""Tests of ROS 2 nodes: what `plan.json` of a test application says is published, called and recorded."""
