"""Worlds: their description, their physics in MuJoCo, what a test may vary and what the robot's devices read."""
