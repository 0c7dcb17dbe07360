"""Real and recorded devices in place of simulated ones. Needs the package `sitaf_hardware`."""
