"""The messages and services of `sitaf/sim/v1`."""
