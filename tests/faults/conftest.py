"""The installation that is harmed."""

import pytest


@pytest.fixture(scope="session")
def installed(sitaf):
    """Programs and simulation below `.sitaf`, as any command of the launcher leaves them."""
    listed = sitaf("bench")
    assert listed.returncode == 0, listed.stderr
    return sitaf
