"""Proposes the world of a new activity from the file of a robot: its files, and devices for its joints and sensors."""
