"""Reading test cases and writing records of results."""
