"""Folders of packages."""

from __future__ import annotations

import pathlib

from sitaf_ros.current import application


class PackageNotFoundError(KeyError):
    def __str__(self) -> str:
        known = ", ".join(sorted(application().share)) or "none"
        return f"\"package '{self.args[0]}' not found, known packages: [{known}]\""


def get_package_share_path(package_name: str, print_warning: bool = True) -> pathlib.Path:
    folder = application().share.get(package_name)
    if folder is None:
        if package_name in application().classes.packages:
            return pathlib.Path("/opt/ros/jazzy/share") / package_name
        raise PackageNotFoundError(package_name)
    return folder


def get_package_share_directory(package_name: str, print_warning: bool = True) -> str:
    return str(get_package_share_path(package_name))


def get_package_prefix(package_name: str) -> str:
    return str(get_package_share_path(package_name))


def get_packages_with_prefixes() -> dict[str, str]:
    return {name: str(folder) for name, folder in sorted(application().share.items())}


def get_search_paths() -> list[str]:
    return sorted({str(folder) for folder in application().share.values()})
