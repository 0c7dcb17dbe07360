"""The documents name paths, classes, commands and links that exist."""

import functools
import itertools
import os
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
PRUNED = {".git", ".sitaf", "node_modules", "target", "__pycache__"}
# All paths and classes in these documents are checked. In other documents, only paths from the
# root of the repository or the folder of the document are.
MAPS = ("ARCHITECTURE.md", "CONTRIBUTING.md")
# Paths in users' activities, and files that a command creates.
ELSEWHERE = re.compile(r"harness/MODEL/|^\./|\.sitaf/|^/|webapp/dist|schema\.d\.ts$")
# A word in capitals is a placeholder.
PLACEHOLDER = re.compile(r"\b[A-Z]{3,}\b")
# Pages that `./sitaf docs` generates from the commands, schemas and interfaces.
GENERATED = {f"docs/{page}" for page in re.findall(r"\breference/[\w-]+\.md\b", (ROOT / "docs/book/mkdocs.yml").read_text())}
CLASS = re.compile(r"[A-Z]\w*[a-z]\w*(?:\.\w+)?")


@functools.cache
def files():
    """Every file below the root, relative to it."""
    found = []
    for folder, folders, names in os.walk(ROOT):
        folders[:] = sorted(name for name in folders if name not in PRUNED and not name.endswith(".egg-info"))
        found += [Path(folder, name).relative_to(ROOT).as_posix() for name in names]
    return found


@functools.cache
def endings():
    """Each path of a file or folder, and each path without its first folders."""
    known = set()
    for path in files():
        parts = path.split("/")
        for start, end in itertools.combinations(range(len(parts) + 1), 2):
            known.add("/".join(parts[start:end]))
    return known


@functools.cache
def by_stem():
    """Files by their name without the extension."""
    stems = {}
    for path in files():
        stems.setdefault(Path(path).stem, []).append(path)
    return stems


def documents():
    return sorted(path for path in files() if path.endswith(".md"))


def text(document):
    return (ROOT / document).read_text()


def spans(document):
    """The texts in single backticks, with line breaks replaced by spaces."""
    prose = re.sub(r"^```.*?^```", "", text(document), flags=re.DOTALL | re.MULTILINE)
    return [" ".join(span.split()) for span in re.findall(r"`([^`]+)`", prose)]


def alternatives(path):
    """Expands {a,b} in a path."""
    braces = re.search(r"\{([^{}]*)\}", path)
    if not braces:
        return [path]
    return [path[: braces.start()] + one + path[braces.end() :] for one in braces[1].split(",")]


def paths(document):
    for span in spans(document):
        if re.fullmatch(r"[\w.{},@+-]*(/[\w.{},@+-]*)+", span) and not ELSEWHERE.search(span):
            yield from (path.strip("/") for path in alternatives(span) if not PLACEHOLDER.search(Path(path).name))


@pytest.mark.parametrize("document", documents())
def test_links_lead_to_files(document):
    folder = (ROOT / document).parent
    # A formula such as always[0, 2](P) in code is no link.
    prose = re.sub(r"```.*?```|`[^`\n]*`", "", text(document), flags=re.DOTALL)
    targets = re.findall(r"\]\(([^)#\s]+)[^)]*\)", prose)
    missing = [t for t in targets if not re.match(r"[a-z]+:", t) and not (folder / t).exists()]
    assert [t for t in missing if os.path.normpath(Path(document).parent / t) not in GENERATED] == []


@pytest.mark.parametrize("document", documents())
def test_paths_from_the_root_or_the_folder_of_the_document_exist(document):
    folder = Path(document).parent
    tops = {path.name for place in (ROOT, ROOT / folder) for path in place.iterdir() if path.is_dir()} - PRUNED
    named = [path for path in paths(document) if path.split("/")[0] in tops and "/" in path]
    assert [
        p for p in named if not (ROOT / p).exists() and not (ROOT / folder / p).exists() and p not in endings()
    ] == []


@pytest.mark.parametrize("document", MAPS)
def test_every_path_of_a_map_exists(document):
    named = list(paths(document))
    assert len(named) > 20
    assert [path for path in named if not path.startswith("api/") and path not in endings()] == []


@pytest.mark.parametrize("document", MAPS)
def test_every_class_of_a_map_exists(document):
    named = [span for span in spans(document) if CLASS.fullmatch(span)]
    assert len(named) > 15
    missing = []
    for name in named:
        stem, _, member = name.partition(".")
        sources = [(ROOT / path).read_text() for path in by_stem().get(stem, [])]
        if not sources:
            declaration = re.compile(rf"\b(?:class|record|interface|enum|message)\s+{stem}\b")
            sources = [s for s in map(_source, files()) if declaration.search(s)]
        if not any(re.search(rf"\b{member}\b", source) for source in sources):
            missing.append(name)
    assert missing == []


@functools.cache
def _source(path):
    return (ROOT / path).read_text() if path.endswith((".java", ".py", ".proto", ".hpp")) else ""


@pytest.mark.parametrize("document", documents())
def test_commands_exist(document):
    help_text = (ROOT / "itaes-server/cli/launcher/help.txt").read_text()
    known = set(re.findall(r"^  ([a-z]+)  ", help_text, flags=re.MULTILINE))
    programs = {
        Path(path).parent.name for path in files() if re.fullmatch(r"tests/(benchmarks|faults)/[^/]+/run", path)
    }
    commands = re.findall(r"\./sitaf ([a-z]+)(?: ([a-z-]+)\b)?", text(document))
    assert {name for name, _ in commands} - known == set()
    assert {program for name, program in commands if name == "bench" and program} - programs == set()
