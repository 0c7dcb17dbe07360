"""Uses names of its interface that Python does not allow."""

from sitaf_interfaces import Duration, TestStub_


class Probe:
    """The probe of the compliance suite."""

    def trace(self, given: Duration, whole: Duration) -> Duration:
        delete = TestStub_.None_ if whole.delete is TestStub_.None_ else whole.delete
        return Duration(from_=2 * given.from_, class_=whole.class_, delete=delete, pass_=whole.pass_)
