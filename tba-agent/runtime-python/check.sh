#!/usr/bin/env bash
# Format, lint and types of the runtime. usage: check.sh PYTHON (one that has the package's dev extra)
set -euo pipefail
cd "$(dirname "$0")"
python=${1:?usage: check.sh PYTHON}
bin=$(dirname "$python")
"$bin/ruff" format --check src tests
"$bin/ruff" check src tests
"$bin/basedpyright" --pythonpath "$python" src
