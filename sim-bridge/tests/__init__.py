"""Tests of the bridge: most of them talk to a real server over loopback, as its clients do."""
