"""Starts a test application: `python -m sitaf_runtime MODULE ARGUMENTS`.

The module holds the class ConcreteTestDriver. A component that cannot be imported is told here, before any case.
"""

import importlib
import sys

from sitaf_runtime.errors import CannotRunError
from sitaf_runtime.run import cannot_run, end, start
from sitaf_runtime.thrown import describe


def main() -> None:
    """Import the test application and run it."""
    if len(sys.argv) < 2:
        end(cannot_run("usage: python -m sitaf_runtime MODULE ARGUMENTS"))
    name = sys.argv[1]
    try:
        driver = importlib.import_module(name).ConcreteTestDriver
    except CannotRunError as e:
        end(cannot_run(str(e)))
    except BaseException as e:
        end(cannot_run(f"the test application cannot be imported: {describe(e)}"))
    start(driver, sys.argv[2:])


main()
