"""Runs nodes with the ROS 2 that is installed on the machine (`--ros system`).

The node and the test application are in one process. Time passes in real time, because sleeps and wall timers of the
node do; ROS time is `/clock`, which the test application publishes.
"""
