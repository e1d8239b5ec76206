"""The list of the conditions: each makes a flight that a loop can take, and changes what it says."""

from dataclasses import fields, replace

import numpy as np
import pytest
from conditions import CONDITIONS, unchanged


@pytest.fixture(scope="module", params=CONDITIONS, ids=lambda one: one.name)
def one(request):
    return request.param


def test_names_are_unique_and_what_is_asked_is_known():
    assert len({one.name for one in CONDITIONS}) == len(CONDITIONS)
    assert {one.asked for one in CONDITIONS} == {"consistent", "informed", "recovers", "named"}


def arrays(part):
    return {f.name: getattr(part, f.name) for f in fields(part) if isinstance(getattr(part, f.name), np.ndarray)}


def test_a_condition_makes_a_flight_and_changes_it(one):
    # what is flown for minutes, so that many messages show it, is made and changed alike in the first of them
    short = {"runs": 2, "seconds": min(one.setting.get("seconds", 40.0), 60.0)}
    flight, healthy = one.flight(**short), replace(one, change=unchanged).flight(**short)
    K, M = len(flight.end_us), len(flight.messages.after)
    assert {len(array) for name, array in arrays(flight).items() if name in ("dt", "clock", "dtheta", "dv")} == {K}
    assert {len(array) for array in arrays(flight.messages).values()} == {M}
    assert (np.diff(flight.end) > 0).all() and 0 <= flight.messages.after.min() < flight.messages.after.max() < K
    # the second half and the last five seconds have messages to be judged by
    assert (flight.end[flight.messages.after] > flight.setting.seconds - 5).sum() > 3
    events = [event[0] for event in flight.events(1)]
    assert events.count("sample") == K and events.count("message") == flight.messages.came[:, 1].sum()
    same = all(
        np.array_equal(array, arrays(of)[name], equal_nan=True)
        for part, of in ((flight, healthy), (flight.messages, healthy.messages))
        for name, array in arrays(part).items()
    )
    assert same == (one.change is unchanged)
