"""The kinds of hostile activities and their archives."""

import io
import re
import zipfile
from pathlib import Path

HERE = Path(__file__).parent
EXAMPLES = HERE.parents[2] / "examples"

LANGUAGES = {
    # The modified example, the class under test, and the folder of component files by language.
    "java": ("ir-sensor", "org.sitaf.hostile.HostileComponent"),
    "cpp": ("ir-sensor-cpp", "hostile::HostileComponent"),
    "python": ("ir-sensor-python", "hostile.HostileComponent"),
}

# The component returns -999 or does not return, so a green build would be wrong.
NEVER_GREEN = {
    "child-kills-driver", "child-stops-driver", "crashes", "exits", "exits-like-driver", "forges-and-exits", "forges-by-reflection", "forges-results", "hangs", "long-message",
    "odd-message", "odd-return", "overflows-stack", "stops", "throws-error", "throws-number",
}  # fmt: skip

# One attack per escape and limit; the short form runs each in the language that can do it most directly.
SHORT = {
    "java": ("reads-agent-key", "memory-direct", "forges-results", "exits-like-driver"),
    "cpp": ("memory-memfd", "memory-shared", "io-uring", "deep-folders", "forges-results"),
    "python": (
        "reads-processes", "writes-outside", "network-local", "user-namespaces", "kernel-calls", "fork-bomb", "orphans", "pipes-left",
        "closed-folders", "many-files", "much-disk", "memory-dev-shm", "floods-results", "forges-results", "hangs", "burns-threads",
    ),
}  # fmt: skip

MODEL = """<test_model>
  <name>Hostile</name>
  <target interface="InfraredSensorService" method="GetInfraredData"/>
  <input_spec_list>
    <test_element abstract_type="NUMERIC" real_type="int">
      <name>IndexOfSensor</name><type>TDI</type>
      <user_value_list><value>1</value><value>2</value><value>3</value></user_value_list>
    </test_element>
    <test_element abstract_type="NUMERIC" real_type="int">
      <name>NumOfSensor</name><type>TDI</type>
      <user_value_list><value>7</value></user_value_list>
    </test_element>
    <test_element abstract_type="NUMERIC" real_type="double">
      <name>Distance</name><type>TDSD</type>
      <user_value_list><value>5.0</value></user_value_list>
    </test_element>
  </input_spec_list>
  <output_spec_list>
    <test_element abstract_type="NUMERIC" real_type="double">
      <name>return</name><type>RETURN</type><expected>-1.0</expected>
    </test_element>
  </output_spec_list>
  <order_of_combinations>1</order_of_combinations>
</test_model>
"""

PROFILE = """name: hostile
component:
  language: {language}
  sources: component/
  class: {class_name}
  properties: {{Kind: {kind}}}
provided: [InfraredSensorService.xml]
world: world/ir.world.yaml
models: [Hostile.xml]
limits: {{case_wall_s: 3, case_sim_s: 10, memory_mb: 512}}
"""


def kinds(language):
    """The attacks of a language's component, in the order of its source."""
    if language == "python":
        source = (HERE / "components/python/hostile.py").read_text()
        methods = re.findall(r"^    def (\w+)\(", source[source.index("class Attacks") :], re.MULTILINE)
        return [name.replace("_", "-") for name in methods]
    if language == "java":
        source = next((HERE / "components/java").rglob("*.java")).read_text()
        labels = re.findall(r"^      case (.*?) ->", source, re.MULTILINE)
        return [kind for label in labels for kind in re.findall(r'"([a-z-]+)"', label)]
    source = (HERE / "components/cpp/hostile.cpp").read_text()
    listed = re.findall(r'^      \{"([a-z-]+)",', source[source.index("> all{") :], re.MULTILINE)
    return [*listed, "forges-results"]


def files_of(example):
    folder = EXAMPLES / example
    return {p.relative_to(folder).as_posix(): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


def archive(files):
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as out:
        for name in sorted(files):
            out.writestr(name, files[name])
    return content.getvalue()


def hostile_component(language, kind, ports):
    """The archive of an activity with one attack; `ports` must not be reachable."""
    example, class_name = LANGUAGES[language]
    files = {n: c for n, c in files_of(example).items() if n.startswith("world/") or n == "InfraredSensorService.xml"}
    folder = HERE / "components" / language
    for path in folder.rglob("*.*"):
        if path.is_file() and "__pycache__" not in path.parts:
            source = path.read_text().replace("@PORTS@", " ".join(map(str, ports)))
            files[f"component/{path.relative_to(folder).as_posix()}"] = source.encode()
    files["activity.yaml"] = PROFILE.format(language=language, class_name=class_name, kind=kind).encode()
    files["Hostile.xml"] = MODEL.encode()
    return archive(files)
