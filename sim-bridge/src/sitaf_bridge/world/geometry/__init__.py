"""Geometry that MuJoCo does not provide: rays, inside tests and bounds of geoms."""
