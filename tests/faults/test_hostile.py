"""Hostile components in the short form of their program: none gets out, and nobody else's build notices."""

import os
import pwd

import pytest

ORDINARY = "nobody"


def ran(installed, *arguments):
    done = installed("bench", "hostile", "--only", "components", *arguments)
    assert done.returncode == 0, done.stdout + done.stderr[-8000:]
    assert done.stdout.splitlines()[-1] == "hostile: held"


def test_hostile_components_stay_where_they_were_put(installed):
    ran(installed, "--short")


def test_so_they_do_where_the_agent_is_an_ordinary_user(installed):
    if os.getuid() != 0:
        pytest.skip("the agent of the other tests is an ordinary user's already")
    try:
        pwd.getpwnam(ORDINARY)
    except KeyError:
        pytest.skip(f"there is no user {ORDINARY}")
    folder = installed.root
    while folder != folder.parent:
        if not folder.stat().st_mode & 0o001:
            pytest.skip(f"{ORDINARY} cannot read {folder}")
        folder = folder.parent
    ran(installed, "--user", ORDINARY, "--languages", "python", "--kinds",
        "reads-agent-key,memory-dev-shm,memory-shared,closed-folders,user-namespaces,fork-bomb")
