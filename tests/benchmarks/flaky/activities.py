"""Components of the benchmark, and the activities that test them.

A component without a world estimates a value from the number of a step; one with a world moves a joint to an angle.
"""

import os
import shutil
import textwrap
from dataclasses import dataclass
from pathlib import Path
from string import Template

WORLD = Path(os.environ["SITAF_HOME"]) / "examples" / "joint-settling" / "world"
STEPS = range(1, 6)
ANGLES = (0.2, 0.4, 0.6, 0.8)


@dataclass(frozen=True)
class Component:
    """A component under test."""

    name: str
    body: str  # of its method, in its language
    language: str = ""
    helpers: str = ""  # in front of the method: functions in Python and C++, members in Java
    cause: str = ""  # what makes it unstable; empty if it is stable
    returns: str = "double"
    world: bool = False
    noise: float = 0  # of the joint's encoder
    limit_s: float = 20  # time limit of a case
    keys: str = ""  # further keys of `component`


MOVE_IDL = "interface Joint { double Move(in double angle); };\n"
ESTIMATE_IDL = "interface Estimator { %s Estimate(in long step); };\n"

ACTIVITY = Template("""name: $name
component: {language: $language, sources: component/, class: $class_name$keys}
provided: [service.idl]
models: [Model.xml]
limits: {case_wall_s: $limit_s}
$world""")

MODEL = Template("""<test_model><name>Model</name><target interface="$interface" method="$method"$run_for/>
<input_spec_list><test_element abstract_type="NUMERIC" real_type="$type"><name>$input</name><type>TDI</type>
<user_value_list>$values</user_value_list></test_element></input_spec_list>
<output_spec_list><test_element abstract_type="$abstract" real_type="$returns"><name>return</name><type>RETURN</type>
</test_element>$observed</output_spec_list><order_of_combinations>1</order_of_combinations></test_model>
""")

OBSERVED = """<test_element abstract_type="NUMERIC" real_type="double"><name>angle_held</name><type>OBSERVED</type>
</test_element>"""

PYTHON = Template("""import concurrent.futures
import datetime
import enum
import logging
import math
import os
import random
import secrets
import sys
import tempfile
import threading
import time
import uuid

$helpers


class Component:
$constructor
    def $method(self, $input):
$body
""")

JAVA = Template("""package planted;

import java.nio.file.*;
import java.security.SecureRandom;
import java.time.*;
import java.util.*;
import java.util.concurrent.*;
import java.util.concurrent.atomic.*;
import java.util.concurrent.locks.*;
import java.util.stream.*;
$import_hardware

public final class Component {
$constructor
$helpers

  public $type $method($input_type $input) throws Exception {
$body
  }
}
""")

CPP_HEADER = Template("""#pragma once

#include <cstdint>
#include <string>
$include

namespace planted {

class Component {
 public:
$constructor
  $type $method($input_type $input);
$members
};

}  // namespace planted
""")

CPP = Template("""#include "component.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <future>
#include <memory>
#include <mutex>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <unordered_map>
#include <unordered_set>
#include <vector>

using namespace std::chrono_literals;

namespace {

$helpers

}  // namespace

$type planted::Component::$method($input_type $input) {
$body
}
""")

PYTHON_HARDWARE = """    def __init__(self, hardware):
        self.hardware = hardware
        self.motor = hardware.joint_motor("motor")
        self.encoder = hardware.joint_encoder("encoder")
"""

JAVA_HARDWARE = """  private final Hardware hardware;
  private final JointMotor motor;
  private final JointEncoder encoder;

  public Component(Hardware hardware) {
    this.hardware = hardware;
    motor = hardware.jointMotor("motor");
    encoder = hardware.jointEncoder("encoder");
  }
"""

JAVA_IMPORTS = """import org.sitaf.runtime.Hardware;
import org.sitaf.runtime.actuator.JointMotor;
import org.sitaf.runtime.sensor.JointEncoder;"""

CPP_HARDWARE = """  explicit Component(sitaf::Hardware& hardware)
      : hardware(hardware), motor(hardware.jointMotor("motor")), encoder(hardware.jointEncoder("encoder")) {}
"""

CPP_MEMBERS = """
 private:
  sitaf::Hardware& hardware;
  sitaf::JointMotor& motor;
  sitaf::JointEncoder& encoder;"""


def indented(text, columns):
    return textwrap.indent(textwrap.dedent(text).strip("\n"), " " * columns)


def sources(component):
    """The source files of a component by their names, and the name of its class."""
    world = component.world
    helpers = textwrap.dedent(component.helpers).strip("\n")
    if component.language == "python":
        text = PYTHON.substitute(
            helpers=helpers,
            constructor=PYTHON_HARDWARE if world else "",
            method="move" if world else "estimate",
            input="angle" if world else "step",
            body=indented(component.body, 8),
        )
        return {"planted.py": text}, "planted.Component"
    parts = {
        "helpers": helpers,
        "method": "Move" if world else "Estimate",
        "input": "angle" if world else "step",
    }
    if component.language == "java":
        text = JAVA.substitute(
            parts,
            import_hardware=JAVA_IMPORTS if world else "",
            constructor=JAVA_HARDWARE if world else "",
            type={"string": "String"}.get(component.returns, component.returns),
            input_type="double" if world else "int",
            body=indented(component.body, 4),
        )
        return {"planted/Component.java": text}, "planted.Component"
    parts["type"] = {"string": "std::string"}.get(component.returns, component.returns)
    parts["input_type"] = "double" if world else "std::int32_t"
    header = CPP_HEADER.substitute(
        parts,
        include='#include "sitaf/hardware.hpp"' if world else "",
        constructor=CPP_HARDWARE if world else "",
        members=CPP_MEMBERS if world else "",
    )
    return {
        "component.hpp": header,
        "component.cpp": CPP.substitute(parts, body=indented(component.body, 2)),
    }, "planted::Component"


def write(component, folder):
    """Write the activity of a component to a new folder."""
    files, class_name = sources(component)
    for name, text in files.items():
        file = folder / "component" / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    activity = ACTIVITY.substitute(
        name=component.name,
        language=component.language,
        class_name=class_name,
        keys=component.keys,
        limit_s=component.limit_s,
        world="world: world/joint.world.yaml" if component.world else "",
    )
    (folder / "activity.yaml").write_text(activity)
    (folder / "service.idl").write_text(MOVE_IDL if component.world else ESTIMATE_IDL % component.returns)
    model = MODEL.substitute(
        interface="Joint" if component.world else "Estimator",
        method="Move" if component.world else "Estimate",
        input="angle" if component.world else "step",
        type="double" if component.world else "long",
        values="".join(f"<value>{each}</value>" for each in (ANGLES if component.world else STEPS)),
        abstract="STRING" if component.returns == "string" else "NUMERIC",
        returns=component.returns,
        run_for=' run_for="0.3"' if component.world else "",
        observed=OBSERVED if component.world else "",
    )
    (folder / "Model.xml").write_text(model)
    if component.world:
        shutil.copytree(WORLD, folder / "world")
        if component.noise:
            world = folder / "world" / "joint.world.yaml"
            plain = "kind: joint_encoder, joint: elbow"
            text = world.read_text()
            if plain not in text:
                raise RuntimeError(f"{WORLD}: no encoder of the joint elbow")
            world.write_text(text.replace(plain, f"{plain}, noise: {component.noise}"))
    return folder
