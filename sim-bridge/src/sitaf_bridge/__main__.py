"""Entry of `python -m sitaf_bridge`.

Imports are inside of the guard, because the processes that compile worlds import this module again.
"""

if __name__ == "__main__":
    import os
    import sys

    # Otherwise MuJoCo loads GLFW, which starts another interpreter; cameras have contexts of their own.
    os.environ["MUJOCO_GL"] = "disable"

    from sitaf_bridge.commands import main

    sys.exit(main())
