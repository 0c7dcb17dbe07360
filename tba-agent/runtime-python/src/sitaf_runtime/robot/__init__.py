"""The robot's hardware as a component sees it, with the data of `sensor_msgs` in SI units."""
