"""Test applications."""
