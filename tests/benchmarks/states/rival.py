"""Runs the state machine of Hypothesis in the module `rules`, with a seed and a number of examples; exit 1 if it fails."""

import sys

from hypothesis import HealthCheck, Phase, seed, settings
from hypothesis.stateful import run_state_machine_as_test
from rules import Rules

STEPS = 6
number, examples = int(sys.argv[1]), int(sys.argv[2])
# Without shrinking and without examples of earlier runs: only the calls that find the failure are counted.
quiet = settings(
    max_examples=examples,
    stateful_step_count=STEPS,
    database=None,
    deadline=None,
    phases=[Phase.generate],
    suppress_health_check=list(HealthCheck),
)
try:
    run_state_machine_as_test(seed(number)(Rules), settings=quiet)
except Exception as e:  # Any failure of the package is one that was found.
    print(type(e).__name__, e)
    sys.exit(1)
