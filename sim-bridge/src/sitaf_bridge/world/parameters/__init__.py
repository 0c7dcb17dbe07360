"""What a test may vary: the quantities that can be set, and gaps that are solved."""
