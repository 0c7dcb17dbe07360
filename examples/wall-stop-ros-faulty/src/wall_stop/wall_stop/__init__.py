"""Stops a base before a wall."""
