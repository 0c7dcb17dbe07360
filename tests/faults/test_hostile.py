"""Runs the short form of the hostile program: no component escapes or affects other users' builds."""

import os
import pwd
import subprocess

import pytest
from needs import sandbox

pytestmark = sandbox

ORDINARY = "nobody"

# One attack per kind of escape and limit that needs no C++, of which the agent must first compile the runtime. The limits of
# memory have a table of their own among the agent's tests.
REPRESENTATIVES = (
    "reads-agent-key,memory-direct,forges-results,writes-outside,network-local,user-namespaces,fork-bomb,orphans,much-disk,"
    "floods-results,hangs"
)


def ran(installed, *arguments):
    done = installed("bench", "hostile", "--only", "components", *arguments)
    assert done.returncode == 0, done.stdout + done.stderr[-8000:]
    assert done.stdout.splitlines()[-1] == "hostile: held"


def test_hostile_components_do_not_escape(installed):
    ran(installed, "--short", "--languages", "java,python", "--kinds", REPRESENTATIVES)


@pytest.mark.long
def test_hostile_components_of_all_languages_do_not_escape(installed):
    ran(installed, "--short")


def test_hostile_components_do_not_escape_from_an_unprivileged_agent(installed):
    if os.getuid() != 0:
        pytest.skip("the agent of the other tests is an ordinary user's already")
    try:
        user = pwd.getpwnam(ORDINARY)
    except KeyError:
        pytest.skip(f"there is no user {ORDINARY}")
    python = installed.root / ".sitaf" / "venv" / "bin" / "python"
    tried = subprocess.run([python, "-c", "import sitaf_bridge"], user=user.pw_uid, group=user.pw_gid, extra_groups=[],
                           cwd="/", capture_output=True, check=False) if can_enter(installed.root, user) else None
    if tried is None or tried.returncode != 0:
        pytest.skip(f"{ORDINARY} cannot start the simulation of {installed.root}")
    ran(installed, "--user", ORDINARY, "--languages", "python", "--kinds",
        "reads-agent-key,memory-dev-shm,memory-shared,closed-folders,user-namespaces,fork-bomb")


def can_enter(folder, user):
    """Whether a user can run the simulation's Python, which may be in another user's folder."""
    python = folder / ".sitaf" / "venv" / "bin" / "python"
    found = subprocess.run(["test", "-x", python], user=user.pw_uid, group=user.pw_gid, extra_groups=[], check=False)
    return found.returncode == 0
