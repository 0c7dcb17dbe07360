"""Reads what matters of a CMakeLists.txt: targets with their sources, components, folders and generated headers."""

from __future__ import annotations

import re
from pathlib import Path

_COMMAND = re.compile(r"^[ \t]*(\w+)[ \t]*\(([^()]*(?:\([^()]*\)[^()]*)*)\)", re.M | re.S)
_WORD = re.compile(r'"((?:[^"\\]|\\.)*)"|([^\s"]+)')
_VARIABLE = re.compile(r"\$\{(\w+)\}")
_GENERATOR = re.compile(r"\$<BUILD_INTERFACE:([^>]*)>")
_TARGETS = (
    "add_library",
    "add_executable",
    "ament_auto_add_library",
    "ament_auto_add_executable",
    "target_sources",
    "target_link_libraries",
)
# find_package names and those of pkg-config.
_SYSTEM = {
    "eigen3": "eigen3",
    "tf2_eigen": "eigen3",
    "eigen3_cmake_module": "eigen3",
    "fmt": "fmt",
    "yaml-cpp": "yaml-cpp",
    "yaml_cpp_vendor": "yaml-cpp",
    "nlohmann_json": "nlohmann_json",
    "tinyxml2": "tinyxml2",
    "spdlog": "spdlog",
    "orocos_kdl": "orocos-kdl",
    "opencv": "opencv4",
}


class CMake:
    """The content of a file; an empty text has no targets."""

    def __init__(self, text: str, folder: Path) -> None:
        self._folder = folder
        self.targets: dict[str, list[Path]] = {}
        self.components: dict[str, str] = {}
        self.include_folders: list[Path] = []
        self.definitions: list[str] = []
        self.generated_headers: dict[str, str] = {}
        self.configured: list[tuple[Path, str]] = []
        self.system_packages: list[str] = []
        self.standard = 0
        self._links: dict[str, list[str]] = {}
        self._aliases: dict[str, str] = {}
        self._variables = {
            "CMAKE_CURRENT_SOURCE_DIR": str(folder),
            "CMAKE_SOURCE_DIR": str(folder),
            "PROJECT_SOURCE_DIR": str(folder),
        }
        for match in _COMMAND.finditer(re.sub(r"#[^\n]*", "", text)):
            words = [quoted or plain for quoted, plain in _WORD.findall(match[2])]
            self._command(match[1].lower(), [part for word in words for part in self._expanded(word)])

    def _expanded(self, word: str) -> list[str]:
        word = _GENERATOR.sub(lambda m: m[1], word)
        word = _VARIABLE.sub(lambda m: self._variables.get(m[1], ""), word)
        return [part for part in word.split(";") if part]

    def _command(self, name: str, words: list[str]) -> None:
        if name == "project" and words:
            self._variables["PROJECT_NAME"] = words[0]
        elif name == "set" and words:
            self._variables[words[0]] = ";".join(words[1:])
            if words[0] == "CMAKE_CXX_STANDARD" and len(words) > 1 and words[1].isdigit():
                self.standard = int(words[1])
        elif name == "find_package" and words and words[0].lower() in _SYSTEM:
            self.system_packages.append(_SYSTEM[words[0].lower()])
        elif name in _TARGETS and words:
            self._target(name, words)
        elif name in ("include_directories", "target_include_directories"):
            kept = words[1:] if name.startswith("target") else words
            self.include_folders += [self._folder / w for w in kept if (self._folder / w).is_dir()]
        elif name in ("add_definitions", "target_compile_definitions", "add_compile_definitions"):
            kept = words[1:] if name.startswith("target") else words
            found = [w.removeprefix("-D") for w in kept if w not in ("PRIVATE", "PUBLIC", "INTERFACE")]
            self.definitions += [w for w in found if re.fullmatch(r"\w+(=[^\n]*)?", w)]
        elif name == "target_compile_features":
            found = [int(w.removeprefix("cxx_std_")) for w in words if re.fullmatch(r"cxx_std_\d+", w)]
            self.standard = max([self.standard, *found])
        elif name.startswith("rclcpp_components_register_node") and words:
            self._component(words)
        elif name == "generate_export_header" and words:
            self._export_header(words)
        elif name == "configure_file" and len(words) > 1 and (self._folder / words[0]).is_file():
            for file in _generated(words[1]):
                self.configured.append((self._folder / words[0], file))
                self.generated_headers[file] = ""

    def _target(self, name: str, words: list[str]) -> None:
        if name == "target_link_libraries":
            self._links.setdefault(words[0], []).extend(words[1:])
        elif words[1:2] == ["ALIAS"] and len(words) > 2:
            self._aliases[words[0]] = words[2]
        else:
            self.targets.setdefault(words[0], []).extend(self._files(words[1:]))

    def _files(self, words: list[str]) -> list[Path]:
        return [(self._folder / word).resolve() for word in words if (self._folder / word).is_file()]

    def _component(self, words: list[str]) -> None:
        if "PLUGIN" in words and words.index("PLUGIN") + 1 < len(words):
            self.components[words[words.index("PLUGIN") + 1]] = words[0]

    def _export_header(self, words: list[str]) -> None:
        named = dict(zip(words[1::2], words[2::2], strict=False))
        base = named.get("BASE_NAME", words[0])
        macro = named.get("EXPORT_MACRO_NAME", f"{base.upper()}_EXPORT")
        upper = base.upper()
        text = (
            f"#pragma once\n#define {macro}\n#define {upper}_NO_EXPORT\n#define {upper}_DEPRECATED\n"
            f"#define {upper}_DEPRECATED_EXPORT\n"
        )
        for file in _generated(named.get("EXPORT_FILE_NAME", f"{base.lower()}_export.h")):
            self.generated_headers[file] = text

    def variable(self, name: str) -> str:
        """Return the value of a variable; empty if it is not set."""
        return self._variables.get(name, "")

    def units_of(self, file: Path) -> list[Path]:
        """Return the sources of the targets that hold a file, which is the first, and of what they link."""
        pending = [name for name, sources in self.targets.items() if file in sources]
        reached: list[str] = []
        while pending:
            name = self._aliases.get(pending[0], pending[0])
            pending = pending[1:]
            if name in self.targets and name not in reached:
                reached.append(name)
                pending += self._links.get(name, [])
        units = [file]
        for source in (s for name in reached for s in self.targets[name]):
            if source not in units and source.suffix in (".cpp", ".cc", ".cxx", ".c++", ".C"):
                units.append(source)
        return units


def _generated(name: str) -> list[str]:
    """The names by which a generated header can be included: in its folder below the build folder, and alone."""
    parts = [part for part in Path(name).parts if part not in ("/", "..")]
    whole = "/".join(parts[1:] if parts[:1] == ["include"] else parts)
    return sorted({whole, parts[-1]}) if parts else []
