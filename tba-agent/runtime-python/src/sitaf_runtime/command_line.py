"""The command line of a test application."""

from dataclasses import dataclass
from pathlib import Path

from sitaf_runtime.errors import CannotRunError

USAGE = (
    "--suite FILE --results FILE [--bridge TARGET --world FILE.world.yaml] [--seed N] [--from NO] [--case-sim SECONDS]"
    " [--recording DIR] [--repeat N [--warm-up N] [--repeat-within SECONDS]]"
)
_OPTIONS = (
    "--suite",
    "--results",
    "--bridge",
    "--world",
    "--seed",
    "--from",
    "--case-sim",
    "--recording",
    "--repeat",
    "--warm-up",
    "--repeat-within",
)
# More repeated calls of either kind are never made.
_MAX_CALLS = 10_000


@dataclass(frozen=True, slots=True)
class Repetition:
    """How the call of each case is repeated to measure its time.

    `warm_up` calls are not measured, then `repeat` calls are. No further call begins when `within_s` has passed since
    the case began.
    """

    warm_up: int
    repeat: int
    within_s: float


@dataclass(frozen=True, slots=True)
class CommandLine:
    """The arguments.

    `bridge` is the gRPC target of the simulator and `world` the world description; both None when the component needs
    no simulation. `first` is the number of the first case to run; 0 for all. `case_sim_s` is the maximum simulation
    time of a case. `recording` is the folder for a recording of the motion in each case; None for none. `repetition` is
    None when calls are not repeated.
    """

    suite: Path
    results: Path
    bridge: str | None = None
    world: Path | None = None
    seed: int = 1
    first: int = 0
    case_sim_s: float | None = None
    recording: Path | None = None
    repetition: Repetition | None = None

    @classmethod
    def parse(cls, arguments: list[str]) -> "CommandLine":
        """Read the arguments. Raises CannotRunError when they are wrong."""
        given: dict[str, str] = {}
        for at in range(0, len(arguments), 2):
            option = arguments[at]
            if option not in _OPTIONS or at + 1 == len(arguments):
                raise _usage_error(f"'{option}' is not an option with a value")
            if option in given:
                raise _usage_error(f"{option} is given twice")
            given[option] = arguments[at + 1]
        if ("--bridge" in given) != ("--world" in given):
            raise _usage_error("--bridge and --world belong together")
        for option in ("--suite", "--results"):
            if option not in given:
                raise _usage_error(f"{option} is missing")
        return cls(
            Path(given["--suite"]),
            Path(given["--results"]),
            given.get("--bridge"),
            Path(given["--world"]) if "--world" in given else None,
            _number(given, "--seed", 1),
            _number(given, "--from", 0),
            _seconds(given, "--case-sim"),
            Path(given["--recording"]) if "--recording" in given else None,
            _repetition(given),
        )


def _repetition(given: dict[str, str]) -> Repetition | None:
    if "--repeat" not in given:
        if "--warm-up" in given or "--repeat-within" in given:
            raise _usage_error("--warm-up and --repeat-within need --repeat")
        return None
    return Repetition(
        min(_number(given, "--warm-up", 0), _MAX_CALLS),
        min(_number(given, "--repeat", 0), _MAX_CALLS),
        _seconds(given, "--repeat-within") or float("inf"),
    )


def _number(given: dict[str, str], option: str, default: int) -> int:
    text = given.get(option, str(default))
    if not (text.isascii() and text.isdigit() and len(text) < 20):
        raise _usage_error(f"{option}: '{text}' is not a whole number from 0")
    return int(text)


def _seconds(given: dict[str, str], option: str) -> float | None:
    text = given.get(option)
    if text is None:
        return None
    try:
        seconds = float(text)
    except ValueError:
        seconds = -1.0
    if not 0 < seconds < 1e12:
        raise _usage_error(f"{option}: '{text}' is not a number of seconds above 0")
    return seconds


def _usage_error(problem: str) -> CannotRunError:
    return CannotRunError(f"{problem}; usage: {USAGE}")
