"""Rays, insides and bounds of geoms, where MuJoCo leaves them open."""
