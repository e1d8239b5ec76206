"""The line about the lever arm comes where the lever arm is wrong, and nowhere else."""

import numpy as np
import pytest

from boresight.evidence.flights.conditions import during, latency, turned, with_field
from boresight.evidence.flights.fly import fly
from boresight.evidence.flights.motion import DEG, Motion, swinging, waves

RUNS, LEVER = 6, np.array([1.2, -2.4, 1.8])
SWING = swinging(seconds=42)
ROLL = Motion(swing=waves(([6 * DEG, 0, 0], 0.1, [0, 0, 0])), steady=np.array([8.0, 0, 0]), seconds=42)


def blamed(flight):
    return {int(run) for note in flight.loop.notes if "compare the lever arm" in note.text for run in note.runs}


@pytest.mark.parametrize(("motion", "off", "told"), [(SWING, [0, 2, 0], RUNS), (SWING, [2, 0, 0], RUNS),
                                                     (ROLL, [0, 2, 0], RUNS // 2)],
                         ids=["swing, right", "swing, front", "slow roll, right"])  # fmt: skip
def test_two_metres_are_told_though_the_slave_is_opened_and_follows_the_master(motion, off, told):
    flight = fly(motion, runs=RUNS, seconds=40.0, lost=0.0, constants={"lever_b": LEVER + np.array(off)})
    assert any("opened" in note.text for note in flight.loop.notes)
    assert len(blamed(flight)) >= told


@pytest.mark.parametrize("said", [
    lambda: None, lambda: during(8, 99, with_field(v_m_n=lambda v: v + np.array([1.0, 0, 0]))),
    lambda: during(8, 99, turned([0, 0, -5])), lambda: latency(10e-3),
], ids=["nothing", "velocity", "heading", "latency"])  # fmt: skip
def test_another_fault_is_not_told_as_the_lever_arms(said):
    assert not blamed(fly(SWING, runs=RUNS, seconds=40.0, lost=0.0, said=said()))
