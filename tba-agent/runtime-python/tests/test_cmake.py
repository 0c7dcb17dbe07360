"""What is read of a CMakeLists.txt."""

from pathlib import Path

import pytest

from sitaf_ros.cpp.cmake import CMake


def cmake(tmp_path: Path, text: str) -> CMake:
    for name in ("main.cpp", "follower.cpp", "filter.cpp", "other.cpp", "version.hpp.in"):
        (tmp_path / name).write_text("")
    return CMake(text, tmp_path)


def names(found: CMake, tmp_path: Path) -> list[str]:
    return [unit.name for unit in found.units_of((tmp_path / "main.cpp").resolve())]


@pytest.mark.parametrize(
    "link",
    [
        "target_link_libraries(node follower)",
        "target_link_libraries(node PUBLIC follower rclcpp::rclcpp)",
        "add_library(robot::follower ALIAS follower)\ntarget_link_libraries(node PRIVATE robot::follower)",
    ],
)
def test_libraries_of_the_package_that_an_executable_links_are_compiled(tmp_path, link):
    found = cmake(
        tmp_path,
        "add_library(filter filter.cpp)\nadd_library(follower SHARED follower.cpp)\nadd_library(other other.cpp)\n"
        f"target_link_libraries(follower filter)\nadd_executable(node main.cpp)\n{link}\n",
    )
    assert names(found, tmp_path) == ["main.cpp", "follower.cpp", "filter.cpp"]


def test_libraries_that_link_each_other_are_compiled_once(tmp_path):
    found = cmake(
        tmp_path,
        "add_library(a main.cpp)\nadd_library(b follower.cpp)\n"
        "target_link_libraries(a b)\ntarget_link_libraries(b a)\n",
    )
    assert names(found, tmp_path) == ["main.cpp", "follower.cpp"]


@pytest.mark.parametrize(
    ("command", "headers"),
    [
        ("generate_export_header(Teleop)", ["teleop_export.h"]),
        (
            "generate_export_header(Teleop EXPORT_FILE_NAME ${PROJECT_NAME}/${PROJECT_NAME}_export.h)",
            ["robot/robot_export.h", "robot_export.h"],
        ),
        (
            "generate_export_header(T EXPORT_FILE_NAME ${CMAKE_CURRENT_BINARY_DIR}/include/robot/export.hpp)",
            ["export.hpp", "robot/export.hpp"],
        ),
        ("generate_export_header(T EXPORT_FILE_NAME ../../../etc/export.hpp)", ["etc/export.hpp", "export.hpp"]),
        ("configure_file(version.hpp.in ${CMAKE_BINARY_DIR}/robot/version.hpp)", ["robot/version.hpp", "version.hpp"]),
    ],
)
def test_generated_headers_are_below_their_folder_and_never_outside(tmp_path, command, headers):
    found = cmake(tmp_path, f"project(robot)\n{command}\n")
    assert sorted(found.generated_headers) == headers
