"""The installation under test, and small disks that can be filled."""

import subprocess

import pytest

DISK_MIB = 64


@pytest.fixture(scope="session")
def installed(sitaf):
    """Programs and simulation in `.sitaf`, as set up by the launcher."""
    listed = sitaf("bench")
    assert listed.returncode == 0, listed.stderr
    return sitaf


@pytest.fixture
def disk(tmp_path):
    """A small tmpfs, which only root can mount."""
    folder = tmp_path / "disk"
    folder.mkdir()
    mounted = subprocess.run(
        ["mount", "-t", "tmpfs", "-o", f"size={DISK_MIB}m", "tmpfs", str(folder)], capture_output=True, check=False
    )
    if mounted.returncode != 0:
        pytest.skip("no disk of a known size can be mounted here")
    yield folder
    subprocess.run(["umount", "--lazy", str(folder)], check=True)
