"""Debugs the component with pdb, whose terminal is connected to a Unix socket, or with debugpy.

The agent names a folder in the environment variable `SITAF_DEBUGGER`. This process listens at the socket `pdb` there
and waits for a terminal (`sitaf_runtime.debugging.terminal`) before it imports the component. With
`SITAF_DEBUGGER_PORT`, and if the component's environment has debugpy, an IDE may attach to that port instead; the file
`debugpy` in the folder says so.
"""

from __future__ import annotations

import os
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from sitaf_runtime.debugging.debugger import ComponentDebugger
    from sitaf_runtime.stopwatch import Stopwatch

_VARIABLE = "SITAF_DEBUGGER"
_PORT_VARIABLE = "SITAF_DEBUGGER_PORT"
# The debugger of this process, once a terminal is connected.
_connected: list[ComponentDebugger] = []


def wait_for_debugger() -> None:
    """Wait for a terminal or an IDE, unless this process is not debugged."""
    folder, port = os.environ.pop(_VARIABLE, None), os.environ.pop(_PORT_VARIABLE, None)
    if folder is not None:
        from sitaf_runtime.debugging.debugger import ComponentDebugger

        debugpy = None if port is None else _listening(Path(folder), int(port))
        attached = (lambda: False) if debugpy is None else debugpy.is_client_connected
        debugger = ComponentDebugger.connected(os.path.join(folder, "pdb"), attached)
        if debugger is not None:
            _connected.append(debugger)
        elif debugpy is not None:
            # Until the IDE has set its breakpoints.
            debugpy.wait_for_client()


def _listening(folder: Path, port: int) -> Any:
    """Let debugpy listen; None if the component's environment does not have it."""
    if find_spec("debugpy") is None:
        return None
    import debugpy  # pyright: ignore[reportMissingImports]

    debugpy.listen(("127.0.0.1", port))
    (folder / "debugpy").touch()
    return debugpy


def stop_in_calls(stopwatch: Stopwatch) -> None:
    """Stop in the first line of the component in each measured call, unless this process is not debugged."""
    for debugger in _connected:
        stopwatch.before_call(debugger.stop_in_next_call)
