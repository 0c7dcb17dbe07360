"""Draws a world at one moment as a scene."""

from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray

from sitaf_bridge.world.scene import shapes
from sitaf_bridge.world.scene.glb import Glb
from sitaf_bridge.world.scene.shapes import Shape
from sitaf_bridge.world.world import World

Geom = mujoco.mjtGeom
# MuJoCo's default color; a geom of this color uses that of its material.
GREY = (0.5, 0.5, 0.5, 1.0)
# Metres from the centre to the edge of an infinite plane.
HORIZON = 10.0
# Geom groups that MuJoCo's own viewers show; models use others for collision geoms.
SHOWN_GROUPS = 3
# Turns the world's z to glTF's y: quaternion x, y, z, w.
Z_UP = [-(0.5**0.5), 0.0, 0.0, 0.5**0.5]


def draw(world: World, model: mujoco.MjModel, data: mujoco.MjData) -> Glb:
    """The scene. Raises LimitReached."""
    return Stage(world, model).at(data)[0]


class Stage:
    """The drawing of a world without the poses of its bodies. Raises LimitReached."""

    def __init__(self, world: World, model: mujoco.MjModel) -> None:
        self._world = world
        self._model = model
        self._sizes = model.geom_size.tobytes()
        self._glb = Glb()
        self._nodes = self._draw()

    def shows(self, world: World, model: mujoco.MjModel) -> bool:
        """Whether the drawing is up to date: parameters can change only the sizes of geoms."""
        return world is self._world and model is self._model and model.geom_size.tobytes() == self._sizes

    def at(self, data: mujoco.MjData) -> tuple[Glb, list[int]]:
        """The scene at a moment, and the node of each body by its id; the world's node is the root."""
        glb = self._glb.copy()
        for node, place, turn in zip(self._nodes[1:], data.xpos[1:].tolist(), data.xquat[1:].tolist(), strict=True):
            entry = glb.entry("nodes", node)
            entry["translation"], entry["rotation"] = place, xyzw(turn)
        return glb, self._nodes

    def _draw(self) -> list[int]:
        glb, model, world = self._glb, self._model, self._world
        pencil = _GeomDrawer(glb, model)
        nodes = [glb.add("nodes", name="world", rotation=Z_UP)]
        glb.add_root(nodes[0])
        children: list[list[int]] = [[]]
        for body in range(1, model.nbody):
            # The pose is set later; the order of keys must not change.
            nodes.append(glb.add("nodes", name=body_name(model, body), translation=None, rotation=None))
            children[0].append(nodes[-1])
            children.append([])
        for geom in _shown(model):
            node = pencil.node(geom)
            if node is not None:
                children[int(model.geom_bodyid[geom])].append(node)
        devices: list[dict[str, Any]] = []
        for device in world.description.devices.values():
            entry: dict[str, Any] = {"name": device.name, "kind": device.kind}
            site = _site(model, device)
            if site >= 0:
                body = int(model.site_bodyid[site])
                entry["body"] = body_name(model, body)
                place = glb.add(
                    "nodes",
                    translation=model.site_pos[site].tolist(),
                    rotation=xyzw(model.site_quat[site]),
                    extras={"device": device.name, "kind": device.kind},
                )
                children[body].append(place)
            devices.append(entry)
        for node, inside in zip(nodes, children, strict=True):
            if inside:
                glb.entry("nodes", node)["children"] = inside
        glb.extras = {"world": world.description.file, "digest": world.digest, "devices": devices}
        return nodes


def body_name(model: mujoco.MjModel, body: int) -> str:
    """The name of a body, or one derived from its id."""
    if body == 0:
        return "world"
    return mujoco.mj_id2name(model, mujoco.mjtObj.mjOBJ_BODY, body) or f"body_{body}"


def xyzw(quaternion: Any) -> list[float]:
    """Convert a quaternion from MuJoCo's order to glTF's."""
    w, x, y, z = (float(part) for part in quaternion)
    return [x, y, z, w]


def _shown(model: mujoco.MjModel) -> list[int]:
    """The geoms to draw: those of each body in the visible groups, or all if it has none of them."""
    every = range(model.ngeom)
    in_view = {g for g in every if model.geom_group[g] < SHOWN_GROUPS}
    dressed = {int(model.geom_bodyid[g]) for g in in_view}
    return [g for g in every if g in in_view or int(model.geom_bodyid[g]) not in dressed]


def _site(model: mujoco.MjModel, device: object) -> int:
    """The site of a device; -1 if it has none."""
    name = getattr(device, "site", None)
    if name is not None:
        return mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_SITE, name)
    sensor = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_SENSOR, getattr(device, "sensor", ""))
    return int(model.sensor_objid[sensor]) if sensor >= 0 else -1


class _GeomDrawer:
    """Draws geoms; each shape and color is stored once."""

    def __init__(self, glb: Glb, model: mujoco.MjModel) -> None:
        self._glb = glb
        self._model = model
        self._shapes: dict[object, dict[str, Any]] = {}
        self._materials: dict[tuple[float, ...], int] = {}
        self._meshes: dict[tuple[object, int], int] = {}

    def node(self, geom: int) -> int | None:
        """A geom as a node in the frame of its body; None if it is invisible."""
        model = self._model
        colour = self._colour(geom)
        form = self._form(geom)
        if colour[3] == 0 or form is None:
            return None
        key, shape, scale = form
        material = self._material(colour)
        if (key, material) not in self._meshes:
            primitive = {**self._primitive(key, shape), "material": material}
            self._meshes[key, material] = self._glb.add("meshes", primitives=[primitive])
        return self._glb.add(
            "nodes",
            mesh=self._meshes[key, material],
            translation=model.geom_pos[geom].tolist(),
            rotation=xyzw(model.geom_quat[geom]),
            scale=scale,
        )

    def _primitive(self, key: object, shape: Shape) -> dict[str, Any]:
        if key not in self._shapes:
            attributes = {"POSITION": self._glb.accessor(shape.positions)}
            if shape.normals is not None:
                attributes["NORMAL"] = self._glb.accessor(shape.normals)
            indices = self._glb.accessor(shape.triangles.ravel())
            self._shapes[key] = {"attributes": attributes, "indices": indices}
        return self._shapes[key]

    def _form(self, geom: int) -> tuple[object, Shape, list[float]] | None:
        """A key of the shape, the shape, and its scale along x, y, z."""
        model = self._model
        kind = Geom(int(model.geom_type[geom]))
        first, second, third = model.geom_size[geom].tolist()
        index = int(model.geom_dataid[geom])
        match kind:
            case Geom.mjGEOM_PLANE:
                return kind, shapes.plane(), [first or HORIZON, second or HORIZON, 1.0]
            case Geom.mjGEOM_BOX:
                return kind, shapes.box(), [first, second, third]
            case Geom.mjGEOM_SPHERE:
                return kind, shapes.sphere(), [first, first, first]
            case Geom.mjGEOM_ELLIPSOID:
                return Geom.mjGEOM_SPHERE, shapes.sphere(), [first, second, third]
            case Geom.mjGEOM_CYLINDER:
                return kind, shapes.cylinder(), [first, first, second]
            case Geom.mjGEOM_CAPSULE:
                return (kind, first, second), shapes.capsule(first, second), [1.0, 1.0, 1.0]
            case Geom.mjGEOM_MESH:
                return (kind, index), shapes.mesh(model, index), [1.0, 1.0, 1.0]
            case Geom.mjGEOM_HFIELD:
                return (kind, index), shapes.height_field(model, index), [1.0, 1.0, 1.0]
            case _:
                return None

    def _colour(self, geom: int) -> tuple[float, ...]:
        model = self._model
        own = _rounded(model.geom_rgba[geom])
        material = int(model.geom_matid[geom])
        if material >= 0 and own == GREY:
            return _rounded(model.mat_rgba[material])
        return own

    def _material(self, colour: tuple[float, ...]) -> int:
        if colour not in self._materials:
            *shade, alpha = colour
            # glTF colors are linear, MJCF colors are sRGB.
            linear = [max(part, 0.0) ** 2.2 for part in shade]
            self._materials[colour] = self._glb.add(
                "materials",
                pbrMetallicRoughness={
                    "baseColorFactor": [*linear, alpha],
                    "metallicFactor": 0.0,
                    "roughnessFactor": 0.8,
                },
                alphaMode="OPAQUE" if alpha == 1 else "BLEND",
                doubleSided=True,
            )
        return self._materials[colour]


def _rounded(colour: NDArray[np.float32]) -> tuple[float, ...]:
    return tuple(round(float(part), 6) for part in colour)
