"""The test application of one test model."""
