#!/usr/bin/env bash
# Format, lint and types of the library. usage: check.sh PYTHON (one that has the package and ruff)
set -euo pipefail
cd "$(dirname "$0")"
python=${1:?usage: check.sh PYTHON}
bin=$(dirname "$python")
"$bin/ruff" format --check src
"$bin/ruff" check src
"$bin/basedpyright" --pythonpath "$python" src
