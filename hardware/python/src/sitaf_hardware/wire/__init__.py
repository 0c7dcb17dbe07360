"""The messages and stubs of `sitaf/hardware/v1`, generated when the package is built."""
