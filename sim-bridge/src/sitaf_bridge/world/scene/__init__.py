"""Worlds and motions as binary glTF, for others to draw."""
