"""From what is true to what a device reads: noise, delay and faults."""
