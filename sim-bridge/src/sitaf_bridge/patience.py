"""Takes only what nobody else needs of the processor, while a bridge starts ahead of the build that will use it.

Linux shares the processor among sessions (sched_autogroup) before it does among processes. A bridge in a session of its
own may lower its session's share and raise it again without any right. Elsewhere this does nothing.
"""

import contextlib
import os
import threading
import time
from pathlib import Path

AUTOGROUP = Path("/proc/self/autogroup")
FIRST_PROCESS = Path("/proc/1/comm")
TRIES = 50
PAUSE_S = 0.11


def give_way() -> None:
    """Leave the processor to others."""
    _share(19, 1)


def be_prompt() -> None:
    """Have a share as everybody else, from a moment later on."""
    threading.Thread(target=_share, args=(0, TRIES), name="be-prompt", daemon=True).start()


def _share(nice: int, tries: int) -> None:
    with contextlib.suppress(OSError):
        # The session of somebody else is not to be slowed down; that of a sandbox begins with its first process.
        leader = os.getsid(0)
        if leader != os.getpid() and not (leader == 1 and FIRST_PROCESS.read_text().strip() == "bwrap"):
            return
    for _ in range(tries):
        try:
            AUTOGROUP.write_text(str(nice))
        except BlockingIOError:
            # The kernel takes ten such changes a second, of all sessions together.
            time.sleep(PAUSE_S)
        except OSError:
            return
        else:
            return
