"""Records which hooks of its life cycle are called."""

from sitaf_interfaces import Place, Refused, Sensor


class Probe:
    """The probe of the compliance suite."""

    def __init__(self, sensor: Sensor) -> None:
        self._sensor = sensor
        self._life = ""

    def initialise(self) -> None:
        self._life += "initialise"

    def initialize(self) -> None:
        self._life += "initialize"

    def start(self) -> None:
        self._life += " start"

    def on_start(self) -> None:
        self._life += " onStart"

    def locate(self, kind: int) -> Place:
        if kind == 2:
            raise Refused("kind 2")
        return Place(self._sensor.read(0.5), 2, self._life)
