# MuJoCo ships no types. Only what annotations need is declared; the rest of its interface counts as Any.
from typing import Any

class MjModel:
    def __getattr__(self, name: str) -> Any: ...
    @staticmethod
    def from_xml_string(xml: str, assets: dict[str, bytes] | None = None) -> MjModel: ...
    @staticmethod
    def from_binary_path(filename: str, assets: dict[str, bytes] | None = None) -> MjModel: ...

class MjData:
    time: float
    def __init__(self, model: MjModel) -> None: ...
    def __getattr__(self, name: str) -> Any: ...

class FatalError(Exception): ...

class mjtObj:
    def __init__(self, value: int) -> None: ...
    def __getattr__(self, name: str) -> Any: ...
    mjOBJ_BODY: mjtObj
    mjOBJ_GEOM: mjtObj
    mjOBJ_JOINT: mjtObj
    mjOBJ_SENSOR: mjtObj
    mjOBJ_SITE: mjtObj
    mjOBJ_ACTUATOR: mjtObj
    mjOBJ_KEY: mjtObj
    mjOBJ_CAMERA: mjtObj
    mjOBJ_LIGHT: mjtObj
    mjOBJ_XBODY: mjtObj

class MjSpec:
    assets: dict[str, bytes]
    nuserdata: int
    def __getattr__(self, name: str) -> Any: ...
    @staticmethod
    def from_string(
        xml: str, include: dict[str, bytes] | None = None, assets: dict[str, bytes] | None = None
    ) -> MjSpec: ...

def __getattr__(name: str) -> Any: ...
