"""The measurement update: angles wrap, iterations find the most probable state, errors of rows may be correlated.

Held in Python and in C against least squares of SciPy, the update in matrices, and a target that crosses half a turn.
"""

import re
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from building import STRICT, self_test
from scipy.optimize import least_squares
from scipy.stats import chi2

from boresight import BoresightError
from boresight.runtime.filter import CompiledFilter, Filter
from boresight.runtime.library import load

ROOT = Path(__file__).parent.parent.parent
KINDS = pytest.mark.parametrize("kind", [Filter, CompiledFilter], ids=["python", "c"])
FAR = np.array([20.0, -3000.0, 0.0, 0.0, 0.0])
SURE = np.diag([1e-4, 1e-4, 1e-4, 1e-4, 1e-8])  # all but what a test makes uncertain


@pytest.fixture(scope="module")
def radar(radar_folder):
    return load(radar_folder)


def begun(kind, model, x, P):
    runs = np.broadcast_shapes(np.shape(x)[:-1], np.shape(P)[:-2])
    loop = kind(model, {}, np.broadcast_to(P, (*runs, 5, 5)), x=np.broadcast_to(x, (*runs, 5)))
    return loop


def seen(x):
    """Range and bearing, by hand."""
    return np.stack([np.hypot(x[..., 0], x[..., 1]), np.arctan2(x[..., 0], x[..., 1]) - x[..., 4]], axis=-1)


def turned(angle):
    return (angle + np.pi) % (2 * np.pi) - np.pi


# ---- angles


@KINDS
@pytest.mark.parametrize("name", ["compass", "mounted", "radar"])
@pytest.mark.parametrize("runs", [(), (3,)])
def test_an_innovation_of_an_angle_goes_the_short_way_round_and_the_state_with_it(kind, name, runs, radar):
    for side in (1.0, -1.0):
        x, z = FAR.copy(), side * np.array([-3.13])
        x[4] = side * 3.13
        inputs = {"mount": 0.0} if name == "mounted" else {}
        if name == "radar":  # the bearing falls as the heading rises
            z = np.array([np.hypot(20, 3000), seen(x)[1] - side * (2 * np.pi - 6.26)])
        loop = begun(kind, radar, np.broadcast_to(x, (*runs, 5)), np.diag([1e-6] * 4 + [1e-2]))
        before = loop.x.copy()
        said = loop.update(name, np.full(len(z), 1e-3), z=z, **inputs)
        short = side * (2 * np.pi - 6.26) * (-1 if name == "radar" else 1)
        np.testing.assert_allclose(said.nu[..., -1], short, atol=1e-9)
        moved = turned(loop.x[..., 4] - before[..., 4])
        np.testing.assert_allclose(moved, side * (2 * np.pi - 6.26) / 1.1, rtol=1e-3)
        assert (loop.x[..., 4] * side < 0).all()  # across half a turn
    assert loop.x.shape == (*runs, 5)


def test_only_the_rows_that_are_angles_wrap(radar):
    loop = begun(Filter, radar, FAR, np.diag([1e2] * 4 + [1e-2]))
    said = loop.update("radar", np.array([1.0, 1e-4]), z=seen(FAR) + np.array([50.0, 0.01]))
    assert said.nu[0] == pytest.approx(50.0, abs=1e-9)
    np.testing.assert_allclose(radar.radar_h(x=FAR)[0], seen(FAR)[0], rtol=1e-15)


@KINDS
@pytest.mark.parametrize("runs", [None, 40])
@pytest.mark.parametrize("eastward", [1.0, -1.0])
def test_a_target_that_crosses_half_a_turn_is_followed_both_ways(kind, runs, eastward, radar):
    rng = np.random.default_rng(7)
    shape, dt, R = (() if runs is None else (runs,)), 0.5, np.array([25.0, 1e-4])
    truth = np.array([-300.0 * eastward, -1000.0, 30.0 * eastward, 0.0, 0.02])
    sigma = np.array([30.0, 30.0, 3.0, 3.0, 1e-3])
    F = np.eye(5) + dt * np.eye(5, k=2) * [[1], [1], [0], [0], [0]]
    loop = begun(kind, radar, truth + sigma * rng.standard_normal((*shape, 5)), np.diag(sigma**2))
    nis = []
    for _ in range(40):
        truth = F @ truth
        loop.x, loop.P = loop.x @ F.T, F @ loop.P @ F.T
        z = seen(truth) + np.sqrt(R) * rng.standard_normal((*shape, 2))
        nis.append(loop.update("radar", R, z=np.stack([z[..., 0], turned(z[..., 1])], -1)).nis)
    spread = np.sqrt(np.einsum("...ii->...i", loop.P))
    assert (abs(loop.x - truth) < 5 * spread).all()
    low, high = chi2.ppf([1e-4, 1 - 1e-4], np.size(nis) * 2) / np.size(nis)
    assert low < np.mean(nis) < high


# ---- iterations

NEAR = np.array([4.0, -3.0, 0.0, 0.0, 0.0])
WIDE = np.diag([9.0, 4.0, 1.0, 1.0, 1e-4])
WIDE[0, 1] = WIDE[1, 0] = 2.0
THIN = np.array([30.0, -30.0, 0.0, 0.0, 0.0])
HERE, NOISE = np.array([6.5, 0.35 + np.arctan2(4.0, -3.0)]), np.array([1e-2, 1e-3])


def most_probable(x, P, z, R):
    """The state of least squares by SciPy, and the covariance of its linearisation."""
    root = np.linalg.inv(np.linalg.cholesky(P))
    by_R = np.linalg.inv(np.linalg.cholesky(R))

    def residual(at):
        off = z - seen(at)
        return np.concatenate([root @ (at - x), by_R @ [off[0], turned(off[1])]])

    found = least_squares(residual, x, xtol=1e-15, ftol=1e-15, gtol=1e-15)
    return found.x, np.linalg.inv(found.jac.T @ found.jac)


def away(x, at, P):
    return np.sqrt((x - at) @ np.linalg.solve(P, x - at))


@KINDS
@pytest.mark.parametrize("smeared", [False, True])
def test_iterations_find_the_most_probable_state(kind, smeared, radar):
    full = np.diag(NOISE) + smeared * 0.6 * np.sqrt(np.prod(NOISE)) * np.array([[0, 1], [1, 0]])
    name, R = ("smeared", full) if smeared else ("radar", NOISE)
    best, spread = most_probable(NEAR, WIDE, HERE, full)
    once, again = (begun(kind, radar, NEAR, WIDE) for _ in range(2))
    once.update(name, R, z=HERE)
    said = again.update(name, R, z=HERE, iterations=20)
    assert away(once.x, best, spread) > 3.0
    assert away(again.x, best, spread) < 0.01
    scale = np.sqrt(np.outer(np.diag(spread), np.diag(spread)))
    assert abs((again.P - spread) / scale).max() < 5e-3  # by the last H alone
    cost = (best - NEAR) @ np.linalg.solve(WIDE, best - NEAR)
    off = HERE - seen(best)
    assert said.nis == pytest.approx(cost + off @ np.linalg.solve(full, off), rel=1e-3)


@pytest.mark.digits
def test_the_conventions_say_how_far_from_the_most_probable_state_the_iterations_end(radar):
    text = " ".join((ROOT / "docs" / "conventions.md").read_text().split())
    said = re.search(r"from 5 m, .* one iteration ends (\S+) sigma .* three end (\S+) sigma", text)
    best, spread = most_probable(NEAR, WIDE, HERE, np.diag(NOISE))
    for iterations, sigmas in zip((1, 3), said.groups(), strict=True):
        loop = begun(Filter, radar, NEAR, WIDE)
        loop.update("radar", NOISE, z=HERE, iterations=iterations)
        assert f"{away(loop.x, best, spread):.{len(sigmas.split('.')[1])}f}" == sigmas


@KINDS
def test_it_goes_on_while_a_row_moves_by_more_than_its_sigmas_though_no_state_does(kind, radar):
    x, P, R = THIN, np.diag([100.0, 100.0, 1, 1, 1e-6]), np.array([1e-8, 0.09])
    z = seen(x) + np.array([3.0, 0.4])  # the range is good to .1 mm, and neither coordinate to a metre
    best, spread = most_probable(x, P, z, np.diag(R))
    loop = begun(kind, radar, x, P)
    loop.update("radar", R, z=z, iterations=20)
    assert away(loop.x, best, spread) < 0.01


@KINDS
def test_each_iteration_starts_from_the_first_state_and_covariance(kind, radar):
    x = NEAR
    for _ in range(3):
        H = radar.radar_H(x=x)
        S = H @ WIDE @ H.T + np.diag(NOISE)
        K = WIDE @ H.T @ np.linalg.inv(S)
        x, P = NEAR + K @ (HERE - seen(x) - H @ (NEAR - x)), (np.eye(5) - K @ H) @ WIDE
    loop = begun(kind, radar, NEAR, WIDE)
    loop.update("radar", NOISE, z=HERE, iterations=3)
    np.testing.assert_allclose(loop.x, x, rtol=1e-10)
    np.testing.assert_allclose(loop.P, P, atol=1e-9)


@KINDS
@pytest.mark.parametrize("z", [HERE, seen(NEAR) + np.array([6.0, 0.3])])
def test_the_gate_is_that_of_the_first_linearisation(kind, z, radar):
    first, last = (begun(kind, radar, NEAR, WIDE).update("radar", NOISE, z=z, iterations=k) for k in (1, 20))
    sigmas = [abs(said.nu) / np.sqrt(said.S) for said in (first, last)]
    row = int(np.argmax(abs(sigmas[0] - sigmas[1])))
    gate = (sigmas[0][row] + sigmas[1][row]) / 2
    loop, masked = begun(kind, radar, NEAR, WIDE), begun(kind, radar, NEAR, WIDE)
    said = loop.update("radar", NOISE, z=z, iterations=20, gate=gate)
    masked.update("radar", NOISE, z=z, iterations=20, rows=said.used)
    np.testing.assert_array_equal((loop.x, np.diag(loop.P)), (masked.x, np.diag(masked.P)))
    assert said.used.tolist() == (sigmas[0] <= gate).tolist()
    assert said.used.tolist() != (sigmas[1] <= gate).tolist()


def counted(model):
    """The model with a count of how often H was asked for."""
    calls = []

    def radar_H(x):
        calls.append(1)
        return model.radar_H(x=x)

    radar_H.fields = ("x",)
    return SimpleNamespace(
        radar_h=model.radar_h, radar_H=radar_H, measurements=model.measurements, wraps=model.wraps, next=None
    ), calls


@pytest.mark.parametrize(
    ("start", "P", "z", "R"),
    [
        (NEAR, WIDE, HERE, NOISE),
        (THIN, np.diag([100, 100, 1, 1, 1e-6]), seen(THIN) + np.array([3.0, 0.5]), np.array([1e-4, 0.04])),
    ],
)
def test_it_stops_where_nothing_moves_by_a_hundredth_of_a_sigma(start, P, z, R, radar):
    x, moves = start, [np.inf]
    while moves[-1] > 0.01:
        H = radar.radar_H(x=x)
        K = P @ H.T @ np.linalg.inv(H @ P @ H.T + np.diag(R))
        by = start + K @ (z - seen(x) - H @ (start - x)) - x
        x, spread = x + by, np.diag(P - K @ H @ P)
        moves.append(max(abs(by / np.sqrt(spread)).max(), abs(H @ by / np.sqrt(R)).max()))
    model, calls = counted(radar)
    loop = begun(Filter, model, start, P)
    loop.update("radar", R, z=z, iterations=50)
    assert len(calls) == len(moves) - 1
    compiled = {}
    for count in (len(calls) - 1, len(calls), 50):
        compiled[count] = begun(CompiledFilter, radar, start, P)
        compiled[count].update("radar", R, z=z, iterations=count)
    np.testing.assert_array_equal(compiled[50].x, compiled[len(calls)].x)
    assert (compiled[50].x != compiled[len(calls) - 1].x).any()
    np.testing.assert_allclose(compiled[50].x, loop.x, rtol=1e-12)


# The Gauss-Newton steps of an arctangent grow from e / |n| = 2 on; and a target that is due north leaves the box.
GROWS = np.array([20.0, -10.0, 0, 0, 0]), np.diag([1e6, 1e-6, 1, 1, 1e-12]), np.pi, [1e-4, 1e-8]
LEAVES = np.array([1.0, -2.0, 0, 0, 0]), np.diag([100.0, 100.0, 1, 1, 1e-12]), 0.3, [1e-4, 1e-8]


@KINDS
def test_what_diverges_takes_the_first_result_and_its_neighbours_go_on(kind, radar):
    x, P, bearing, R = GROWS
    states, P = np.stack([NEAR, x, NEAR]), np.stack([WIDE, P, WIDE])
    R = np.stack([NOISE, R, NOISE])
    z, rows = np.stack([HERE, [0.0, bearing], HERE]), np.array([[True, True], [False, True], [True, True]])
    batch, alone, once = begun(kind, radar, states, P), begun(kind, radar, NEAR, WIDE), begun(kind, radar, x, P[1])
    batch.update("radar", R, z=z, rows=rows, iterations=20)
    alone.update("radar", NOISE, z=HERE, iterations=20)
    first = once.update("radar", R[1], z=z[1], rows=rows[1])
    for i, other in enumerate((alone, once, alone)):
        np.testing.assert_array_equal(batch.x[i], other.x)
        np.testing.assert_array_equal(batch.P[i], other.P)
    few = begun(kind, radar, x, P[1])
    said = few.update("radar", R[1], z=z[1], rows=rows[1], iterations=2)
    np.testing.assert_array_equal(few.x, once.x)
    np.testing.assert_array_equal((said.nu, said.S, said.used), (first.nu, first.S, first.used))


@KINDS
@pytest.mark.parametrize("iterations", [1, 3])
def test_what_would_leave_its_box_is_refused(kind, iterations, radar):
    x, P, bearing, R = LEAVES
    loop = begun(kind, radar, x, P)
    with pytest.raises(BoresightError, match="box"):
        loop.update("radar", R, z=[0.0, bearing], rows=[False, True], iterations=iterations)
    np.testing.assert_array_equal(loop.x, x)


# ---- errors that depend on each other

FULL = np.array([[4.0, 3.0], [3.0, 9.0]])


def in_matrices(x, P, H, R, nu):
    S = H @ P @ H.T + R
    K = P @ H.T @ np.linalg.inv(S)
    return x + K @ nu, P - K @ S @ K.T, nu @ np.linalg.solve(S, nu)


@KINDS
@pytest.mark.parametrize("name", ["fix", "smeared"])
@pytest.mark.parametrize("rows", [(True, True), (True, False), (False, True), (False, False)])
def test_a_full_R_is_the_update_in_matrices_of_the_rows_that_are_there(kind, name, rows, radar):
    rng = np.random.default_rng(1)
    A = rng.standard_normal((5, 5))
    P, R = (
        A @ A.T * np.outer(*[[3.0, 3.0, 1.0, 1.0, 0.01]] * 2),
        FULL * np.outer(*[[1.0, 1.0 if name == "fix" else 0.01]] * 2),
    )
    P = (P + P.T) / 2
    h = FAR[:2] if name == "fix" else seen(FAR)
    nu, keep = rng.standard_normal(2) * np.sqrt(np.diag(R)), np.flatnonzero(rows)
    z, H = h + nu, radar.fix_H() if name == "fix" else radar.smeared_H(x=FAR)
    x, after, nis = in_matrices(FAR, P, H[keep], R[np.ix_(keep, keep)], nu[keep])
    loop = begun(kind, radar, FAR, P)
    said = loop.update(name, R, z=z, rows=rows)
    np.testing.assert_allclose(loop.x, x, rtol=1e-10, atol=1e-12)
    scale = np.sqrt(np.outer(np.diag(P), np.diag(P)))
    np.testing.assert_allclose(loop.P / scale, after / scale, atol=1e-12)
    assert said.nis == pytest.approx(nis, rel=1e-9, abs=1e-12)
    assert said.used.tolist() == list(rows)


def test_any_measurement_takes_a_full_R_in_python_and_each_run_its_own(radar):
    R = np.stack([FULL, np.diag([4.0, 9.0]), FULL * 2]) * np.array([[1, 0.01], [0.01, 1e-4]])
    z = seen(FAR) + np.array([1.0, 0.01])
    batch = begun(Filter, radar, np.tile(FAR, (3, 1)), WIDE)
    batch.update("radar", R, z=z)
    for i in range(3):
        alone = begun(Filter, radar, FAR, WIDE)
        alone.update("radar", R[i], z=z)
        np.testing.assert_allclose(batch.x[i], alone.x, rtol=1e-14)
        same = begun(CompiledFilter, radar, FAR, WIDE)
        same.update("smeared", R[i], z=z)
        np.testing.assert_allclose(same.x, alone.x, rtol=1e-12)
        np.testing.assert_allclose(same.P, alone.P, atol=1e-12)
    plain, diagonal = begun(Filter, radar, FAR, WIDE), begun(Filter, radar, FAR, WIDE)
    plain.update("radar", np.diag(R[1]), z=z)
    diagonal.update("radar", R[1], z=z)
    np.testing.assert_allclose(plain.x, diagonal.x, rtol=1e-14)


@KINDS
@pytest.mark.parametrize(
    ("name", "R", "off", "iterations"),
    [
        ("smeared", FULL, [1e3, 0.0], 1),
        ("smeared", FULL, [1e3, 0.0], 5),
        ("fix", [[4.0, 3.0], [3.0, 4.0]], [1e3, 0], 1),
    ],
)
def test_what_a_rejected_row_says_does_not_reach_the_others(kind, name, R, off, iterations, radar):
    gated, masked = begun(kind, radar, FAR, SURE), begun(kind, radar, FAR, SURE)
    z = np.array(FAR[:2]) if name == "fix" else HERE
    found = gated.update(name, np.array(R), z=np.add(z, off), gate=5.0, iterations=iterations)
    assert found.used.tolist() == [False, True]
    masked.update(name, np.array(R), z=np.add(z, off), rows=[False, True], iterations=iterations)
    np.testing.assert_array_equal(gated.x, masked.x)
    np.testing.assert_array_equal(gated.P, masked.P)


# ---- what is refused


@KINDS
@pytest.mark.parametrize(
    ("name", "R", "inputs", "said"),
    [
        ("radar", NOISE, {}, "radar needs z"),
        ("radar", NOISE, {"z": [1.0]}, r"radar: z has shape \(1,\); its last axis must be 2 long"),
        ("radar", NOISE, {"z": [1.0, np.nan]}, "radar: z holds a value that is not finite"),
        (
            "radar",
            [1.0],
            {"z": HERE},
            r"radar: R has shape \(1,\); it must be \(..., 2\), its variances, or \(..., 2, 2\)",
        ),
        ("radar", [1.0, -1.0], {"z": HERE}, "radar: every variance in R must be finite and above zero"),
        ("fix", [1.0, 1.0], {"z": HERE}, r"fix: R has shape \(2,\); it must be \(..., 2, 2\), its covariance"),
        ("fix", [[1.0, 0.5], [0.4, 1.0]], {"z": HERE}, "fix: R is not symmetric"),
        ("fix", [[1.0, 2.0], [2.0, 1.0]], {"z": HERE}, "fix: R has a negative eigenvalue"),
        ("fix", [[1.0, 1.0], [1.0, 1.0]], {"z": HERE}, "fix: R is not positive definite"),
        ("fix", [[1.0, 0.0], [0.0, 0.0]], {"z": HERE}, "fix: every variance in R"),
        ("lidar", NOISE, {}, "radar has no measurement 'lidar'; it has compass, fix, mounted, radar, smeared"),
    ],
)
def test_a_bad_z_or_R_is_one_line_and_changes_nothing(kind, name, R, inputs, said, radar):
    loop = begun(kind, radar, FAR, SURE)
    with pytest.raises(BoresightError, match=said):
        loop.update(name, np.array(R), **inputs)
    np.testing.assert_array_equal(loop.x, FAR)
    np.testing.assert_array_equal(loop.P, SURE)


def test_the_c_of_independent_rows_refuses_a_covariance_and_says_what_to_do(radar):
    loop = begun(CompiledFilter, radar, FAR, SURE)
    with pytest.raises(BoresightError, match=r"radar: R has shape \(2, 2\), .*correlated=True, or fly Filter"):
        loop.update("radar", FULL, z=HERE)


def test_a_z_of_the_model_is_not_brought(library):
    loop = Filter(library, {"q_b2n_wxyz": [1, 0, 0, 0], "mu": np.zeros(3)}, np.eye(6))
    with pytest.raises(BoresightError, match="euler makes its z of its inputs; leave z out"):
        loop.update("euler", np.ones(3), z=np.zeros(3), euler_b=np.zeros(3), euler_m=np.zeros(3))


@pytest.mark.parametrize("options", [(), ("-DBORESIGHT_FLOAT",)], ids=["joseph", "ud in float"])
def test_the_self_test_holds_all_of_it_in_both_forms(options, radar_folder, tmp_path):
    done = self_test(radar_folder, tmp_path, *STRICT, *options, "-O0")
    assert done.returncode == 0, done.stdout


@KINDS
@pytest.mark.parametrize(
    "given", [{"gate": g} for g in (0, -1.0, np.nan, np.inf, "5")] + [{"rows": ["range"]}, {"iterations": 1.5}], ids=str
)
def test_a_gate_of_no_size_rows_by_name_and_broken_iterations_are_refused(kind, given, radar):
    loop = begun(kind, radar, NEAR, WIDE)
    with pytest.raises(BoresightError, match=f"^radar: {next(iter(given))} is "):
        loop.update("radar", NOISE, z=HERE, **given)
    np.testing.assert_array_equal(loop.x, NEAR)
    np.testing.assert_array_equal(loop.P, WIDE)
