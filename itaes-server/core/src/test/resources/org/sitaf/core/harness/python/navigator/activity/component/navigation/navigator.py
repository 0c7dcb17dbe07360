"""One step of a navigation."""

from sitaf_interfaces import Lost, Mode, NoEcho, Point, RangeFinder, Route, Wheels


class Navigator:
    """Goes along a route."""

    max_speed = 1.0
    label = ""

    def __init__(self, finder: RangeFinder, wheels: Wheels) -> None:
        self._finder = finder
        self._wheels = wheels
        self._mode = Mode.IDLE

    def configure(self, mode: Mode, gain: float, side: str) -> None:
        """Set the mode."""
        assert (gain, side) == (1.5, "left")
        self._mode = mode

    def step(
        self, route: Route, gain: float, weights: list[int], heading: float
    ) -> tuple[int, Point, float]:
        """Drive as far as the range finder sees."""
        if not route.points:
            raise Lost("there is no route")
        try:
            ahead = self._finder.RangeAhead(heading)
        except NoEcho:
            ahead = self._finder.range_ahead(-heading)
        left_is_free, left, _ = self._finder.beams(1)
        self._wheels.Drive(self.max_speed, ahead)
        assert not left_is_free
        assert left == 0.75
        assert self._mode is Mode.BUSY
        assert self.label == 'a "quoted" one'
        return len(weights), route.points[-1], heading * 2
