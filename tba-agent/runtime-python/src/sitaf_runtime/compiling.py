"""Compiles the sources of test applications: `python -m sitaf_runtime.compiling FOLDER...`.

Compile errors are printed, one per line: path, line, column and message, separated by tabs. No code of the sources
runs.
"""

import os
import py_compile
import sys
import warnings
from collections.abc import Iterator


def main() -> None:
    """Compile all modules in the folders. Exits with 1 when one of them has an error."""
    warnings.simplefilter("ignore")
    errors = [error for folder in sys.argv[1:] for path in _modules(folder) for error in _errors(path)]
    sys.stdout.reconfigure(encoding="utf-8", errors="backslashreplace")  # pyright: ignore[reportAttributeAccessIssue]
    for path, line, column, message in errors:
        text = " ".join(message.split())
        sys.stdout.write(f"{path}\t{line}\t{column}\t{text}\n")
    sys.exit(1 if errors else 0)


def _modules(folder: str) -> Iterator[str]:
    for parent, _, names in sorted(os.walk(folder)):
        for name in sorted(names):
            if name.endswith(".py"):
                yield os.path.join(parent, name)


def _errors(path: str) -> Iterator[tuple[str, int, int, str]]:
    try:
        # Not checked by time stamp, so that the compiled file stays valid when it is moved with its source.
        py_compile.compile(path, doraise=True, invalidation_mode=py_compile.PycInvalidationMode.UNCHECKED_HASH)
    except py_compile.PyCompileError as e:
        error = e.exc_value
        if isinstance(error, SyntaxError):
            yield path, error.lineno or 0, max(0, error.offset or 0), error.msg
        else:
            yield path, 0, 0, f"{type(error).__name__}: {error}"
    except (ValueError, RecursionError, MemoryError, OverflowError) as e:
        yield path, 0, 0, f"{type(e).__name__}: {e}"


if __name__ == "__main__":
    main()
