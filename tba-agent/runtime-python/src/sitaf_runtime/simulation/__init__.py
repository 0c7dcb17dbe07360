"""The client of the robot simulator; no type of its wire leaves this package."""
