"""The experiment at sea: truth against its own laws, filters against chi-square, an unknown delay against theory."""

from dataclasses import replace

import numpy as np
import pytest

from boresight import BoresightError
from boresight.derive.papers import paper
from boresight.runtime import rotation
from boresight.runtime.filter import Filter
from boresight.runtime.library import load
from boresight.runtime.simulation import hull, inertial, sensors
from boresight.runtime.units import DEG, MIL
from boresight.studies.explorations import sea_claims
from boresight.studies.sea_state import bench as sea_bench
from boresight.studies.sea_state import delay as sea_delay
from boresight.studies.sea_state import experiment as sea_state
from boresight.studies.sea_state import flight as sea_flight
from boresight.studies.sea_state.flight import FILTERS, Scenario, draw, fly, motion_of, truth
from tests.drawing import drawn

WITH, WITHOUT = (FILTERS.index(name) for name in ("with", "without"))
SHORT = Scenario(height_m=(1.25, 4.0), seconds=20)


@pytest.fixture(scope="module")
def model():
    return load("velocity-attitude")


@pytest.fixture(scope="module")
def slope(model):
    """States 1, 3 and 5 under the slope, 40 runs."""
    return fly(model, "slope", Scenario(height_m=(0.01, 0.5, 2.5)), runs=40, seed=3)


# ---- truth


@pytest.mark.parametrize("kind", ["slope", "sea"])
def test_ideal_increments_make_the_slave_that_rides_on_the_hull(model, kind):
    s = replace(SHORT, seconds=3, gyro_misalignment_mrad=0.0)
    drawn = draw(s, 0, 2)
    motion = motion_of(kind, s, drawn.streams)
    true = truth(model, motion, s, drawn)
    first = true.slave.nav(0)
    made = inertial.integrate(model.strapdown, first, true.dtheta, true.dv, 1 / s.navigation_hz)
    time = np.arange(s.seconds * s.navigation_hz + 1) / s.navigation_hz
    mounting = rotation.quaternion_from_euler([0, 0, 2 * DEG])
    wanted = hull.carried(hull.ride(motion, time), np.array(s.lever_b), mounting)
    np.testing.assert_allclose(made.v_n, wanted.v_n, atol=1e-9)
    assert np.abs(rotation.attitude_error(made.q_b2n_wxyz, wanted.q_b2n_wxyz)).max() < 1e-10


def test_the_master_reports_what_was_a_delay_ago(model):
    drawn = draw(SHORT, 0, 3)
    assert ((drawn.delay >= 5e-3) & (drawn.delay <= 10e-3)).all()
    motion = motion_of("slope", SHORT, drawn.streams)
    true = truth(model, motion, SHORT, drawn)
    for run, delay in enumerate(drawn.delay):
        then = hull.ride(motion, np.arange(SHORT.seconds + 1) - delay)
        np.testing.assert_allclose(true.master.v_n[:, :, run], then.v_n[:, :, 0], atol=1e-12)


def test_the_paper_s_sinusoid_is_heave_and_nothing_else():
    motion = motion_of("wave", Scenario(), [])
    time = np.linspace(0, 20, 81)
    pose = hull.ride(motion, time)
    for grade, height in enumerate((0.01, 0.1, 0.5, 1.25, 2.5, 4.0)):
        wanted = -height * np.sin(2 * np.pi * 0.1 * time)  # a sin(2 pi f t), up; NED is down
        np.testing.assert_allclose(pose.displacement_n[:, grade, 0, 2], wanted, atol=1e-12)
    np.testing.assert_allclose(pose.displacement_n[..., :2], 0, atol=1e-12)
    np.testing.assert_allclose(pose.omega_nb_b, 0, atol=1e-15)


def test_a_run_is_the_same_whatever_runs_are_flown_beside_it(model):
    s = replace(SHORT, seconds=3)
    whole, part = (fly(model, "sea", s, runs=n, seed=5, first_run=k) for n, k in ((3, 0), (2, 1)))
    np.testing.assert_allclose(whole.error[:, :, :, 1:], part.error, atol=1e-13)
    np.testing.assert_array_equal(whole.delay[1:], part.delay)


# ---- filter


def test_without_errors_and_delay_the_filter_finds_the_truth(model):
    flight = fly(model, "slope", SHORT, runs=1, seed=0, delay_s=np.zeros((2, 1)), noise=0.0)
    # it began 35.6 mil off, of which second order is 0.6
    assert (np.abs(flight.heading[-1]) < 0.1 * MIL).all()
    # 40 ms chords and 1 Hz updates leave the delay a tenth of a millisecond, of which the filter's own sigma knows more
    assert (np.abs(flight.error[-1, WITH, ..., 15]) < 0.5 * flight.sigma[-1, WITH, ..., 15]).all()
    assert np.abs(flight.error[-1, ..., 3:6]).max() < 1e-3


def test_the_flights_are_those_of_the_plain_loop_in_python(model):
    """Ten covariance steps to an update, each linearised in its middle; rates as means of 40 ms, extended to now."""
    s = replace(SHORT, seconds=3)
    came = sea_flight.signals(model, "slope", s, runs=2, seed=4)
    flight = fly(model, "slope", s, runs=2, seed=4, belief=sea_flight.Belief())
    nav, P = sea_flight.start(model, came, s, sea_flight.Belief())
    given, R, dt = sea_flight.constants(s), sea_flight.matching_variances(s), 1 / s.navigation_hz
    lever_b, before = given["lever_b"], came.increments(1)[0]
    nav = {name: np.broadcast_to(value, (2, 2, *np.shape(value)[-1:] * (name != "tau"))) for name, value in nav.items()}
    loop = Filter(model, nav, np.broadcast_to(P, (2, 2, 16, 16)))
    for update in range(1, 4):
        samples = came.increments(update)
        for k, one in enumerate(samples):
            if k % 10 == 5:
                f_b = samples[k - 5 : k + 5, ..., 3:].mean(0) / dt - loop.nav["accel_bias"]
                loop.predict(f_b=f_b, dt=0.1, **{name: value for name, value in given.items() if name != "lever_b"})
            loop.strapdown(dtheta_ib_b=one[..., :3], dv_b=one[..., 3:], dtheta_before=before[..., :3],
                           dv_before=before[..., 3:], dt=dt)  # fmt: skip
            before = one
        late, early = samples[-4:].mean(0) / dt, samples[-8:-4].mean(0) / dt
        rates = late + (late - early) / 2 - np.concatenate([loop.nav["gyro_bias"], loop.nav["accel_bias"]], axis=-1)
        omega, alpha = rates[..., :3], (late - early)[..., :3] / (4 * dt)
        a_b = rates[..., 3:] - np.cross(alpha, lever_b) - np.cross(omega, np.cross(omega, lever_b))
        a_n = np.einsum("...ij,...j->...i", rotation.matrix_from_quaternion(loop.nav["q_b2n_wxyz"]), a_b)
        master = {
            "omega_ib_b": omega,
            "lag": loop.nav["tau"],
            "a_n": np.add(a_n, [0.0, 0.0, 9.798]),
            "lever_b": lever_b,
        }
        swung = given["gyro_noise"][0] ** 2 * 2.5 / 0.04 * lever_b @ lever_b * 2 / 3
        nis = [loop.update("dcm", R[3:], q_m2n_wxyz=came.q_m2n_wxyz[update], **master).nis,
               loop.update("velocity", R[:3] + swung, v_m_n=came.v_m_n[update], **master).nis]  # fmt: skip
        loop.feedback()
        np.testing.assert_allclose(flight.nis[update - 1], np.stack(nis, axis=-1), rtol=1e-7)
    assert (np.abs(came.error(loop.nav, 3) - flight.error[3]) < 1e-9 * flight.sigma[3]).all()


def test_nees_and_nis_of_the_compensated_filter_lie_within_chi_square(slope):
    """16 states at the end and 6 rows after 10 s; 40 runs, four sigmas of the mean."""
    nis = slope.nis[10:, WITH].sum(-1).mean((0, 2))
    assert (np.abs(nis - 6) < 4 * np.sqrt(12 / (50 * 40))).all()
    e, P = slope.error[-1, WITH, 1:], slope.P[WITH, 1:]
    nees = np.einsum("...i,...i->...", e, np.linalg.solve(P, e[..., None])[..., 0]).mean(-1)
    assert (np.abs(nees - 16) < 4 * np.sqrt(32 / 40)).all()


def test_a_calm_does_not_show_the_heading_and_a_swell_does(slope):
    sigma = slope.heading_sigma[-1, WITH].mean(-1) / MIL
    assert sigma[0] > 20 and sigma[1] < 1.5 and sigma[2] < 0.3
    assert (np.abs(slope.heading[-1, WITH]).mean(-1) < 2.0 * sigma).all()


def test_the_nis_shows_a_delay_that_nobody_compensates(slope):
    nis = slope.nis[10:, WITHOUT].sum(-1).mean((0, 2))
    assert nis[2] > 10


def test_heave_alone_leaves_the_heading_unknown(model):
    flight = fly(model, "wave", replace(Scenario(), height_m=(4.0,)), runs=4, seed=0)
    assert (flight.heading_sigma[-1, WITH] > 30 * MIL).all()


def test_a_bending_that_has_no_state_shows_in_the_nis_and_not_in_the_heading(model):
    stiff, soft = (fly(model, "slope", replace(SHORT, bending_mrad=bend), runs=3, seed=0) for bend in (0.0, 0.2))
    nis = [flight.nis[10:, WITH].sum(-1).mean() for flight in (stiff, soft)]
    assert nis[0] < 8 and nis[1] > 15
    assert (np.abs(soft.heading[-1, WITH]).mean(-1) < 5 * MIL).all()


# ---- an unknown delay


def test_the_study_s_closed_form_is_the_derived_one():
    from sympy import lambdify

    heading, form = paper("delay-error").equation("4").derived[1].sides
    letters = {symbol.name: symbol for symbol in form.free_symbols}
    assert heading.name == "δψ" and set(letters) == set("τΩRPε")
    derived = lambdify([letters[name] for name in "τΩRPε"], form)
    rng = sensors.generator(0, 0)
    for _ in range(20):
        tau, f, roll, ratio, phase = rng.uniform([1e-3, 0.05, 0.01, 0.1, -3], [0.02, 0.5, 0.2, 3, 3])
        wanted = derived(tau, 2 * np.pi * f, roll, ratio * roll, phase)
        assert sea_delay.closed_form(tau, ratio, phase, f) == pytest.approx(wanted, rel=1e-12)


def test_the_general_form_holds_the_sinusoid_and_the_derived_moments():
    rows = sea_delay.cases()
    motion = sea_delay.swing(rows)
    tau = 1e-3 * np.array([row["delay_ms"] for row in rows])
    sinusoid = sea_delay.closed_form(
        tau,
        *(np.array([row[name] for row in rows]) * unit for name, unit in (("ratio", 1), ("phase_deg", DEG))),
        np.array([row["frequency_hz"] for row in rows]),
    )
    np.testing.assert_allclose(sea_delay.predicted_heading(motion, tau[:, None])[:, 0], sinusoid, atol=1e-12)

    # three axes and many frequencies: moments over a long time, put into the derived moments of inertia and momentum
    inertia, momentum = map(str, paper("delay-error").equation("2").derived[1].sides)
    assert (inertia, momentum) == ("E(-e*transpose(e) + norm(e)**2*I)*μ̂", "τ*E(cross(e, ė))")
    s = replace(Scenario(), height_m=(4.0,))
    drawn = draw(s, 0, 1)
    motion = motion_of("sea", s, drawn.streams)
    value, rate, _ = motion.freedoms.thrice(np.arange(0, 20000, 0.5))
    e, e_1 = value[:, 0, 0, 3:], rate[:, 0, 0, 3:]
    J = np.mean(np.sum(e**2, -1)) * np.eye(3) - e.T @ e / len(e)
    wanted = -np.linalg.solve(J, np.mean(np.cross(e, e_1), 0))[2]  # the heading errs by minus the misalignment
    assert sea_delay.predicted_heading(motion, 1.0)[0, 0] == pytest.approx(wanted, rel=0.03)


def test_simulation_follows_the_closed_form_wherever_its_variables_go(model):
    result = sea_delay.against_simulation(model, Scenario())
    assert len(result["cases"]) > 25
    assert result["all_good"], [row for row in result["cases"] if not row["good"]]


def test_in_a_random_sea_the_mean_error_is_the_predicted_one(model):
    s = Scenario(height_m=(2.5,))
    flight = fly(model, "sea", s, runs=30, seed=2)
    motion = motion_of("sea", s, draw(s, 2, 30).streams)
    predicted = sea_delay.predicted_heading(motion, flight.delay)[0] / MIL
    flown = flight.heading[-1, WITHOUT, 0] / MIL
    # each run sees 60 s of its sea: they scatter about the mean of all seas
    assert flown.mean() == pytest.approx(predicted.mean(), abs=4 * flown.std() / np.sqrt(30))
    assert predicted.mean() > 2


def test_both_ways_compensate(model):
    two = sea_delay.ways(model, replace(SHORT, height_m=(0.01, 0.1, 0.5, 1.25, 2.5, 4.0)), runs=3, seed=0)
    for name in sea_delay.WAYS:
        assert two[name]["heading_mil"][0][-1] < 1.0 and two[name]["delay_error_ms"][0][-1] < 1.5
    # a chord through 50 to 100 ms of a curve is what a buffer has no need of
    assert two["by a buffer"]["nis"][1][-1] < two["the paper's"]["nis"][1][-1]


# ---- the study


def test_every_variant_has_a_motion_and_a_scenario_that_has_a_meaning():
    for variant in sea_claims.VARIANTS:
        s = sea_flight.checked(replace(Scenario(), **variant.changes))
        motion = variant.kind
        motion = motion_of(motion, s, draw(s, 0, 1).streams) if isinstance(motion, str) else motion(s)
        assert hull.ride(motion, np.zeros(1)).v_n.shape[1] == 6, variant.says
    # (6) as roll: 0.5 degrees in state 3, at its quarter period
    rolled = next(v for v in sea_claims.VARIANTS if v.says == "(6) as roll in degrees").kind(Scenario())
    assert rolled.freedoms.at([2.5])[0, 2, 0, 3] == pytest.approx(0.5 * DEG)


def test_the_study_reports_and_draws(model, tmp_path):
    result = sea_state.run(Scenario(runs=2, motions=("slope",), bench_runs=0, seconds=40))
    text = sea_state.report(result)
    claims = sea_state.claims(result)
    assert len(claims) == 6
    for claim in claims:
        assert f"  {'holds ' if claim.holds else 'NOT SO'}  {claim.says}\n" in text
    written = drawn(sea_state.STUDY, result, tmp_path)
    assert len(written) == 4 and all(path.stat().st_size > 10_000 for path in written)


def test_the_bench_needs_a_roll(model):
    s = replace(Scenario(), seconds=12)
    result, _ = sea_bench.experiment(model, s, runs=3, seed=0)
    right = result["right"]
    assert right["mean_deg"][0] > 1.0 and max(right["worst_deg"][1:]) < 1.0
    assert right["sigma_deg"][1] > right["sigma_deg"][2] > right["sigma_deg"][3]
    assert any("at rest" in line for line in sea_bench.report(result))


@pytest.mark.parametrize(
    "change, says",
    [
        ({"gyro_bias_deg_h": -1.0}, "gyro_bias_deg_h is -1.0"),
        ({"attitude_noise_deg": 0.0}, "attitude_noise_deg is 0"),
        ({"latitude_deg": float("nan")}, "latitude_deg is nan"),
        ({"covariance_hz": 7}, "multiple of covariance_hz 7"),
        ({"covariance_hz": 20, "update_hz": 20}, "update_hz is 20; it must be at most 12.5"),
    ],
)
def test_a_scenario_without_meaning_is_refused_by_name(change, says):
    with pytest.raises(BoresightError, match=says):
        sea_flight.checked(replace(Scenario(), **change))
    with pytest.raises(BoresightError, match="no motion 'waves'"):
        motion_of("waves", Scenario(), [])
