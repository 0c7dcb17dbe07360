"""The gRPC server: converts messages and calls sessions; contains no simulation code."""
