"""Adapts statemachine.StateMachine to the interface Lights."""

from statemachine import State, StateMachine


class Light(StateMachine):
    """A light that is green or red, and notes its name when it changes."""

    green = State("Green", initial=True)
    red = State("Red")
    stop = green.to(red)
    go = red.to(green)

    def __init__(self, name: str, notified: list[str]) -> None:
        self._name = name
        self._notified = notified
        super().__init__()

    def on_exit_green(self) -> None:
        self._notified.append(self._name)

    def on_exit_red(self) -> None:
        self._notified.append(self._name)

    def switch(self) -> None:
        """Change to the other colour."""
        if self.current_state == self.green:
            self.stop()
        else:
            self.go()


class Lights:
    """One light, and later two."""

    def __init__(self) -> None:
        self._notified: list[str] = []
        self._lights = [Light("first", self._notified)]

    def add_second(self) -> None:
        self._lights.append(Light("second", self._notified))

    def switch_first(self) -> str:
        return self._switch(0)

    def switch_second(self) -> str:
        return self._switch(1)

    def _switch(self, index: int) -> str:
        self._notified.clear()
        self._lights[index].switch()
        return " ".join(self._notified)
