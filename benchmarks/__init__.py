"""Side by side in one run, reported as ratios: nothing here is a test.

How all benchmarks time from Python: by processor time, the candidates interleaved, medians over the rounds.
"""

import time
from collections.abc import Callable, Hashable, Mapping
from statistics import median
from typing import Any, TypeVar

Key = TypeVar("Key", bound=Hashable)


def interleaved(functions: Mapping[Key, Callable[[], Any]], rounds: int = 15, slot: float = 4e-3) -> dict[Key, float]:
    """Seconds of one call of each, the loop's own cost included.  slot: seconds that a round gives each."""

    def spent(function: Callable[[], Any], calls: int) -> float:
        start = time.process_time()
        for _ in range(calls):
            function()
        return time.process_time() - start

    calls = dict.fromkeys(functions, 1)
    for key, function in functions.items():
        function()
        while spent(function, calls[key]) < slot / 2:
            calls[key] *= 2
    found: dict[Key, list[float]] = {key: [] for key in functions}
    for _ in range(rounds):
        for key, function in functions.items():
            found[key].append(spent(function, calls[key]) / calls[key])
    return {key: median(values) for key, values in found.items()}
