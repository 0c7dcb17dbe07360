"""The robot's hardware as a component sees it, in shapes of `sensor_msgs` and SI units."""
