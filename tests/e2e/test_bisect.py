"""`./sitaf bisect`: the commit that broke a component."""

import json
import subprocess

import pytest
from test_compare import ACTIVITY, IDL, MODEL

OUTPUT = (
    '<output_spec_list><test_element abstract_type="NUMERIC" real_type="double"><name>return</name>'
    "<type>RETURN</type>{expected}</test_element></output_spec_list>"
)
EXPECTED = "<expected>inverted ? -gain : gain</expected>"


class History:
    """A repository whose folder `arm` is changed by each commit."""

    def __init__(self, root, expected):
        self.root, self.folder = root, root / "arm"
        (self.folder / "component").mkdir(parents=True)
        self.git("init", "-q")
        model = MODEL.replace("<output_spec_list/>", OUTPUT.format(expected=expected))
        for name, text in {"activity.yaml": ACTIVITY, "counter.idl": IDL, "Read.xml": model}.items():
            (self.folder / name).write_text(text)

    def git(self, *arguments):
        command = ["git", "-c", "user.name=Ada", "-c", "user.email=ada@example.org", "-C", self.root, *arguments]
        return subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()

    def commit(self, number, body):
        text = f"# {number}\n\n\nclass Counter:\n    def read(self, gain, inverted):\n        {body}\n"
        (self.folder / "component" / "counter.py").write_text(text)
        self.git("add", "-A")
        self.git("commit", "-q", "-m", f"Change {number}")
        return self.git("rev-parse", "HEAD")


GOOD = "return -gain if inverted else gain"
BAD = "return -gain if inverted else gain + (1 if gain == 3 else 0)"
BROKEN = "return ((("


@pytest.fixture
def bisect(sitaf, tmp_path):
    """Searches and returns the exit code, the JSON and the output."""

    def run(*arguments):
        file = tmp_path / "bisection.json"
        file.unlink(missing_ok=True)
        done = sitaf("bisect", *arguments, "--json", file)
        found = json.loads(file.read_text()) if file.exists() else None
        return done.returncode, found, done.stdout + done.stderr

    return run


def test_the_commit_that_makes_a_case_fail(bisect, tmp_path):
    history = History(tmp_path / "robot", EXPECTED)
    first = history.commit(0, GOOD)
    commits = [history.commit(i, BROKEN if i in (31, 32, 33) else BAD if i >= 37 else GOOD) for i in range(1, 65)]
    # A commit elsewhere is not tested.
    (history.root / "README").write_text("A robot\n")
    history.git("add", "-A")
    history.git("commit", "-q", "-m", "Describe the robot")
    code, found, output = bisect(history.folder, first, "HEAD")
    assert code == 0, output
    assert found["first_bad"] == commits[36]
    assert found["builds"] <= 9
    assert "Change 37" in output and "case 5: expected 3.0, but was 4.0" in output
    assert "Describe the robot" not in output

    code, found, output = bisect(history.folder, commits[29], commits[34])
    assert code == 2 and "no case fails, and GOOD gives the same values" in output
    code, found, output = bisect(history.folder, commits[40], "HEAD")
    assert code == 2 and "is bad, too: case 5: expected 3.0, but was 4.0" in output


def test_a_case_that_also_fails_with_good_does_not_decide(bisect, tmp_path):
    history = History(tmp_path / "robot", EXPECTED)
    # Gain 1 is wrong in all versions.
    old = "return (-gain if inverted else gain) + (1 if gain == 1 else 0)"
    new = "return (-gain if inverted else gain) + (1 if gain in (1, 3) else 0)"
    first = history.commit(0, old)
    commits = [history.commit(i, new if i >= 6 else old) for i in range(1, 9)]
    code, found, output = bisect(history.folder, first, "HEAD")
    assert code == 0, output
    assert found["first_bad"] == commits[5]
    assert "GOOD fails in the other cases, too" in output
    # BAD, GOOD, and each commit at most once.
    assert found["builds"] == 2 + len({t["commit"] for t in found["tested"]})


def test_the_commit_that_changes_a_value_without_an_expected_one(bisect, tmp_path):
    history = History(tmp_path / "robot", "")
    first = history.commit(0, GOOD)
    commits = [history.commit(i, BROKEN if i == 5 else BAD if i >= 6 else GOOD) for i in range(1, 9)]
    code, found, output = bisect(history.folder, first, "HEAD", "--case", "4-6", "--model", "Read")
    assert code == 1, output
    assert found["first_bad"] is None
    assert found["candidates"] == [commits[4], commits[5]]
    assert {t["commit"]: t["outcome"] for t in found["tested"]}[commits[4]] == "skipped"
    assert "the sources do not compile" in output


def test_a_folder_without_a_history(bisect, tmp_path):
    (tmp_path / "arm").mkdir()
    code, found, output = bisect(tmp_path / "arm", "HEAD~1", "HEAD")
    assert (code, found) == (2, None)
    assert "is not in a Git repository" in output
