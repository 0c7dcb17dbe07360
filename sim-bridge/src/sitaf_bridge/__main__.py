"""Entry of `python -m sitaf_bridge`.

Imports are inside of the guard, because the processes that compile worlds import this module again.
"""

if __name__ == "__main__":
    import sys

    from sitaf_bridge.commands import main

    sys.exit(main())
