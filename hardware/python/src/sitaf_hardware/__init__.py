"""Serves real devices of a robot to tests of SITAF; see README.md."""

from sitaf_hardware.device import Device, DeviceError, Limits, Reading
from sitaf_hardware.provider import Provider
from sitaf_hardware.serving import serve, serving

__all__ = ["Device", "DeviceError", "Limits", "Provider", "Reading", "serve", "serving"]
