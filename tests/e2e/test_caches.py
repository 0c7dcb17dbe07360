"""What an agent keeps of what it compiled is never stale: the benchmark of its caches, in a short form."""

import shutil

import pytest


@pytest.mark.skipif(shutil.which("g++") is None, reason="there is no g++ here")
def test_edits_give_what_a_compilation_without_caches_gives(sitaf):
    ran = sitaf("bench", "cache", "--edits", "40")
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert ran.stdout.splitlines()[-1] == "cache: held"
