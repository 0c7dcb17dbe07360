"""Takes only what nobody else needs of the processor, while a bridge starts ahead of the build that will use it.

Linux shares the processor among sessions (sched_autogroup) before it does among processes. A bridge in a session of its
own may lower its session's share and raise it again without any right. Elsewhere this does nothing.
"""

import contextlib
import os
from pathlib import Path

AUTOGROUP = Path("/proc/self/autogroup")
FIRST_PROCESS = Path("/proc/1/comm")


def give_way() -> None:
    """Leave the processor to others."""
    _share(19)


def be_prompt() -> None:
    """Have a share as everybody else."""
    _share(0)


def _share(nice: int) -> None:
    with contextlib.suppress(OSError):
        # The session of somebody else is not to be slowed down; that of a sandbox begins with its first process.
        leader = os.getsid(0)
        if leader == os.getpid() or (leader == 1 and FIRST_PROCESS.read_text().strip() == "bwrap"):
            AUTOGROUP.write_text(str(nice))
