"""Debugs the component with pdb, whose terminal is connected to a Unix socket.

The agent names a folder in the environment variable `SITAF_DEBUGGER`. This process listens at the socket `pdb` there
and waits for a terminal (`sitaf_runtime.debugging.terminal`) before it imports the component.
"""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sitaf_runtime.debugging.debugger import ComponentDebugger
    from sitaf_runtime.stopwatch import Stopwatch

_VARIABLE = "SITAF_DEBUGGER"
# The debugger of this process, once a terminal is connected.
_connected: list[ComponentDebugger] = []


def wait_for_debugger() -> None:
    """Wait for a terminal, unless this process is not debugged."""
    folder = os.environ.pop(_VARIABLE, None)
    if folder is not None:
        from sitaf_runtime.debugging.debugger import ComponentDebugger

        _connected.append(ComponentDebugger.connected(os.path.join(folder, "pdb")))


def stop_in_calls(stopwatch: Stopwatch) -> None:
    """Stop in the first line of the component in each measured call, unless this process is not debugged."""
    for debugger in _connected:
        stopwatch.before_call(debugger.stop_in_next_call)
