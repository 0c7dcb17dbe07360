"""The tutorials of the book work as written: their files are created, their commands run, and their output is as shown."""

import re
import shlex
import subprocess
from pathlib import Path

import pytest
from snippets import ROOT, sessions, words

BLOCK = re.compile(
    r"^```(?P<language>\w+)(?: title=\"(?P<title>[^\"]+)\")?\n(?P<text>.*?)^```$", re.MULTILINE | re.DOTALL
)
LIMIT_S = 300
TUTORIALS = sorted((ROOT / "docs" / "tutorial").glob("*.md"))
# Keys of activity.yaml, as its readers list them.
READERS = {
    "ProfileReader.java": ("ENTRIES", "COMPONENT_ENTRIES"),
    "CppBuildReader.java": ("ENTRIES",),
    "ros/RosNodeReader.java": ("COMPONENT_ENTRIES",),
}


@pytest.mark.parametrize("page", TUTORIALS, ids=lambda page: page.stem)
def test_a_tutorial_works_as_written(page, tmp_path):
    files = commands = 0
    for block in BLOCK.finditer(page.read_text()):
        if block["title"]:
            file = tmp_path / block["title"]
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(block["text"])
            files += 1
            continue
        assert block["language"] == "console", f"{page.name}: a block without a title: {block[0][:80]}"
        for command, code, expected in sessions(block["text"]):
            program, *arguments = shlex.split(command)
            assert program == "./sitaf"
            ran = subprocess.run(
                [ROOT / "sitaf", *arguments], cwd=tmp_path, capture_output=True, text=True, timeout=LIMIT_S, check=False
            )
            assert ran.returncode == code, f"{command}\n{ran.stdout}{ran.stderr}"
            shown = [words(line) for line in ran.stdout.splitlines()]
            for line in expected:
                assert words(line) in shown, f"{command}: the output has no line '{line}':\n{ran.stdout}"
                shown = shown[shown.index(words(line)) + 1 :]
            commands += 1
    print(f"{page.stem}: {files} files, {commands} commands")
    assert files > 4
    assert commands > 1


def test_every_key_of_an_activity_is_in_its_reference():
    page = (ROOT / "docs" / "activity.md").read_text()
    keys = set()
    for name, sets in READERS.items():
        source = (ROOT / "itaes-server/core/src/main/java/org/sitaf/core/activity" / name).read_text()
        for found in sets:
            declared = re.search(rf"Set<String> {found} =\s*Set\.of\((.*?)\);", source, re.DOTALL)
            keys |= set(re.findall(r'"(\w+)"', declared[1]))
    assert len(keys) > 30
    assert [key for key in sorted(keys) if f"`{key}`" not in page] == []


def test_the_book_is_built_without_warnings(sitaf):
    built = sitaf("docs")
    assert built.returncode == 0, built.stderr
    site = Path(built.stdout.strip()).parent
    pages = sorted(path.relative_to(site).as_posix() for path in site.rglob("*.html"))
    assert len(pages) > 25
    for path in pages:
        text = (site / path).read_text()
        assert not re.search(r'(?:src|href)="(?:https?:)?//[^"]*\.(?:js|css|woff2?)', text), (
            f"{path} loads files from elsewhere"
        )
