"""A repository with many activities, and commits of which it is known what a build reads of them."""

import io
import re
import shutil
import subprocess
import zipfile
from dataclasses import dataclass
from pathlib import Path

EXAMPLES = {"java": "ir-sensor", "python": "ir-sensor-python", "cpp": "ir-sensor-cpp"}
SOURCES = {
    "java": "component/org/sitaf/examples/ir/InfraredSensor.java",
    "python": "component/infrared_sensor.py",
    "cpp": "component/infrared_sensor.cpp",
}
HEADER = "component/infrared_sensor.hpp"
ADAPTER = "adapter/adapted_sensor.py"
LIBRARY = "lib/limits.jar"
MESH = "v 0 0 0\nv {height} 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
COMMENT = {"java": "// revision {}\n", "python": "# revision {}\n", "cpp": "// revision {}\n"}
AUTHOR = {
    f"GIT_{who}_{what}": value
    for who in ("AUTHOR", "COMMITTER")
    for what, value in (("NAME", "A developer"), ("EMAIL", "developer@example.org"))
}


@dataclass(frozen=True)
class Commit:
    """A commit, and the activity whose build can read what it changed; None for a change outside of all."""

    sha: str
    kind: str
    activity: str | None


def replace(file, pattern, text):
    """Replaces the one place that matches."""
    changed, count = re.subn(pattern, lambda _: text, file.read_text())
    if count != 1:
        raise ValueError(f"{file}: {count} places match {pattern}")
    file.write_text(changed)


def jar(file, revision):
    """A library that holds one resource."""
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w") as archive:
        archive.writestr(zipfile.ZipInfo("limits.properties"), f"revision={revision}\n")
    file.write_bytes(content.getvalue())


class Activity:
    """A copy of the example in one of the languages, with a mesh, data, and what else its kinds of changes need."""

    def __init__(self, home, root, name, language):
        self.name, self.language, self.folder = name, language, root / name
        shutil.copytree(home / "examples" / EXAMPLES[language], self.folder)
        profile = self.folder / "activity.yaml"
        replace(profile, r"(?m)^name: .*", f"name: {name}")
        replace(self.folder / "world" / "ir.xml", r"<asset>", '<asset>\n    <mesh name="part" file="part.obj"/>')
        (self.folder / "data").mkdir()
        for kind in ("data", "mesh"):
            self.change(kind, 0)
        with self.source.open("a") as out:
            out.write(COMMENT[language].format(0))
        if language == "java":
            (self.folder / "lib").mkdir()
            self.change("dependency", 0)
            replace(profile, r"(?m)^libraries: .*", f"libraries: [{LIBRARY}]")
        if language == "python":
            (self.folder / "adapter").mkdir()
            self.change("adapter", 0)
            replace(profile, r"(?m)^  class: .*", "  adapter: adapter/\n  class: adapted_sensor.AdaptedSensor")

    @property
    def source(self):
        return self.folder / SOURCES[self.language]

    def kinds(self):
        further = {"java": ["dependency"], "python": ["adapter"], "cpp": ["header"]}
        return ["source", "comment", "data", "world", "mesh", "model", *further[self.language]]

    def change(self, kind, revision):
        """Makes a change of a kind; another revision gives other bytes."""
        if kind == "source":
            self.change_source(revision)
        elif kind == "comment":
            replace(self.source, r"(?m)^(//|#) revision \d+\n", COMMENT[self.language].format(revision))
        elif kind == "data":
            (self.folder / "data" / "table.txt").write_text(f"{revision}\n")
        elif kind == "world":
            replace(self.folder / "world" / "ir.xml", r'extent="[\d.]+"', f'extent="3.{revision}"')
        elif kind == "mesh":
            (self.folder / "world" / "part.obj").write_text(MESH.format(height=revision + 1))
        elif kind == "model":
            replace(self.folder / "GetInfraredData.xml", r'absolute="1[.\d]*e-9"', f'absolute="1.{revision}e-9"')
        elif kind == "dependency":
            jar(self.folder / LIBRARY, revision)
        elif kind == "adapter":
            (self.folder / ADAPTER).write_text(
                '"""The sensor under another name."""\n\n'
                "from infrared_sensor import InfraredSensor\n\n\n"
                "class AdaptedSensor(InfraredSensor):\n"
                '    """An infrared sensor."""\n\n'
                f"    REVISION = {revision}\n"
            )
        elif kind == "header":
            replace(
                self.folder / HEADER,
                r" public:\n(  static constexpr int headerRevision = \d+;\n)?",
                f" public:\n  static constexpr int headerRevision = {revision};\n",
            )
        else:
            raise ValueError(kind)

    def change_source(self, revision):
        if self.language == "java":
            pattern = r"public final class InfraredSensor \{\n(  static final int REVISION = \d+;\n)?"
            text = f"public final class InfraredSensor {{\n  static final int REVISION = {revision};\n"
        elif self.language == "python":
            pattern, text = r"NO_DISTANCE = -1.0\n(REVISION = \d+\n)?", f"NO_DISTANCE = -1.0\nREVISION = {revision}\n"
        else:
            pattern = r"(int revision\(\);\nint revision\(\) \{ return \d+; \}\n)?// revision"
            text = f"int revision();\nint revision() {{ return {revision}; }}\n// revision"
        replace(self.source, pattern, text)


class Repository:
    """The repository and its branch `main`."""

    OUTSIDE = ("readme", "neighbour", "shared", "empty", "renamed")

    def __init__(self, home, root, count, rng):
        self.root, self.rng, self.revision = root, rng, 0
        root.mkdir()
        self.git("init", "-q", "-b", "main")
        languages = list(EXAMPLES)
        self.activities = [
            Activity(home, root, f"sensor-{i + 1}", languages[i % len(languages)]) for i in range(count)
        ]
        self.write("README.md", "Robots")
        self.write("notes/0.txt", "Moved by commits")
        self.first = self.commit("Add the sensors", "first", None)

    def git(self, *arguments):
        ran = subprocess.run(
            ["git", "-C", self.root, "-c", "commit.gpgsign=false", *arguments],
            env={"PATH": "/usr/bin:/bin:/usr/local/bin", "HOME": str(self.root), **AUTHOR},
            capture_output=True, text=True, check=False,
        )
        if ran.returncode:
            raise RuntimeError(f"git {' '.join(arguments)}: {ran.stderr}")
        return ran.stdout.strip()

    def write(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text + "\n")

    def commit(self, subject, kind, activity):
        self.git("add", "-A")
        self.git("commit", "-q", "--allow-empty", "-m", subject)
        return Commit(self.git("rev-parse", "HEAD"), kind, activity)

    def next(self):
        """A further commit: of five, four change one activity."""
        if self.rng.random() < 0.2:
            return self.change_outside(self.rng.choice(self.OUTSIDE))
        activity = self.rng.choice(self.activities)
        return self.change(activity, self.rng.choice(activity.kinds()))

    def change(self, activity, kind):
        """A commit that changes one activity."""
        self.revision += 1
        activity.change(kind, self.revision)
        return self.commit(f"Change the {kind} of {activity.name}", kind, activity.name)

    def change_outside(self, kind):
        """A commit that changes no activity."""
        self.revision += 1
        if kind == "readme":
            self.write("README.md", f"Robots, revision {self.revision}")
        elif kind == "neighbour":
            # A folder whose name begins with that of an activity.
            activity = self.rng.choice(self.activities)
            self.write(f"{activity.name}-notes/activity.yaml", f"name: {activity.name}, revision {self.revision}")
        elif kind == "shared":
            self.write("component/infrared_sensor.hpp", f"// revision {self.revision}")
        elif kind == "renamed":
            (old,) = (self.root / "notes").iterdir()
            old.rename(old.with_name(f"{self.revision}.txt"))
        return self.commit(f"Change nothing that is tested: {kind}", kind, None)

    @property
    def url(self):
        return Path(self.root).as_uri()
