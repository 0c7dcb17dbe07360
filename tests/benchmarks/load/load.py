"""Load test with many agents, builds, rows and reads on each database; prints figures and targets."""

import argparse
import json
import os
import subprocess
import sys
import tempfile
from contextlib import ExitStack
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent.parent.parent / "faults"))
from system import ENROLMENT, TOKEN, Postgres, Table, activity, server


def peak_mib(pid):
    for line in Path(f"/proc/{pid}/status").read_text().splitlines():
        if line.startswith("VmHWM"):
            return int(line.split()[1]) // 1024
    return 0


def phases(central, agents, seconds, zip_file):
    command = ["java", "-Xmx768m", "-cp", os.environ["SITAF_LOAD_CLASSPATH"], "Load",
               str(central.http), str(central.grpc), str(agents), str(seconds), str(zip_file)]
    environment = {**os.environ, "SITAF_TOKEN": TOKEN, "SITAF_ENROLMENT_TOKEN": ENROLMENT}
    done = subprocess.run(command, env=environment, stdout=subprocess.PIPE, text=True, check=False)
    found = {}
    for line in done.stdout.splitlines():
        said = json.loads(line)
        found[said["phase"]] = said
    return found


def report(table, database, agents, found, peak):
    connect = found.get("connect", {"agents": 0})
    table.row(f"{database}: agents connected", connect["agents"], f"{agents}", connect["agents"] == agents)
    table.row(f"{database}: maximum heap (configured), MiB", 1024, "<= 1024", True)
    table.row(f"{database}: peak memory of the process, MiB", peak, "", True)
    if "mixed" not in found:
        table.row(f"{database}: completed phases", ", ".join(found), "all", False)
        return
    builds, rows, mixed = found["builds"], found["rows"], found["mixed"]
    table.row(f"{database}: finished builds/s", builds["finishedPerSecond"], ">= 19",
              builds["finishedPerSecond"] >= 19)
    table.row(f"{database}: dispatch p99, s", builds["dispatchP99"], "<= 1", builds["dispatchP99"] <= 1)
    table.row(f"{database}: accepted result rows/s", rows["rowsPerSecond"], ">= 9,500", rows["rowsPerSecond"] >= 9500)
    table.row(f"{database}: read p99 during uploads, s", rows["readP99"], "<= 0.15", rows["readP99"] <= 0.15)
    table.row(f"{database}: mixed load at half rate: builds/s", mixed["finishedPerSecond"], ">= 11",
              mixed["finishedPerSecond"] >= 11)
    table.row(f"{database}: mixed load at half rate: rows/s", mixed["rowsPerSecond"], ">= 4,750", mixed["rowsPerSecond"] >= 4750)
    table.row(f"{database}: mixed load at half rate: dispatch p99, s", mixed["dispatchP99"], "<= 1", mixed["dispatchP99"] <= 1)
    table.row(f"{database}: mixed load at half rate: read p99, s", mixed["readP99"], "<= 0.15", mixed["readP99"] <= 0.15)
    lost = mixed["lost"] + sum(p["failures"] for p in (builds, rows, mixed))
    table.row(f"{database}: lost streams and failed requests", lost, "0", lost == 0)
    unfinished = sum(p["requested"] - p["finished"] for p in (builds, rows, mixed))
    table.row(f"{database}: builds without a result at the end", unfinished, "0", unfinished == 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=int, default=30, help="duration of each phase")
    parser.add_argument("--agents", type=int, default=500)
    parser.add_argument("--database", choices=["h2", "postgresql", "both"], default="both")
    given = parser.parse_args()
    table = Table("load")
    for database in ["h2", "postgresql"] if given.database == "both" else [given.database]:
        with ExitStack() as stack:
            folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="sitaf-load-")))
            url = None
            if database == "postgresql":
                url = stack.enter_context(Postgres()).url
                url += ("&" if "?" in url else "?") + "reWriteBatchedInserts=true"
            zip_file = folder / "activity.zip"
            zip_file.write_bytes(activity(0))
            central = server(folder, "--logging.level.org.sitaf=warn", database=url, heap="1024m").start()
            try:
                found = phases(central, given.agents, given.seconds, zip_file)
                report(table, database, given.agents, found, peak_mib(central.process.pid))
            finally:
                central.stop()
    return table.end()


if __name__ == "__main__":
    sys.exit(main())
