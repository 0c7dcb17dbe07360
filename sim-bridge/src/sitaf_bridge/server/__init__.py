"""The gRPC server: wire messages in, wire messages out, no simulation of its own."""
