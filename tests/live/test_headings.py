"""A bank of live loops without a master's heading, by flights that share nothing with it."""

import numpy as np
import pytest
from conditions import condition
from judge import errors_of, nees
from loops import MODEL, sigmas, start, true_of
from simulator import matrix_of_quaternion

from boresight import BoresightError, Headings, rotation


def flown(motion, seconds, runs=3):
    """Each run by a bank whose first heading is drawn from all round: errors (runs, 16), P, the banks."""
    flight, errors, P, banks = condition(f"healthy, {motion}").flight(runs=runs, seconds=seconds), [], [], []
    constants = flight.setting.constants()
    lever_b = constants.pop("lever_b")
    for run in range(runs):
        bank, begun, k = Headings(MODEL, **constants), False, -1
        anywhere = np.array([1.0, 1.0, 0.0]), np.array([0.0, 0.0, np.random.default_rng(run).uniform(-np.pi, np.pi)])
        for kind, at_us, *given in flight.events(run):
            if kind == "sample":
                k += 1
                if begun:
                    bank.sample(at_us, given[0], dtheta_ib_b=given[1], dv_b=given[2])
                continue
            fields, R = given[0], given[0]["R"]
            euler = rotation.euler_from_matrix(matrix_of_quaternion(fields["q_m2n_wxyz"])) * anywhere[0] + anywhere[1]
            if begun:
                bank.message("velocity", at_us, R[:3], v_m_n=fields["v_m_n"], lever_b=lever_b)
                bank.message("euler", at_us, R[3:], rows=3, euler_m=euler)
            else:
                wrong = fields | {"q_m2n_wxyz": rotation.quaternion_from_euler(euler)}
                bank.begin(int(flight.end_us[k]), start(wrong, flight, run), **sigmas(flight))
                begun = True
        nav = {name: np.asarray(value)[None] for name, value in bank.output(int(flight.end_us[k])).items()}
        errors.append(errors_of(nav, true_of(flight, k, [run]))[0])
        P.append(bank.likeliest.covariance()[0])
        banks.append(bank)
    return np.array(errors), np.array(P), banks


def test_a_heading_that_nobody_gives_is_found_from_all_round_and_the_loop_that_goes_on_is_consistent():
    errors, P, banks = flown("s-turns", 14.0)
    assert all(bank.settled for bank in banks)
    assert any("one loop goes on in place of 48" in line for line in banks[0].events())
    assert nees(errors, P).mean() < 28 and (np.abs(errors[:, 2]) < 4 * np.sqrt(P[:, 2, 2])).all()
    assert (np.sqrt(P[:, 2, 2]) < 1e-3).all()


def test_a_vehicle_that_does_not_accelerate_keeps_all_its_headings():
    _, _, banks = flown("parked", 6.0, runs=1)
    assert not banks[0].settled and banks[0].weight.max() < 0.5
    assert banks[0].output(6_000_000)["sigma"][2] > 0.5


def test_a_model_without_an_attitude_is_refused():
    with pytest.raises(BoresightError, match="does not carry q_b2n_wxyz with its errors phi"):
        Headings("velocity-dcm")
