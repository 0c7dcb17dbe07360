"""Noise, delay and faults of devices."""
