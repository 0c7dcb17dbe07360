"""Starts a test application: `python -m sitaf_runtime MODULE ARGUMENTS`.

The module contains the class ConcreteTestDriver. A component that cannot be imported is reported here, before any case.
"""

import importlib
import os
import re
import sys
import traceback

from sitaf_runtime import debugging
from sitaf_runtime.errors import CannotRunError
from sitaf_runtime.run import cannot_run, end, start
from sitaf_runtime.suite import channel
from sitaf_runtime.thrown import describe, is_the_users

_NAMED = 10
_RUNTIME = os.path.dirname(os.path.abspath(__file__))
# The agent's module path. It is not in PYTHONPATH, because these modules could then replace those of the runtime.
_PATH = "SITAF_PYTHONPATH"


def _is_missing_here(raised: ModuleNotFoundError) -> bool:
    """Whether a module of the runtime, or one that the runtime imports, is missing."""
    importing = [frame.filename for frame in traceback.extract_tb(raised.__traceback__)]
    importing = [name for name in importing if not name.startswith("<frozen")]
    by_runtime = bool(importing) and os.path.dirname(importing[-1]).startswith(_RUNTIME)
    root = (raised.name or "").partition(".")[0]
    return root == "sitaf_runtime" or (by_runtime and os.path.basename(importing[-1]) != "__main__.py")


def _missing_component(raised: BaseException) -> str | None:
    """The message when the component's module or class is missing; None for errors in the component's own imports."""
    if any(is_the_users(frame.filename) for frame in traceback.extract_tb(raised.__traceback__)):
        return None
    if isinstance(raised, ModuleNotFoundError):
        if _is_missing_here(raised):
            return (
                f"the runtime of Python tests is incomplete: it has no module {raised.name};"
                " install the agent with its runtime folders, or run ./sitaf test once in a source tree"
            )
        return f"there is no module {raised.name}: component.class in activity.yaml names the module, then the class"
    missing = re.match(r"cannot import name '(\w+)' from '([\w.]+)'", str(raised))
    if not isinstance(raised, ImportError) or missing is None:
        return None
    members = vars(sys.modules.get(missing[2])) if missing[2] in sys.modules else {}
    classes = [name for name, value in members.items() if isinstance(value, type) and not name.startswith("_")]
    return (
        f"{missing[2]} has no class {missing[1]}; it has {', '.join(classes[:_NAMED]) or 'no class'}:"
        " name one of its classes as component.class in activity.yaml"
    )


def _extend_path() -> None:
    """Add the modules of the test application to the path of this process and of its child processes."""
    path = os.environ.pop(_PATH, "")
    if path:
        os.environ["PYTHONPATH"] = path
        sys.path[:0] = path.split(os.pathsep)


def main() -> None:
    """Import the test application and run it."""
    if len(sys.argv) < 2:
        end(cannot_run("usage: python -m sitaf_runtime MODULE ARGUMENTS"))
    name = sys.argv[1]
    try:
        channel.hold(sys.argv[2:])
        debugging.wait_for_debugger()
        _extend_path()
        driver = importlib.import_module(name).ConcreteTestDriver
    except CannotRunError as e:
        end(cannot_run(str(e)))
    except BaseException as e:
        end(cannot_run(_missing_component(e) or f"the test application cannot be imported: {describe(e)}"))
    start(driver, sys.argv[2:])


main()
