"""Parts of rclpy that nodes import by name."""
