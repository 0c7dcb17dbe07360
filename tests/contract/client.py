"""A client with short names for the generated stubs."""

import json
import struct

from google.protobuf.duration_pb2 import Duration

from sitaf_bridge.wire import simulation_pb2 as pb
from sitaf_bridge.wire import simulation_pb2_grpc as pb_grpc


class Client:
    """One channel to a server."""

    def __init__(self, channel):
        self.channel = channel
        self.control = pb_grpc.SimulationControlStub(channel)
        self.hardware = pb_grpc.VirtualHardwareStub(channel)

    def open(self, world, seed=1, lease_s=None):
        lease = None if lease_s is None else Duration(seconds=int(lease_s), nanos=round(lease_s % 1 * 1e9))
        return Session(self, self.control.CreateSession(pb.CreateSessionRequest(world=world, seed=seed, lease=lease)))


class Session:
    """One session; calls an rpc by its name: session("StepSimulation", steps=1)."""

    def __init__(self, client, created):
        self.client = client
        self.created = created
        self.id = created.session_id
        self.timestep_ns = created.world.timestep_ns

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self("DeleteSession")

    def __call__(self, rpc, timeout=None, **fields):
        service = self.client.hardware if hasattr(self.client.hardware, rpc) else self.client.control
        request = getattr(pb, f"{rpc}Request")(session_id=self.id, **fields)
        return getattr(service, rpc)(request, timeout=timeout)

    def step(self, steps, **fields):
        return self("StepSimulation", steps=steps, **fields).state

    def prepare(self, settle_ns=0, **parameters):
        return self("Prepare", parameters=parameters, settle_ns=settle_ns).state

    def read(self, device):
        (reading,) = self("ReadDevices", devices=[device]).state.readings
        return getattr(reading, reading.WhichOneof("value"))

    def fault(self, device, *faults):
        messages = [pb.Fault(kind=pb.FaultKind.Value(f"FAULT_KIND_{kind}"), value=value) for kind, value in faults]
        return self("SetDeviceFault", device=device, faults=messages).state


def world(mjcf, description=""):
    """A world from the content of <mujoco> and a description without the `mjcf:` line."""
    files = {"w.world.yaml": f"mjcf: w.xml\n{description}".encode(), "w.xml": f"<mujoco>{mjcf}</mujoco>".encode()}
    return pb.WorldSource(description="w.world.yaml", files=files)


def folder(path):
    """The world in a folder."""
    files = {file.name: file.read_bytes() for file in path.iterdir() if file.is_file()}
    (description,) = (name for name in files if name.endswith(".world.yaml"))
    return pb.WorldSource(description=description, files=files)


def numbers(message):
    """All numbers of a state as bytes, for exact comparison."""
    return message.SerializeToString(deterministic=True)


class Gltf:
    """A binary glTF file, read according to its specification."""

    def __init__(self, content):
        magic, version, length = struct.unpack_from("<4sII", content)
        assert (magic, version, length) == (b"glTF", 2, len(content))
        size, kind = struct.unpack_from("<I4s", content, 12)
        assert kind == b"JSON"
        assert size % 4 == 0
        self.document = json.loads(content[20 : 20 + size])
        _, kind = struct.unpack_from("<I4s", content, 20 + size)
        assert kind == b"BIN\0"
        self._binary = content[28 + size :]
        assert len(self._binary) == self.document["buffers"][0]["byteLength"]
        self.extras = self.document["scenes"][0]["extras"]

    def nodes(self):
        """Nodes by name."""
        return {node["name"]: node for node in self.document["nodes"] if "name" in node}

    def view(self, index, form="f"):
        """The numbers of a buffer view."""
        view = self.document["bufferViews"][index]
        return struct.unpack_from(f"<{view['byteLength'] // 4}{form}", self._binary, view["byteOffset"])

    def rows(self, index):
        """The rows of an accessor."""
        accessor = self.document["accessors"][index]
        form, width = (
            {5126: "f", 5125: "I"}[accessor["componentType"]],
            {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[accessor["type"]],
        )
        numbers = self.view(accessor["bufferView"], form)
        assert len(numbers) == width * accessor["count"]
        return [numbers[first : first + width] for first in range(0, len(numbers), width)]

    def track(self, body, path):
        """Times in seconds and values of the animated channels."""
        (animation,) = self.document["animations"]
        names = [node.get("name") for node in self.document["nodes"]]
        for channel in animation["channels"]:
            if (names[channel["target"]["node"]], channel["target"]["path"]) == (body, path):
                sampler = animation["samplers"][channel["sampler"]]
                return [time for (time,) in self.rows(sampler["input"])], self.rows(sampler["output"])
        return None

    def corners(self, body):
        """All vertices of a body's solids, in the frame of the body; the solids must not be rotated."""
        found = []
        for child in self.nodes()[body].get("children", []):
            node = self.document["nodes"][child]
            if "mesh" in node:
                (primitive,) = self.document["meshes"][node["mesh"]]["primitives"]
                corners = self.rows(primitive["attributes"]["POSITION"])
                triangles = [index for (index,) in self.rows(primitive["indices"])]
                assert max(triangles) < len(corners)
                found += [
                    [c * s + t for c, s, t in zip(corner, node["scale"], node["translation"], strict=True)]
                    for corner in corners
                ]
        return found
