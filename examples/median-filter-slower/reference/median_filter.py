"""The reference: slow and obvious."""

import statistics


class NoReadings(Exception):
    """There is nothing to filter."""


class MedianFilter:
    def Median(self, readings):
        if not readings:
            raise NoReadings()
        return statistics.median(readings[-3:])
