"""Resources of the index: packages only."""

from __future__ import annotations

from .packages import get_packages_with_prefixes


def get_resources(resource_type: str) -> dict[str, str]:
    return get_packages_with_prefixes() if resource_type == "packages" else {}


def has_resource(resource_type: str, resource_name: str) -> str | bool:
    return get_resources(resource_type).get(resource_name, False)


def get_resource(resource_type: str, resource_name: str) -> tuple[str, str]:
    found = get_resources(resource_type)
    if resource_name not in found:
        raise LookupError(f"Could not find the resource '{resource_name}' of type '{resource_type}'")
    return "", found[resource_name]
