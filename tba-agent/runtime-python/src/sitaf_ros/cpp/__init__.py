"""ROS 2 nodes in C++: builds them as a library, and runs cases with it in place of Python's nodes."""
