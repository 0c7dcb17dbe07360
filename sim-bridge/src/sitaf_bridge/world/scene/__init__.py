"""Exports worlds and motions as binary glTF."""
