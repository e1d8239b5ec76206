"""Single precision: UD keeps a covariance where the other forms lose it, and what it costs in accuracy."""

from dataclasses import replace

import numpy as np
import pytest

from boresight.runtime.library import load
from boresight.studies.float_covariance import covariance as study
from boresight.studies.float_covariance.covariance import (
    COARSE,
    CORNERS,
    GENTLE,
    NOISE,
    compare,
    deviation,
    estimates,
    fly,
)
from tests.drawing import drawn

pytestmark = pytest.mark.usefixtures("compiled_once")


def short(start, seconds):
    return replace(start, seconds=seconds)


@pytest.mark.parametrize("start", [GENTLE[2], COARSE[3]], ids=lambda start: start.name)
def test_the_reference_in_double_is_that_of_sixty_digits(start):
    """P = Phi P Phi' + Q and P - P h (h' P) / S, in balls of 200 bits, from the printed Phi and Q; 3 s."""
    import flint

    flint.ctx.prec = 200
    model, path = load("azimuth-hold"), study.motion("rest", 3, study.STEP_S)[0]
    fields = {"lon_lat_height": path[:3], "v_n": path[3:6], "q_b2n_wxyz": path[6:10]}
    fields |= {"f_b": path[10:], "dt": study.STEP_S}
    names = ("gyro_noise", "accel_noise", "gyro_bias_noise", "accel_bias_noise")
    noise = dict(zip(names, NOISE.reshape(4, 3), strict=True))
    Phi = flint.arb_mat(model.Phi(**fields).tolist())
    Q = flint.arb_mat(model.Q(**fields, **noise).tolist())
    P = flint.arb_mat(np.diag(start.sigma**2).tolist())
    flown = fly("double", "ud", short(start, 3))
    for second in range(3):
        for _ in range(100):
            P = Phi * P * Phi.transpose() + Q
            P = flint.arb_mat(15, 15, [x.mid() for x in P.entries()])
        for k, R in zip((3, 4, 5, 8), start.R, strict=True):
            g = flint.arb_mat(15, 1, [P[i, k] for i in range(15)])
            P = P - g * g.transpose() * (1 / (P[k, k] + flint.arb(R)))
        exact = np.array([[float(P[i, j].mid()) for j in range(15)] for i in range(15)])
        assert deviation(flown.P[second][None], exact[None]).max() < 1e-8


@pytest.mark.parametrize("start", COARSE, ids=lambda start: start.name)
def test_from_coarse_starts_ud_stays_a_covariance_in_float_and_no_other_form_does(start):
    wanted = tuple(("float", form, 100.0) for form in study.FORMS)
    ud, *others = compare(short(start, 15), "rest", wanted)
    assert ud["dies_s"] is None and ud["refused_s"] is None
    assert ud["deviation"] < 0.005
    assert ud["least_eigenvalue"] > 0
    for row in others:
        assert row["dies_s"] is not None and row["dies_s"] <= 12, row["form"]


def test_from_every_corner_ud_keeps_its_sigmas_in_a_circle_and_joseph_dies_or_is_ten_times_worse():
    for start in CORNERS[::5]:
        ud, joseph, slow = compare(short(start, 20), "circle", study.SHORT)
        assert ud["dies_s"] is None and ud["deviation"] < 0.005, start.name
        assert slow["dies_s"] is None and slow["deviation"] < 0.005, start.name
        assert joseph["dies_s"] is not None or joseph["deviation"] > 10 * ud["deviation"], start.name


def test_a_lower_rate_of_the_covariance_loses_less():
    """Each prediction in float rounds; a tenth of them leaves less than half of the deviation."""
    fast, slow = compare(short(GENTLE[2], 900), "rest", (("float", "ud", 100.0), ("float", "ud", 10.0)))
    assert slow["deviation"] < fast["deviation"] / 2
    exact = fly("double", "ud", short(GENTLE[2], 100), "circle", 10.0)
    assert deviation(exact.P, fly("double", "ud", short(GENTLE[2], 100), "circle").P).max() < 1e-4


def test_the_estimate_in_float_is_that_in_double_if_the_navigation_is_in_double():
    for start in (GENTLE[2], *COARSE[:3]):
        found = estimates(short(start, 60), "ud", seed=4, runs=2)
        assert found["later"] < 0.05, start.name
        assert 5 < found["nees_double"] < 30, start.name  # 15 states: the errors flown are those the filter expects
        assert found["nees_float"] == pytest.approx(found["nees_double"], rel=1e-2), start.name
    lost = estimates(short(COARSE[1], 60), "joseph", seed=4, runs=1)
    assert lost["later"] is None or lost["later"] > 3


def test_a_strapdown_in_double_with_the_filter_in_float_navigates_as_all_in_double():
    double, mixed, single = study.navigations(short(GENTLE[0], 120), seed=5)
    assert double["refused_s"] is None and mixed["refused_s"] is None
    assert double["apart_sigmas"] == 0 and 0 < mixed["apart_sigmas"] < 0.01
    assert double["nees"] < 30  # 15 states
    assert single["apart_sigmas"] > mixed["apart_sigmas"]


def test_a_latitude_in_float_does_not_move_below_nineteen_metres_a_second():
    """At 45 degrees its numbers are 0.38 m apart, and a step of 0.01 s of less than half of that is rounded away."""
    latitude = np.float32(np.pi / 4)
    assert latitude + np.float32(18.0 * 0.01 / study.RADIUS_M) == latitude
    assert latitude + np.float32(20.0 * 0.01 / study.RADIUS_M) > latitude


def test_a_scale_that_is_a_power_of_two_changes_nothing_but_the_exponent():
    """Metres for radians is a matter of range, not of rounding: P - g g' / S of scaled numbers is the scaled one."""
    rng = np.random.default_rng(6)
    root = rng.standard_normal((15, 15)).astype(np.float32)
    P, scale = root @ root.T, np.float32(2.0) ** rng.integers(-20, 22, 15).astype(np.float32)
    scaled = P * scale[:, None] * scale[None, :]
    one = P - np.outer(P[:, 3], P[:, 3]) / (P[3, 3] + np.float32(0.1))
    other = scaled - np.outer(scaled[:, 3], scaled[:, 3]) / (scaled[3, 3] + np.float32(0.1) * scale[3] ** 2)
    assert np.array_equal(one * scale[:, None] * scale[None, :], other)


def test_what_stopped_being_a_covariance_is_seen():
    P = np.tile(np.eye(15), (3, 1, 1))
    P[1, 0, 1] = P[1, 1, 0] = 1.0001
    P[2, 4, 4] = np.nan
    least = study.smallest_eigenvalue(P)
    assert least[0] == pytest.approx(1) and -1 < least[1] < 0 and least[2] == -1


def test_report_and_figures(tmp_path, monkeypatch):
    monkeypatch.setattr(study, "CORNERS", CORNERS[:1])
    result = study.run(study.Asked(seed=1, estimates=1, longest_s=5))
    text = study.report(result)
    assert text.splitlines()[-1].startswith("float-covariance: UD in float within")
    assert "dies, 1 s" in text
    assert study.LOOK.keys() <= {*study.ALL}  # each that has a look is flown, and so drawn
    written = drawn(study.STUDY, result, tmp_path)
    assert [path.name for path in written] == ["float-gentle.png", "float-coarse.png"]
    assert all(path.stat().st_size > 10_000 for path in written)
