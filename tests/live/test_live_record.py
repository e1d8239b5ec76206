"""What a record holds of a live loop, and its smoothed flight beside the truth of a simulator that shares nothing.

PYTHONPATH=tests python tests/live/test_live_record.py RUNS [WORDS ...] flies conditions whose name holds a word.
"""

import copy
import sys
from unittest import mock

import numpy as np
import pytest
from conditions import CONDITIONS
from judge import N, errors_of
from loops import fly_live, true_of
from scipy.stats import chi2
from test_live import NAMED, fly, loop_of

from boresight import BoresightError, Live, Record, load, smooth


def recorded(name, runs, **changes):
    """A condition's flight, and the record of each run."""
    condition, records = NAMED[name], []

    def noted(*args, **words):
        loop = Live(*args, **words)
        records.append(Record(loop))
        return loop

    flight = condition.flight(runs=runs, **changes)
    with mock.patch("loops.Live", noted):
        found = fly_live(flight, carrying=condition.carrying)
    assert not found.raised
    return flight, records


def normalised(flight, run, record, made, count=9):
    """NEES of a record or of what is smoothed of it, at so many ends of samples from the start to the end."""
    at, ends = np.round(1e6 * record.time).astype(int), np.asarray(flight.end_us)
    rows = record.rows("predict")
    rows = rows[np.isin(at[rows], ends)]
    out = []
    for row in rows[np.linspace(0, len(rows) - 1, count).astype(int)]:
        nav = {name: np.asarray(value[row])[None] for name, value in made.nav.items()}
        error = errors_of(nav, true_of(flight, int(np.searchsorted(ends, at[row])), [run]))[0]
        out.append(error @ np.linalg.solve(made.P[row][:N, :N], error))
    return out


@pytest.mark.parametrize("name", ["healthy, 10 Hz and 1 Hz", "10 s of the slave lost"])
def test_a_smoothed_flight_lies_in_the_band_of_its_covariance(name):
    runs = 4
    flight, records = recorded(name, runs)
    made = [smooth(record) for record in records]
    nees = [normalised(flight, run, *each) for run, each in enumerate(zip(records, made, strict=True))]
    low, high = chi2.ppf([0.00005, 0.99995], N * runs) / runs
    mean = np.mean(nees, axis=0)
    assert ((low < mean) & (mean < high)).all(), mean
    pieces = {record.piece[-1] for record in records}
    assert pieces == ({1} if "lost" in name else {0})  # a restart ends a piece
    middle = len(records[0].names) // 2
    before = np.array([np.sqrt(np.diag(record.covariance(middle))) for record in records])
    shrink = np.array([done.sigma[middle] for done in made]) / before
    assert np.max(shrink) < 1 and np.min(shrink) < 0.5  # each state is known better afterwards


@pytest.fixture(scope="module")
def short():
    return NAMED["healthy, s-turns"].flight(runs=1, seconds=4.0)


@pytest.mark.parametrize("precision", ["double", "float"])
def test_it_flies_with_its_bits_and_P_is_its_own(precision, short):
    loops = [loop_of(short, model=load("velocity-attitude", precision=precision)) for _ in range(2)]
    record = Record(loops[1])
    assert len({fly(short, loop) for loop in loops}) == 1
    assert np.array_equal(record.P[-1], loops[1].covariance()[0])
    predicted, P, Phi, Q = record.rows("predict"), record.P, record.Phi(), record.Q()
    scale = np.sqrt(np.einsum("kii,kjj->kij", P[predicted], P[predicted]))
    off = P[predicted] - Phi @ P[predicted - 1] @ np.swapaxes(Phi, -1, -2) - Q
    assert np.abs(off / scale).max() < (1e-13 if precision == "double" else 1e-7)
    assert np.linalg.eigvalsh(Q / scale).min() > (-1e-14 if precision == "double" else -1e-5)
    if precision == "double":  # Phi by the model's own function, of the navigation half a step later
        nav = {name: value[predicted] for name, value in record.nav.items()}
        dt, f_b = np.diff(record.time, prepend=0)[predicted], np.array([0.0, 0.0, -9.8])
        F = load("velocity-attitude").F(f_b=f_b, **{n: nav[n] for n in ("lat_lon_height", "v_n", "q_b2n_wxyz")})
        order = np.eye(N) + F * dt[:, None, None]
        still = [0, 1, 2, *range(6, N)]  # rows that no specific force is in
        assert np.abs(Phi - order)[1:, still].max() < 2e-3  # C dt is .04
    for name in ("velocity", "dcm"):
        rows, found, H = record.rows(name), record.innovation(name), record.jacobian(name)
        before = record.covariance(rows - 1)
        S = np.einsum("ki,kij,kj->k", H[:, 0], before, H[:, 0])
        assert (found.S[:, 0] > S).all() and found.used.all()
        assert np.array_equal(record.taken(), record.x[record.rows("feedback") - 1])


def test_an_instant_is_recorded_as_its_own_flight_has_it(short):
    loop = loop_of(short)
    record = Record(loop)
    with pytest.raises(BoresightError, match="nothing has been recorded yet; begin the loop"):
        record.names  # noqa: B018
    with pytest.raises(BoresightError, match="recorded already"):
        Record(loop)
    states = {}

    def split(flying):
        other = copy.copy(flying)
        assert type(other) is Live
        states["rows"], states["snapshot"] = len(record.names), flying.snapshot()
        other.sample(10**7, 0.01, dtheta_ib_b=np.zeros(3), dv_b=np.zeros(3))
        assert len(record.names) == states["rows"]  # a copy is not recorded

    fly(short, loop, cut=(120, split))
    assert set(record.piece) == {0}
    loop.restore(states["snapshot"])
    assert record.piece[-1] == 1 and record.names[-1] == "begin"
    assert np.array_equal(record.P[-1], record.P[states["rows"] - 1])
    with pytest.raises(BoresightError, match="takes a part of the gain back"):
        record.gain("velocity")
    record.stop()
    assert type(loop) is Live and Record(loop).piece[0] == 0


def test_files_hold_the_same(short, tmp_path):
    kept, filed = (loop_of(short) for _ in range(2))
    one, other = Record(kept), Record(filed, tmp_path / "flight")
    fly(short, kept), fly(short, filed)
    other.stop()
    again = Record.open(tmp_path / "flight", kept.library)
    assert again.names.tolist() == one.names.tolist()
    for made in (smooth(again), smooth(other)):
        assert np.array_equal(made.P, smooth(one).P)


if __name__ == "__main__":
    for condition in CONDITIONS:
        if any(word in condition.name for word in sys.argv[2:]):
            flight, records = recorded(condition.name, int(sys.argv[1]))
            nees = [[normalised(flight, run, r, made) for made in (smooth(r), r)] for run, r in enumerate(records)]
            print(condition.name, *np.mean(nees, axis=0).round(1), sep="\n  ", flush=True)
