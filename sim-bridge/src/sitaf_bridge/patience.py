"""Takes only what nobody else needs of the processor, while a bridge starts ahead of the build that will use it.

Linux shares the processor among sessions (sched_autogroup) before it does among processes. A bridge in a session of its
own may lower its session's share and raise it again without any right. Elsewhere this does nothing.
"""

import contextlib
import os
from pathlib import Path

AUTOGROUP = Path("/proc/self/autogroup")


def give_way() -> None:
    """Leave the processor to others."""
    _share(19)


def be_prompt() -> None:
    """Have a share as everybody else."""
    _share(0)


def _share(nice: int) -> None:
    # The session of somebody else is not to be slowed down.
    if os.getsid(0) != os.getpid():
        return
    with contextlib.suppress(OSError):
        AUTOGROUP.write_text(str(nice))
