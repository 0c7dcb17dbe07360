"""Answers the services and actions that a node requires."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Any

from sitaf_runtime.errors import CaseDataError
from sitaf_runtime.ros.fields import Fields

# Calls of required services that are recorded in a case, as in other test stubs.
_MOST_CALLS = 1_000
_DELAYED = re.compile(r"!delay:([0-9]{1,6}(?:\.[0-9]{1,9})?)(?: (.*))?", re.DOTALL | re.ASCII)
_ERROR = "!error:"


class NoAnswerError(Exception):
    """The case says that this call gets no answer."""


def free(name: str, prefix: str, taken: set[str]) -> str:
    """A name that no parameter has yet, by the rule of the interface's description."""
    while name in taken:
        name = prefix + name
    taken.add(name)
    return name


def results_of(fields: Iterable[str], taken: set[str]) -> dict[str, str]:
    """The fields of a response by the name of their output; the only one is the return value, with an empty name.

    `taken` holds the fields of the request, and receives the names of the outputs.
    """
    named = list(fields)
    if len(named) == 1:
        return {"": named[0]}
    return {free(field, "result_", taken): field for field in named}


class Stub:
    """One required service or action. `answers` are those of all stubs, `calls` receives the recorded calls."""

    def __init__(
        self,
        entry: Mapping[str, Any],
        answers: Iterable[dict[str, Any]],
        values: Mapping[str, str],
        fields: Fields,
        calls: list[tuple[str, dict[str, str]]],
    ) -> None:
        self._entry = entry
        # Literals of each part of the response (empty: the whole) from a call on.
        self._answers: dict[str, list[tuple[int, str]]] = {}
        # The number of calls before the answers of a part were replaced, from which their calls count.
        self._before: dict[str, int] = {}
        self._fields = fields
        self._calls = calls
        self._count = 0
        self._system: Any = None
        self.replace(answers, values)

    def replace(self, answers: Iterable[dict[str, Any]], values: Mapping[str, str]) -> None:
        """Answer from now on with these values; parts of the response that no answer names keep theirs."""
        by_part: dict[str, list[tuple[int, str]]] = {}
        for answer in answers:
            if answer["method"] == self._entry["method"]:
                by_part.setdefault(answer["part"] or "", []).append((answer["from_call"], values[answer["column"]]))
        for part, literals in by_part.items():
            self._answers[part] = sorted(literals)
            self._before[part] = self._count

    def serve(self, system: Any) -> None:
        """Answer the calls of a case."""
        self._system = system
        if self._entry["kind"] == "action":
            system.serve_action(self._entry["name"], self._entry["type"], self._goal)
        else:
            system.serve_service(self._entry["name"], self._entry["type"], self._request)

    def _request(self, request: Any) -> Any:
        from sitaf_ros import Delayed

        class_ = self._system.application.classes.message(self._entry["type"])
        delay_s, response = self._answer(request, class_.Response)
        return Delayed(delay_s, response)

    def _goal(self, goal: Any) -> Any:
        from sitaf_ros import ActionAnswer

        class_ = self._system.application.classes.message(self._entry["type"])
        try:
            delay_s, result = self._answer(goal, class_.Result)
        except NoAnswerError:
            return ActionAnswer(accept=False)
        return ActionAnswer(after_s=delay_s, result=result)

    def _answer(self, request: Any, answered: Any) -> tuple[float, dict[str, Any]]:
        """The delay in seconds and the fields of the answer. Raises NoAnswerError."""
        self._count += 1
        asked = dict(request.get_fields_and_field_types())
        if len(self._calls) < _MOST_CALLS:
            given = self._system.fields(request)
            literals = {name: self._fields.literal(asked[name], value) for name, value in given.items()}
            self._calls.append((self._entry["method"], literals))
        types = dict(answered.get_fields_and_field_types())
        response: dict[str, Any] = {}
        delay_s = 0.0
        for name, field in results_of(types, set(asked)).items():
            literal = self._current(name)
            if literal is not None:
                response[field] = self._fields.parse(types[field], literal)
        whole = self._current("", special=True)
        if whole is not None:
            delay_s, literal = _special(whole)
            if literal is not None and len(types) == 1:
                only = next(iter(types))
                response[only] = self._fields.parse(types[only], literal)
        return delay_s, response

    def _current(self, part: str, special: bool = False) -> str | None:
        """The value of the current call's answer, or with `special` its error or delay; None if there is none."""
        number = self._count - self._before.get(part, 0)
        current = None
        for from_call, literal in self._answers.get(part, ()):
            if from_call <= number:
                current = literal
        return current if current is not None and current.startswith("!") == special else None


def _special(literal: str) -> tuple[float, str | None]:
    """The delay and the value of an answer such as `!delay:0.5 7`. Raises NoAnswerError for an error."""
    delay_s, rest = 0.0, literal
    delayed = _DELAYED.fullmatch(literal)
    if delayed:
        delay_s, rest = float(delayed[1]), delayed[2]
    elif not literal.startswith(_ERROR):
        raise CaseDataError(f"'{literal}' is not a delay such as !delay:0.5 or !delay:0.5 VALUE, in seconds")
    if rest is not None and rest.startswith(_ERROR):
        raise NoAnswerError(literal)
    return delay_s, rest
