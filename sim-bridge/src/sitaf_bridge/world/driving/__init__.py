"""Worlds in motion: where time moves, parameters take effect, and states are kept and put back."""
