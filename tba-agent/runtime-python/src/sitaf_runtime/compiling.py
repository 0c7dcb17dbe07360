"""Compiles the sources of test applications: `python -m sitaf_runtime.compiling FOLDER...`.

What cannot be compiled is printed, one line each: path, line, column and message, with tabs between. No code
of the sources runs.
"""

import os
import py_compile
import sys
import warnings
from collections.abc import Iterator


def main() -> None:
    """Compile every module below the folders. Ends with 1 when one of them has a mistake."""
    warnings.simplefilter("ignore")
    mistakes = [mistake for folder in sys.argv[1:] for path in _modules(folder) for mistake in _mistakes(path)]
    sys.stdout.reconfigure(encoding="utf-8", errors="backslashreplace")  # pyright: ignore[reportAttributeAccessIssue]
    for path, line, column, message in mistakes:
        text = " ".join(message.split())
        sys.stdout.write(f"{path}\t{line}\t{column}\t{text}\n")
    sys.exit(1 if mistakes else 0)


def _modules(folder: str) -> Iterator[str]:
    for parent, _, names in sorted(os.walk(folder)):
        for name in sorted(names):
            if name.endswith(".py"):
                yield os.path.join(parent, name)


def _mistakes(path: str) -> Iterator[tuple[str, int, int, str]]:
    try:
        # The compiled file goes with the source wherever both are moved.
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
