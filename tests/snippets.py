"""The snippets of the documents, and what of them a test compares."""

import re
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
BLOCK = re.compile(r"^ *```(?P<language>\w*)[^\n]*\n(?P<text>.*?)^ *```", re.MULTILINE | re.DOTALL)
EXIT = re.compile(r"\[exit (\d+)\]")
# Times of this machine.
TIMES = re.compile(r"\d+\.\d{3}\b")


@dataclass(frozen=True)
class Snippet:
    """A block of a page. Its name has the page, the number of the block there, and the language."""

    name: str
    page: str
    language: str
    text: str

    @property
    def is_session(self):
        """Whether it shows a command of the launcher with its output."""
        return self.text.startswith("$ ./sitaf ")


def read():
    # The tutorials are run by test_book.py.
    pages = [p for p in sorted((ROOT / "docs").rglob("*.md")) if "tutorial" not in p.parts]
    for page in [*pages, ROOT / "README.md"]:
        for number, block in enumerate(BLOCK.finditer(page.read_text()), 1):
            name = f"{page.stem}-{number}-{block['language'] or 'output'}"
            yield Snippet(name, page.name, block["language"], block["text"])


SNIPPETS = list(read())


def snippet(name):
    """The text of a snippet."""
    return next(s.text for s in SNIPPETS if s.name == name)


def sessions(text):
    """The commands of a console block with their expected exit code and lines of output."""
    for part in re.split(r"^\$ ", text, flags=re.MULTILINE)[1:]:
        command, *lines = part.splitlines()
        codes = [int(found[1]) for line in lines if (found := EXIT.fullmatch(line.strip()))]
        expected = [line for line in lines if line.strip() not in ("", "...") and not EXIT.fullmatch(line.strip())]
        yield command, codes[0] if codes else 0, expected


def words(line):
    return " ".join(line.split())


def expect_lines(expected, output):
    """Checks that an output has these lines in this order, apart from spaces and times."""
    shown = [TIMES.sub("#", words(line)) for line in output.splitlines()]
    for line in expected:
        masked = TIMES.sub("#", words(line))
        assert masked in shown, f"the output has no line '{line}':\n{output}"
        shown = shown[shown.index(masked) + 1 :]


def is_part(shown, found):
    """Whether the JSON that a page shows is part of what was found; `...` stands for the rest of a text."""
    if isinstance(shown, dict):
        return isinstance(found, dict) and all(k in found and is_part(v, found[k]) for k, v in shown.items())
    if isinstance(shown, list):
        return isinstance(found, list) and all(any(is_part(s, f) for f in found) for s in shown)
    if isinstance(shown, str) and shown.endswith("..."):
        return isinstance(found, str) and found.startswith(shown[: -len("...")])
    return shown == found
