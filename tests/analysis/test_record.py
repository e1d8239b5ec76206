"""What a record holds of each step, beside what the filter did."""

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from boresight import BoresightError, CompiledFilter, Epoch, Filter, Record, load, smooth

RADAR = {"gusts": [0.5, 0.01]}


@pytest.fixture(scope="module")
def radar(radar_folder):
    return load(radar_folder)


def start(kind, radar, runs=()):
    x = np.broadcast_to([100.0, -2000.0, 30.0, 1.0, 0.2], (*runs, 5))
    return kind(radar, {}, np.diag([50.0, 50.0, 5.0, 5.0, 0.1]) ** 2, x)


def echo(loop, rng, **options):
    """A range and a bearing of about where it is, and the innovation."""
    east, north = loop.x[..., 0], loop.x[..., 1]
    z = np.stack([np.hypot(east, north), np.arctan2(east, north) - loop.x[..., 4]], axis=-1)
    z = z + rng.standard_normal(z.shape) * [5.0, 0.01]
    z[..., 1] = (z[..., 1] + np.pi) % (2 * np.pi) - np.pi
    return loop.update("radar", [25.0, 1e-4], z=z, **options)


@pytest.mark.parametrize("kind", [Filter, CompiledFilter])
@pytest.mark.parametrize("runs", [(), (3,), (2, 2)])
def test_each_step_holds_what_the_filter_had(kind, runs, radar):
    rng, loop = np.random.default_rng(1), start(kind, radar, runs)
    record, held, found = Record(loop), [(loop.x.copy(), loop.P.copy())], []
    for _ in range(20):
        loop.predict(dt=0.5, **RADAR)
        held.append((loop.x.copy(), loop.P.copy()))
        found.append(echo(loop, rng, gate=0.8))
        held.append((loop.x.copy(), loop.P.copy()))
    assert record.names.tolist() == ["begin", *["predict", "radar"] * 20]
    assert record.time[-1] == 10.0 and not record.piece.any()
    for row, (x, P) in enumerate(held):
        assert np.array_equal(record.x[row], np.broadcast_to(x, record.x[row].shape))
        off = np.abs(record.P[row] - P)  # of `Filter` not symmetric to the last bit
        assert (off <= (kind is Filter) * 1e-15 * np.abs(P)).all()
    innovation = record.innovation("radar")
    for part in ("nu", "S", "used", "nis"):
        assert np.array_equal(getattr(innovation, part), [getattr(each, part) for each in found])
    assert not innovation.used.all() and innovation.used.any()  # some were gated


@pytest.mark.parametrize("kind", [Filter, CompiledFilter])
@pytest.mark.parametrize("options", [{}, {"gate": 1.5}, {"iterations": 4}, {"relinearize": True},
                                     {"gate": 1.0, "inflate": True}, {"rows": [True, False]},
                                     {"considered": [False, False, True, False, True]}])  # fmt: skip
def test_phi_q_and_the_gain_are_those_that_were_flown(kind, options, radar):
    rng, loop = np.random.default_rng(2), start(kind, radar, (4,))
    record = Record(loop)
    for _ in range(12):
        loop.predict(dt=0.5, **RADAR)
        echo(loop, rng, **options)
    predicted, measured = record.rows("predict"), record.rows("radar")
    P, Phi, Q = record.P, record.Phi(), record.Q()
    assert Phi.shape == Q.shape == (12, 4, 5, 5)
    off = P[predicted] - (Phi @ P[predicted - 1] @ np.swapaxes(Phi, -1, -2) + Q)
    assert np.abs(off).max() < 1e-12 * np.abs(P).max()
    nu, K = record.innovation("radar").nu, record.gain("radar")
    off = record.x[measured] - record.x[measured - 1] - (K @ nu[..., None])[..., 0]
    assert np.abs(off).max() < 1e-8  # m


def test_correlated_rows_have_their_gain(radar):
    rng, loop = np.random.default_rng(3), start(CompiledFilter, radar)
    record, R = Record(loop), np.array([[25.0, 12.0], [12.0, 9.0]])
    for _ in range(20):  # others may have the processor: the least of a few
        loop.predict(dt=0.5, **RADAR)
        loop.update("fix", R, z=loop.x[:2] + rng.standard_normal(2))
    rows = record.rows("fix")
    off = record.x[rows] - record.x[rows - 1] - (record.gain("fix") @ record.innovation("fix").nu[..., None])[..., 0]
    assert np.abs(off).max() < 1e-9


@pytest.mark.parametrize("kind", [Filter, CompiledFilter])
def test_a_step_that_is_refused_leaves_nothing(kind, radar):
    loop = start(kind, radar)
    record = Record(loop)
    loop.predict(dt=0.5, **RADAR)
    before = len(record.names), loop.x.copy()
    for wrong in (
        lambda: loop.update("radar", [25.0, 1e-4], z=[np.nan, 0.0]),
        lambda: loop.update("radar", [-1.0, 1e-4], z=[2000.0, 0.0]),
        lambda: loop.update("nothing", 1.0, z=[1.0]),
        lambda: loop.predict(dt=-1.0, **RADAR),
        lambda: loop.set_block(4, [[-1.0]]),
        lambda: loop.feedback(),
    ):
        with pytest.raises((BoresightError, AttributeError)):
            wrong()
    assert (len(record.names), record.time[-1]) == (before[0], 0.5) and np.array_equal(loop.x, before[1])


@pytest.mark.parametrize("kind", [Filter, CompiledFilter])
def test_blocks_and_pieces(kind, radar):
    rng, loop = np.random.default_rng(4), start(kind, radar)
    record = Record(loop)
    loop.predict(dt=0.5, **RADAR)
    loop.set_block(4, [[0.5]])
    loop.inflate(2, variance=[1.0, 2.0])
    loop.disable(4)
    loop.predict(dt=0.5, **RADAR)
    loop.enable(4, [[0.25]])
    assert loop.P.shape == (5, 5)  # to look is no step
    echo(loop, rng)
    loop.P = np.diag([50.0, 50.0, 5.0, 5.0, 0.1]) ** 2
    loop.predict(dt=0.5, **RADAR)
    loop.P[0, 0] += 1.0  # in place
    loop.predict(dt=0.5, **RADAR)
    steps = ["set_block", "inflate", "disable", "predict", "enable", "radar"]
    assert record.names.tolist() == ["begin", "predict", *steps, "begin", "predict", "begin", "predict"]
    assert record.piece.tolist() == [0] * 8 + [1, 1, 2, 2]
    variances = np.diagonal(record.P, axis1=-2, axis2=-1)
    assert (
        np.allclose(variances[3] - variances[2], [0, 0, 1, 2, 0]) and variances[5, 4] == 0 and variances[6, 4] == 0.25
    )


@pytest.mark.parametrize("kind", [Filter, CompiledFilter])
def test_feedback_holds_what_it_took_out_and_nav_of_before_and_after(kind, library):
    nav = {"q_b2n_wxyz": [1, 0, 0, 0], "mu": np.zeros(3)}
    loop = kind(library, nav, np.eye(6) * 1e-4)
    record, taken = Record(loop), []
    for _ in range(4):
        loop.strapdown(dtheta_ib_b=[0, 0, 0.01], omega_in_n=np.zeros(3), dt=1.0)
        loop.predict(omega_in_n=np.zeros(3), gyro_noise=np.full(3, 1e-4), dt=1.0)
        angles = {"euler_b": loop.call("euler_angles"), "euler_m": np.zeros(3)}
        loop.update("euler_exact", np.full(3, 1e-6), **angles)
        taken.append(loop.x.copy())
        before = {name: np.array(value) for name, value in loop.nav.items()}
        loop.feedback()
    assert np.array_equal(record.taken(), taken) and np.abs(taken).max() > 1e-3
    (table,) = record.tables("feedback")
    for name in nav:
        assert np.array_equal(table.given[f"nav {name}"][-1], before[name])
        assert np.array_equal(record.nav[name][-1], loop.nav[name])


def test_a_feedback_by_hand_is_one(library):
    loop = CompiledFilter(library, {"q_b2n_wxyz": [1, 0, 0, 0], "mu": np.zeros(3)}, np.eye(6) * 1e-4)
    record = Record(loop)
    angles = {"euler_b": np.full(3, 0.01), "euler_m": np.zeros(3)}
    loop.update("euler_exact", np.full(3, 1e-6), **angles)
    x = loop.x.copy()
    loop.nav["mu"] = loop.nav["mu"] - x[3:]
    loop.x = np.zeros(6)
    loop.predict(omega_in_n=np.zeros(3), gyro_noise=np.full(3, 1e-4), dt=1.0)
    assert record.names.tolist() == ["begin", "euler_exact", "feedback", "predict"]
    assert np.array_equal(record.taken()[0], x) and np.array_equal(record.nav["mu"][2], -x[3:])


def test_a_field_of_nav_that_the_C_does_not_carry_is_what_it_was_at_each_step(library):
    nav = {"q_b2n_wxyz": [1, 0, 0, 0], "mu": np.zeros(3), "omega_in_n": np.zeros(3)}
    loop = CompiledFilter(library, nav, np.eye(6) * 1e-4)
    record = Record(loop)
    for rate in (1e-5, 2e-5):
        loop.nav["omega_in_n"] = np.full(3, rate)
        loop.predict(gyro_noise=np.full(3, 1e-4), dt=1.0)
        loop.predict(gyro_noise=np.full(3, 1e-4), dt=1.0)
    assert record.nav["omega_in_n"][1:, 0].tolist() == [1e-5, 1e-5, 2e-5, 2e-5]
    loop.nav["euler_m"] = np.zeros(3)
    with pytest.raises(BoresightError, match="nav has other fields"):
        loop.predict(gyro_noise=np.full(3, 1e-4), dt=1.0)


def test_the_files_hold_the_same_and_memory_does_not_grow(radar, tmp_path, monkeypatch):
    from boresight.analysis import record as module

    monkeypatch.setattr(module, "CHUNK_STEPS", 7)
    records = []
    for path in (None, tmp_path / "flight"):
        rng, loop = np.random.default_rng(5), start(CompiledFilter, radar, (2,))
        record = Record(loop, path)
        for _ in range(15):
            loop.predict(dt=0.5, **RADAR)
            echo(loop, rng, gate=2.0)
        assert len(record._steps) <= 7
        records.append(record)
    records[1].stop()
    assert all(isinstance(chunk, Path) for chunk in records[1]._chunks)
    records.append(Record.open(tmp_path / "flight", radar))
    one = records[0]
    for other in records[1:]:
        assert other.names.tolist() == one.names.tolist() and other.total
        for name in ("time", "piece", "x", "P"):
            assert np.array_equal(getattr(other, name), getattr(one, name))
        assert np.array_equal(other.gain("radar"), one.gain("radar"))
        assert np.array_equal(other.Phi(), one.Phi())
    with pytest.raises(BoresightError, match="not empty"):
        Record(start(CompiledFilter, radar), tmp_path / "flight")
    with pytest.raises(BoresightError, match="holds no record"):
        Record.open(tmp_path, radar)
    with pytest.raises(BoresightError, match="5 states, and this model has 6"):
        Record.open(tmp_path / "flight", load("euler-matching"))
    with pytest.raises(BoresightError, match=r"of a filter with the states east, north, .*, and this model has others"):
        Record.open(tmp_path / "flight", SimpleNamespace(states=tuple("abcde")))


def test_a_recorded_filter_is_refused_twice_and_goes_on_when_it_is_stopped(radar):
    loop = start(CompiledFilter, radar)
    record = Record(loop)
    with pytest.raises(BoresightError, match="recorded already"):
        Record(loop)
    record.stop()
    loop.predict(dt=0.5, **RADAR)
    assert record.names.tolist() == ["begin"] and loop.recorder is None and "predict" not in vars(loop)
    with pytest.raises(BoresightError, match="no measurement 'radar' was recorded"):
        record.innovation("radar")
    with pytest.raises(BoresightError, match="a str cannot be recorded; give a Filter, a CompiledFilter or a Live"):
        Record("radar")


class ByMethods:
    """An Epoch by the methods of its filter."""

    def __init__(self, loop, nav):
        self.loop, self.nav = loop, nav

    def __call__(self, turns, noise, angles):
        for turn in turns:
            self.loop.strapdown(dtheta_ib_b=turn, omega_in_n=np.zeros(3), dt=0.5)
        self.loop.predict(omega_in_n=np.zeros(3), gyro_noise=noise, dt=1.0)
        euler = self.loop.call("euler_angles")
        self.loop.update("euler_exact", np.full(3, 1e-6), iterations=2, gate=3.0, euler_b=euler, euler_m=angles)
        self.loop.feedback()


class InOneCall(ByMethods):
    """Its angles come from the filter before the call, so that it stands between two epochs there."""

    def __init__(self, loop, nav):
        super().__init__(loop, nav)
        self.move, self.take = Epoch(loop, 2, feedback=False), Epoch(loop, 0, ["euler_exact"], predict=False)

    def __call__(self, turns, noise, angles):
        self.move.strapdown["dtheta_ib_b"] = np.reshape(turns, (2, *(1,) * (self.loop.x.ndim - 1), 3))
        self.move.strapdown["dt"], self.move.predict["dt"], self.move.predict["gyro_noise"] = 0.5, 1.0, noise
        assert self.move() == 0
        taken = self.take.measured["euler_exact"]
        taken.gates[0], taken.iterations[0] = 3.0, 2
        taken["R"], taken["euler_b"], taken["euler_m"] = 1e-6, self.loop.call("euler_angles"), angles
        assert self.take() == 0


@pytest.mark.parametrize("runs", [(), (3,)])
def test_an_epoch_is_recorded_step_by_step_with_its_bits(runs, library):
    records = []
    for kind, recorded in ((ByMethods, True), (InOneCall, True), (InOneCall, False)):
        rng, nav = np.random.default_rng(8), {"q_b2n_wxyz": [1, 0, 0, 0], "mu": np.zeros((*runs, 3))}
        loop = CompiledFilter(library, nav, np.broadcast_to(np.eye(6) * 1e-4, (*runs, 6, 6)))
        record = Record(loop) if recorded else None
        fly = kind(loop, nav)
        for _ in range(8):
            fly(0.01 * rng.standard_normal((2, 3)), np.full(3, 1e-4), 0.01 * rng.standard_normal((*runs, 3)))
        records.append((record, loop))
    (one, loop), (other, there), (_, bare) = records
    assert other.names.tolist() == one.names.tolist() == ["begin", *["predict", "euler_exact", "feedback"] * 8]
    for name in ("time", "piece", "x", "P"):
        assert np.array_equal(getattr(other, name), getattr(one, name)), name
    assert all(np.array_equal(other.nav[name], one.nav[name]) for name in one.nav)
    for get in (Record.taken, Record.Phi, Record.Q, *(lambda r, f=f: getattr(r, f)("euler_exact")
                                                      for f in ("gain", "jacobian"))):  # fmt: skip
        assert np.array_equal(get(other), get(one))
    found = [record.innovation("euler_exact") for record in (one, other)]
    assert all(np.array_equal(*(getattr(f, part) for f in found)) for part in ("nu", "S", "used", "nis", "inflated"))
    assert not found[0].used.all()
    assert np.array_equal(bare.x, there.x) and np.array_equal(bare.P, there.P)
    assert np.array_equal(smooth(one).P, smooth(other).P)


def test_an_epoch_that_refuses_a_run_ends_the_piece(library):
    ends = []
    for recorded in (True, False):
        nav = {"q_b2n_wxyz": [1, 0, 0, 0], "mu": np.zeros((3, 3))}
        loop = CompiledFilter(library, nav, np.broadcast_to(np.eye(6) * 1e-4, (3, 6, 6)))
        record = Record(loop) if recorded else None
        epoch = Epoch(loop, 1, feedback=False)
        epoch.strapdown["dt"] = epoch.predict["dt"] = 1.0
        refused = [epoch()]
        epoch.predict["gyro_noise"][1] = np.nan
        refused += [epoch(), epoch.refused()]
        epoch.predict["gyro_noise"] = 1e-4
        refused.append(epoch())
        ends.append((refused, epoch.status.tolist(), loop.P))
        if record is not None:
            assert record.names.tolist() == ["begin", "predict", "begin", "predict"]
            assert record.piece.tolist() == [0, 0, 1, 1] and record.time.tolist() == [0, 1, 1, 2]
    assert ends[0][:2] == ends[1][:2] == ([0, 1, "run 1: BS_NOT_FINITE", 0], [0, 0, 0])
    assert np.array_equal(ends[0][2], ends[1][2])


def test_a_recorded_flight_has_the_bits_of_one_that_is_not(radar):
    ends = []
    for recorded in (True, False):
        rng, loop = np.random.default_rng(6), start(CompiledFilter, radar, (3,))
        record = Record(loop) if recorded else None
        for _ in range(10):
            loop.predict(dt=0.5, **RADAR)
            echo(loop, rng)
        ends.append((loop.x, loop.P))
    assert record is None and all(np.array_equal(a, b) for a, b in zip(*ends, strict=True))
