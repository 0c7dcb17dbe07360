"""The client of the robot simulator. Protocol messages are not used outside of this package."""
