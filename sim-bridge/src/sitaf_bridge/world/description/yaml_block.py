"""Reads YAML with line numbers and collects all errors instead of raising the first one."""

import difflib
import math
import re
from collections.abc import Iterator

import yaml

from sitaf_bridge.errors import BadWorld, Problem

MAX_YAML_BYTES = 256 * 1024
MAX_DEPTH = 32
NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]{0,127}")
# YAML 1.1 reads 1e3 as a string, but authors mean a number.
NUMBER = re.compile(r"[-+]?(\d+(\.\d*)?|\.\d+)([eE][-+]?\d+)?")
OPENING = (
    yaml.BlockMappingStartToken,
    yaml.BlockSequenceStartToken,
    yaml.FlowMappingStartToken,
    yaml.FlowSequenceStartToken,
)
CLOSING = (yaml.BlockEndToken, yaml.FlowMappingEndToken, yaml.FlowSequenceEndToken)


class Problems:
    """The errors found in one file."""

    def __init__(self, file: str) -> None:
        self.file = file
        self.found: list[Problem] = []

    def add(self, line: int | None, message: str) -> None:
        """Add an error."""
        self.found.append(Problem(self.file, line, message))

    def raise_if_any(self) -> None:
        """Raise BadWorld with all errors, sorted by line."""
        if self.found:
            raise BadWorld(sorted(self.found, key=lambda problem: (problem.line or 0, problem.message)))


class Block:
    """A YAML mapping at `path` whose keys are read one by one; `finish` reports unknown keys."""

    def __init__(self, node: yaml.Node, path: str, problems: Problems) -> None:
        self.path = path
        self.line = node.start_mark.line + 1
        self.problems = problems
        self._entries: dict[str, yaml.Node] = {}
        self._taken: set[str] = set()
        if not isinstance(node, yaml.MappingNode):
            self.problem(f"{path or 'the document'} must be a mapping (key: value)")
            return
        for key, value in node.value:
            line = key.start_mark.line + 1
            if not isinstance(key, yaml.ScalarNode):
                problems.add(line, f"{path}: a key must be a plain name")
            elif key.value in self._entries:
                problems.add(line, f"{self.inner(key.value)} is given twice")
            else:
                self._entries[key.value] = value

    def problem(self, message: str, key: str | None = None) -> None:
        """Report an error at this block or at the value of a key."""
        node = self._entries.get(key) if key else None
        self.problems.add(node.start_mark.line + 1 if node else self.line, message)

    def inner(self, key: str) -> str:
        """The full path of a key."""
        return f"{self.path}.{key}" if self.path else key

    def has(self, key: str) -> bool:
        """Whether a key is present."""
        return key in self._entries

    def text(self, key: str) -> str | None:
        """Read a required text; None after reporting an error."""
        node = self._take(key, required=True)
        if node is None:
            return None
        if not isinstance(node, yaml.ScalarNode) or not node.value or node.tag.endswith(":null"):
            self.problem(f"{self.inner(key)} must be text", key)
            return None
        return str(node.value)

    def number(self, key: str) -> float | None:
        """Read a required finite number; None after reporting an error."""
        node = self._take(key, required=True)
        return None if node is None else self._number(node, self.inner(key))

    def optional_number(self, key: str, default: float) -> float | None:
        """Read a finite number with a default; None after reporting an error."""
        node = self._take(key, required=False)
        return default if node is None else self._number(node, self.inner(key))

    def optional_text(self, key: str, default: str) -> str | None:
        """Read a text with a default; None after reporting an error."""
        return self.text(key) if key in self._entries else self._default(key, default)

    def pair(self, key: str, *, required: bool = True) -> tuple[yaml.Node, yaml.Node] | None:
        """Read a list of exactly two items."""
        node = self._take(key, required=required)
        if node is None:
            return None
        if not isinstance(node, yaml.SequenceNode) or len(node.value) != 2:
            self.problem(f"{self.inner(key)} must be a list of two items", key)
            return None
        return node.value[0], node.value[1]

    def numbers(self, key: str) -> tuple[float, float] | None:
        """Read a required list of two finite numbers."""
        nodes = self.pair(key)
        if nodes is None:
            return None
        first, second = (self._number(node, self.inner(key)) for node in nodes)
        return None if first is None or second is None else (first, second)

    def texts(self, key: str, *, required: bool = False) -> tuple[str, str] | None:
        """Read a list of two texts."""
        nodes = self.pair(key, required=required)
        if nodes is None:
            return None
        if not all(isinstance(node, yaml.ScalarNode) for node in nodes):
            self.problem(f"{self.inner(key)} must be a list of two texts", key)
            return None
        return str(nodes[0].value), str(nodes[1].value)

    def block(self, key: str) -> "Block | None":
        """Read a required mapping."""
        node = self._take(key, required=True)
        return None if node is None else Block(node, self.inner(key), self.problems)

    def one_or_more(self, key: str) -> "list[Block]":
        """Read a required mapping or list of mappings."""
        node = self._take(key, required=True)
        if node is None:
            return []
        if isinstance(node, yaml.SequenceNode):
            if not node.value:
                self.problem(f"{self.inner(key)} is an empty list", key)
            return [Block(n, f"{self.inner(key)}[{i}]", self.problems) for i, n in enumerate(node.value)]
        return [Block(node, self.inner(key), self.problems)]

    def named_blocks(self, key: str) -> "Iterator[tuple[str, Block]]":
        """Read an optional mapping from names to mappings."""
        node = self._take(key, required=False)
        if node is None or (isinstance(node, yaml.ScalarNode) and node.tag.endswith(":null")):
            return
        outer = Block(node, self.inner(key), self.problems)
        for name, value in outer._entries.items():
            entry = Block(value, outer.inner(name), self.problems)
            if NAME.fullmatch(name):
                yield name, entry
            else:
                entry.problem(
                    f"{outer.path}: the name {name!r} must be letters, digits and '_', "
                    "must not start with a digit, and must have at most 128 characters"
                )

    def named_texts(self, key: str) -> dict[str, str] | None:
        """Read an optional mapping from names to texts; None after reporting an error."""
        node = self._take(key, required=False)
        if node is None:
            return {}
        if not isinstance(node, yaml.MappingNode) or not all(
            isinstance(part, yaml.ScalarNode) for pair in node.value for part in pair
        ):
            self.problem(f"{self.inner(key)} must be a mapping (name: text)", key)
            return None
        return {str(name.value): str(value.value) for name, value in node.value}

    def list_of_texts(self, key: str) -> list[str]:
        """Read a required list of texts that is not empty; an empty one after reporting an error."""
        node = self._take(key, required=True)
        if node is None:
            return []
        if not isinstance(node, yaml.SequenceNode) or not node.value:
            self.problem(f"{self.inner(key)} must be a list of names", key)
            return []
        return [str(item.value) for item in node.value]

    def line_of(self, key: str) -> int:
        """The line of a value, or of this block."""
        node = self._entries.get(key)
        return node.start_mark.line + 1 if node else self.line

    def text_or_texts(self, key: str) -> str | dict[str, str] | None:
        """Read a text or a mapping from names to texts; None after reporting an error."""
        return self.text(key) if isinstance(self._entries.get(key), yaml.ScalarNode) else self.named_texts(key)

    def finish(self) -> None:
        """Report all keys that were not read."""
        for key, node in self._entries.items():
            if key not in self._taken:
                known = ", ".join(sorted(self._taken))
                nearest = difflib.get_close_matches(key, sorted(self._taken), n=1, cutoff=0.0)
                meant = f"did you mean {nearest[0]!r}? " if nearest else ""
                self.problems.add(
                    node.start_mark.line + 1, f"{self.inner(key)} is not a known key; {meant}known keys: {known}"
                )

    def triple(self, key: str, default: tuple[float, float, float]) -> tuple[float, float, float] | None:
        """Read an optional list of three finite numbers; None after reporting an error."""
        node = self._take(key, required=False)
        if node is None:
            return default
        if not isinstance(node, yaml.SequenceNode) or len(node.value) != 3:
            self.problem(f"{self.inner(key)} must be a list of three numbers", key)
            return None
        x, y, z = (self._number(inner, self.inner(key)) for inner in node.value)
        return None if x is None or y is None or z is None else (x, y, z)

    def _default(self, key: str, default: str) -> str:
        self._taken.add(key)
        return default

    def _take(self, key: str, *, required: bool) -> yaml.Node | None:
        self._taken.add(key)
        node = self._entries.get(key)
        if node is None and required:
            self.problem(f"{self.inner(key)} is missing")
        return node

    def _number(self, node: yaml.Node, path: str) -> float | None:
        if isinstance(node, yaml.ScalarNode) and NUMBER.fullmatch(node.value):
            value = float(node.value)
            if math.isfinite(value):
                return value
        shown = node.value if isinstance(node, yaml.ScalarNode) else "a list or mapping"
        self.problems.add(node.start_mark.line + 1, f"{path} must be a finite number, not {shown!r}")
        return None


def parse(content: bytes, problems: Problems) -> Block:
    """Parse the top mapping of a YAML file. Raises BadWorld if it is not YAML, or more than one document."""
    if len(content) > MAX_YAML_BYTES:
        raise BadWorld([Problem(problems.file, None, f"is larger than {MAX_YAML_BYTES} bytes")])
    try:
        text = content.decode("utf-8")
        _check_structure(text, problems)
        node = yaml.compose(text, Loader=yaml.SafeLoader)
    except UnicodeDecodeError as error:
        raise BadWorld([Problem(problems.file, None, f"is not UTF-8: {error.reason}")]) from error
    except yaml.MarkedYAMLError as error:
        line = error.problem_mark.line + 1 if error.problem_mark else None
        raise BadWorld([Problem(problems.file, line, f"not YAML: {error.problem or error}")]) from error
    except yaml.YAMLError as error:
        raise BadWorld([Problem(problems.file, None, f"not YAML: {error}")]) from error
    if node is None:
        raise BadWorld([Problem(problems.file, None, "is empty")])
    return Block(node, "", problems)


def _check_structure(text: str, problems: Problems) -> None:
    """Reject aliases, which make documents larger than their text, and deep nesting, which takes quadratic time."""
    depth = 0
    for token in yaml.scan(text, Loader=yaml.SafeLoader):
        line = token.start_mark.line + 1
        if isinstance(token, yaml.AliasToken):
            problems.add(line, "aliases (*name) are not allowed; write the value out")
        elif isinstance(token, OPENING):
            depth += 1
            if depth > MAX_DEPTH:
                problems.add(line, f"is nested deeper than {MAX_DEPTH}")
        elif isinstance(token, CLOSING):
            depth -= 1
        problems.raise_if_any()
