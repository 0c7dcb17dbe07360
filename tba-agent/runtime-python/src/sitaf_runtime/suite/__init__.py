"""Test cases in, result lines out, and the comparison between them."""
