"""Chooses between velocity commands."""
