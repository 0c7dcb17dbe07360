"""Thin names over the generated stubs."""

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
    """One session; a call by the name of its rpc: session("StepSimulation", steps=1)."""

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
    """A world of the content of <mujoco>, and a description without its `mjcf:` line."""
    files = {"w.world.yaml": f"mjcf: w.xml\n{description}".encode(), "w.xml": f"<mujoco>{mjcf}</mujoco>".encode()}
    return pb.WorldSource(description="w.world.yaml", files=files)


def folder(path):
    """The world of a folder that holds one."""
    files = {file.name: file.read_bytes() for file in path.iterdir() if file.is_file()}
    (description,) = (name for name in files if name.endswith(".world.yaml"))
    return pb.WorldSource(description=description, files=files)


def numbers(message):
    """All numbers of a state as bytes, to compare to the last bit."""
    return message.SerializeToString(deterministic=True)
