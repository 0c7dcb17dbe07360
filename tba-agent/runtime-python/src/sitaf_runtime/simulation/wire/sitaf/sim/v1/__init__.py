"""The messages of `sitaf/sim/v1`, generated from the project's proto files when the package is built."""
