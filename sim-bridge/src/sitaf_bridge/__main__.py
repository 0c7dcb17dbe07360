"""Entry of `python -m sitaf_bridge`.

Nothing is imported outside the guard: the processes that compile worlds import this module again.
"""

if __name__ == "__main__":
    import sys

    from sitaf_bridge.commands import main

    sys.exit(main())
