"""Parameters of tests: settable quantities, and gaps that are solved."""
