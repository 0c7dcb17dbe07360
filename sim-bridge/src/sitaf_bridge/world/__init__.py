"""Worlds: their description, their physics in MuJoCo, their parameters and devices."""
