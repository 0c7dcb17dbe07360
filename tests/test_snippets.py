"""Every snippet of the documents is valid: the names that it uses exist in the readers, schemas and interfaces.

Whether it is valid alone: each one is run, too, by the test that names it.
"""

import ast
import functools
import json
import re
import shlex
import subprocess
from xml.etree import ElementTree

import pytest
from snippets import ROOT, SNIPPETS

yaml = pytest.importorskip("yaml", reason="PyYAML is missing")

READERS = ROOT / "itaes-server" / "core" / "src" / "main" / "java"
SCHEMAS = ROOT / "schemas" / "src" / "main" / "resources"
# Files of other programs, and the lock file.
NOT_OF_AN_ACTIVITY = {"continuous-integration.md", "packages.md"}
SERVER = "https://sitaf.example"
PLACEHOLDERS = re.compile(r"^(ID|NUMBER|COMMIT|BUILD|\d+)$")


@functools.cache
def quoted_names():
    """All words between quotes in the sources that read activities and worlds."""
    return set(re.findall(r'"(\w+)"', "".join(p.read_text() for p in READERS.rglob("*.java"))))


@functools.cache
def schema_names():
    """The elements and attributes of all schemas."""
    return set(re.findall(r'\bname="([\w.-]+)"', "".join(p.read_text() for p in SCHEMAS.rglob("*.xsd"))))


@functools.cache
def record_words():
    """The words in the sources that read what a test application writes, which has no schema."""
    folder = READERS / "org" / "sitaf" / "core" / "verdict" / "document"
    return set(re.findall(r"\w+", "".join(p.read_text() for p in folder.glob("*Line.java"))))


@functools.cache
def openapi():
    return json.loads((ROOT / "webapp" / "openapi.json").read_text())


def check_yaml(page, text):
    found = yaml.safe_load(text)
    assert isinstance(found, dict | list)
    if page in NOT_OF_AN_ACTIVITY:
        return
    keys = set(found) | set(found.get("component", {})) | set(found.get("timing", {})) | set(found.get("limits", {}))
    assert keys - quoted_names() == set()


def check_xml(page, text):
    tree = ElementTree.fromstring(f"<snippet>{text}</snippet>")
    names = {e.tag for e in tree.iter() if e is not tree} | {a for e in tree.iter() for a in e.attrib}
    known = schema_names() | (record_words() if page == "test-application.md" else set())
    assert names - known == set()


def check_json(page, text):
    assert json.loads(text)


def check_python(page, text):
    ast.parse(text)


def check_shell(page, text):
    """The commands are of the shell's language, and requests are those of the REST interface."""
    commands = re.sub(r"^\$ ", "", text, flags=re.MULTILINE)
    parsed = subprocess.run(["bash", "-n"], input=commands, text=True, capture_output=True, check=False)
    assert parsed.returncode == 0, parsed.stderr
    for line in re.sub(r"\\\n", " ", commands).splitlines():
        if line.startswith("curl "):
            check_request(shlex.split(line))


def check_request(words):
    address = next(word for word in words if word.startswith(SERVER))
    path = "/" + address.split("/", 3)[3].partition("?")[0]
    body = words[words.index("-d") + 1] if "-d" in words else None
    parts = path.split("/")
    matching = [
        known
        for known in openapi()["paths"]
        if len(known.split("/")) == len(parts)
        and all(
            k == p or (k.startswith("{") and PLACEHOLDERS.match(p))
            for k, p in zip(known.split("/"), parts, strict=True)
        )
    ]
    assert len(matching) == 1, f"{path}: {matching}"
    operation = openapi()["paths"][matching[0]].get("post" if body else "get")
    assert operation, f"{matching[0]} has no such method"
    if body:
        content = operation["requestBody"]["content"]["application/json"]["schema"]
        schema = openapi()["components"]["schemas"][content["$ref"].rpartition("/")[2]]
        assert set(json.loads(body)) - set(schema["properties"]) == set()


CHECKS = {
    "yaml": check_yaml,
    "xml": check_xml,
    "json": check_json,
    "python": check_python,
    "sh": check_shell,
    "console": check_shell,
}


@pytest.mark.parametrize("snippet", SNIPPETS, ids=lambda snippet: snippet.name)
def test_a_snippet_is_valid(snippet):
    if snippet.language in CHECKS:
        CHECKS[snippet.language](snippet.page, snippet.text)
    elif snippet.language == "":
        # What a terminal shows, or a command: test_documents.py knows the commands.
        assert snippet.text.strip()
    else:
        assert snippet.language in ("groovy", "text", "idl"), f"{snippet.language}: no test reads this language"


def test_each_snippet_is_run(capsys):
    """Commands with their output are run by e2e/test_documented.py; the others are named by the test that runs them."""
    tests = [
        *(ROOT / "tests").rglob("test_*.py"),
        *(ROOT / "itaes-server" / "core" / "src" / "test").rglob("*Test.java"),
    ]
    named = "".join(p.read_text() for p in tests)
    counts = {language: sum(s.language == language for s in SNIPPETS) for language in CHECKS}
    with capsys.disabled():
        print(f"\n{len(SNIPPETS)} snippets, of them {', '.join(f'{n} {name}' for name, n in counts.items())}")
    assert min(counts.values()) > 0
    assert [s.name for s in SNIPPETS if not s.is_session and not re.search(rf"[\"']{s.name}[\"']", named)] == []
