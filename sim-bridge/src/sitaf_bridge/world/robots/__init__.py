"""Robots of a world: from files of the world or of an installed package, as URDF, xacro or MJCF."""
