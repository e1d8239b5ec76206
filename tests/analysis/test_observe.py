"""What a motion shows of each state, beside sums of information and a Gramian that are computed otherwise."""

import json
from types import SimpleNamespace

import numpy as np
import pytest
from conftest import ROOT
from scipy.linalg import solve_discrete_lyapunov
from typer.testing import CliRunner

from boresight import BoresightError, Filter, load, observability
from boresight.analysis import nominal
from boresight.cli import app

H1 = np.array([[1.0, 1.0]])


class Given:
    """A model whose Phi, Q and H come with each step, and that measures z = H x."""

    def __init__(self, *states):
        self.states = states
        self.Phi, self.Q, self.seen_H = (
            observability.with_fields(function, name)
            for function, name in (
                (lambda phi: phi, "phi"), (lambda q: q, "q"), (lambda h: h, "h"),
            )
        )  # fmt: skip


def flight(model, motion, seconds=60.0, **changed):
    sizes = nominal.settings(model) | changed
    start, steps = nominal.flight(model, nominal.nominal(model, motion, seconds), sizes)
    return observability.observe(model, start, steps)


def test_a_sum_alone_is_shown_and_the_words_say_so():
    step = {"phi": np.eye(2), "q": np.zeros((2, 2)), "dt": 0.5}
    found = observability.observe(Given("a", "b"), np.eye(2), [step, ("seen", [1e-6], {"h": H1})] * 4)
    assert np.allclose(found.part, np.sqrt(0.5), atol=1e-4) and np.isnan(found.seconds).all()
    assert found.worst() in ("a and b move against each other, 1.00; 1.00 is left",
                             "b and a move against each other, 1.00; 1.00 is left")  # fmt: skip
    assert found.condition == np.inf and found.times.tolist() == [0, 0.5, 1, 1.5, 2]


def test_a_state_that_is_shown_has_its_time_and_the_other_stands_alone():
    step = {"phi": np.eye(2), "q": np.zeros((2, 2)), "dt": 1.0}
    found = observability.observe(Given("a", "b"), np.diag([4.0, 1.0]), [step, ("seen", [4.0], {"h": H1 * [1, 0]})] * 9)
    # 1 / P = 1 / 4 + k / 4: below a quarter of 4 from k = 4 on, for at k = 3 it is half to the bit
    assert found.seconds[0] == 4.0 and np.isnan(found.seconds[1])
    assert np.allclose(found.sigma[:, 0], 2 / np.sqrt(1 + np.arange(10)))
    assert found.worst() == "b alone: 1.00 of its sigma at the start is left"


def test_the_start_is_before_a_measurement_that_comes_first():
    step, read = {"phi": np.eye(2), "q": np.zeros((2, 2)), "dt": 1.0}, ("seen", [1.0], {"h": H1 * [1, 0]})
    for steps in ([read], [read, step, read]):
        found = observability.observe(Given("a", "b"), np.eye(2), steps)
        reads = steps.count(read)
        assert np.allclose(found.part, [1 / np.sqrt(1 + reads), 1]) and found.times.tolist() == [0, 0, 1][: 1 + reads]


def test_without_process_noise_the_covariance_is_that_of_the_information(library):
    zero = {"gyro_noise": np.zeros(3)}
    start, steps = nominal.flight(
        library, nominal.nominal(library, "sea 4", 40.0), nominal.settings(library) | {"gyro_noise": 0.0}
    )
    found = observability.observe(library, start, steps)
    P0, Psi, information = sum(start.values()), np.eye(6), np.zeros((6, 6))
    for step in steps:
        if isinstance(step, dict):
            Psi = library.Phi(**{name: step[name] for name in library.Phi.fields}) @ Psi
            assert not library.Q(**{name: ({**step, **zero})[name] for name in library.Q.fields}).any()
        else:
            name, R, given = step
            unit = getattr(library, f"{name}_H")
            H = unit(**{field: {**given, "x": np.zeros(6)}[field] for field in unit.fields}) @ Psi
            information += H.T @ np.diag(1 / R) @ H
    P = Psi @ np.linalg.inv(np.linalg.inv(P0) + information) @ Psi.T
    scale = np.sqrt(np.diag(P))
    assert np.abs((found.P - P) / np.outer(scale, scale)).max() < 1e-6
    first = np.sqrt(np.diag(P0))
    assert np.allclose(found.information, information * np.outer(first, first), rtol=1e-9, atol=1e-3)


def test_the_information_of_a_time_invariant_model_is_its_gramian():
    rng, n, steps = np.random.default_rng(0), 4, 25
    A = rng.standard_normal((n, n))
    A *= 0.95 / np.abs(np.linalg.eigvals(A)).max()
    H, R = rng.standard_normal((2, n)), np.array([0.5, 2.0])
    step = {"phi": A, "q": np.zeros((n, n)), "dt": 1.0}
    found = observability.observe(Given(*"abcd"), np.eye(n), [step, ("seen", R, {"h": H})] * steps)
    whole = solve_discrete_lyapunov(A.T, H.T / R @ H)  # sum over k >= 0 of A'^k H' R^-1 H A^k
    first, last = A, np.linalg.matrix_power(A, steps + 1)
    gramian = first.T @ whole @ first - last.T @ whole @ last
    assert np.allclose(found.information, gramian, rtol=1e-9, atol=1e-9)
    assert found.condition == pytest.approx(np.linalg.cond(gramian), rel=1e-6)


def test_a_lever_arm_on_a_straight_line_keeps_its_sigma_and_turns_show_it():
    """Lever arm (2.2, .75) m in a plane, 15 s straight, then turns; the course is known, the place is not."""
    rng, lever, prior = np.random.default_rng(1), np.array([2.2, 0.75]), np.array([3.0, 1.0])
    q, dt, R = np.diag([0.01, 0.01, 0, 0]) * 0.1, 0.1, np.full(2, 0.02**2)
    start = np.diag([100.0, 100.0, *prior]) ** 2

    def H(psi):
        c, s = np.cos(psi), np.sin(psi)
        return np.array([[1, 0, c, -s], [0, 1, s, c]])

    def steps(turning):
        psi = np.where(np.arange(400) < 150, 0.3, 0.3 + turning * 0.02 * (np.arange(400) - 150))
        for angle in psi:
            yield {"phi": np.eye(4), "q": q, "dt": dt}
            yield "seen", R, {"h": H(angle)}

    model = Given("east", "north", "lever_x", "lever_y")
    straight, turned = (observability.observe(model, start, list(steps(turning))) for turning in (0, 1))
    assert np.allclose(straight.part[2:], 1.0, atol=1e-3) and (straight.part[2:] <= 1).all()
    assert (turned.sigma[-1, 2:] < 0.15).all() and np.isnan(straight.seconds[2:]).all()
    assert (turned.seconds[2:] > 15).all() and np.allclose(turned.sigma[150, 2:], prior, rtol=1e-3)
    # and flown: it is found within its sigma
    loop = Filter(model, {}, start, x=np.zeros(4))
    place = np.zeros(2)
    for one in steps(1):
        if isinstance(one, dict):
            loop.predict(phi=one["phi"], q=one["q"])
            place = place + np.sqrt(q[0, 0]) * rng.standard_normal(2)
        else:
            h = one[2]["h"]
            loop.update("seen", R, z=h @ [*place, *lever] + 0.02 * rng.standard_normal(2), h=h)
    assert (np.abs(loop.x[2:] - lever) < 3 * np.sqrt(np.diag(loop.P))[2:]).all()
    assert np.allclose(np.sqrt(np.diag(loop.P))[2:], turned.sigma[-1, 2:], rtol=1e-9)


def test_motions_of_a_built_in_model_show_what_is_known_of_them():
    model = load("velocity-attitude-lever")
    found = {name: flight(model, name) for name in ("straight", "steady turn", "sea 4")}
    at = {name: model.states.index(name) for name in ("phi_d", "dmu_z", "d_tau", "d_lever_x", "dba_x")}
    straight = found["straight"].part
    assert all(straight[at[name]] > 0.99 for name in ("phi_d", "dmu_z", "d_tau", "d_lever_x"))
    assert "misalignment error z" in found["straight"].worst() and "attitude error d" in found["straight"].worst()
    assert all(found["sea 4"].part[at[name]] < 0.6 for name in at)
    assert found["straight"].condition == np.inf > found["sea 4"].condition
    text = observability.report(found)
    assert text.splitlines()[1].split()[:1] == ["state"] and "dmu_z" in text and max(map(len, text.splitlines())) < 120


def test_a_total_state_goes_on_by_its_own_equation(folder_of):
    model = load(folder_of(f"{ROOT / 'examples' / 'pendulum.py'}:PENDULUM"))
    step, seen = {"rod": [1.0, 0.2], "torque": 0.05, "dt": 0.02}, ("encoder", [4e-4], {})
    found = observability.observe(model, np.diag([0.1, 0.3]) ** 2, [*[step] * 5, seen] * 20, x=[2.0, 6.0])
    loop = Filter(model, {}, np.diag([0.1, 0.3]) ** 2, x=[2.0, 6.0])
    for _ in range(20):
        for _ in range(5):
            loop.predict(**step)
        loop.update("encoder", 4e-4, z=loop.x[:1])  # as expected: the estimate stays on the nominal motion
    assert np.allclose(found.P, loop.P, rtol=1e-9, atol=1e-15) and found.times[-1] == pytest.approx(2.0)
    assert nominal.sizes(["theta 0.1 rad", "rate 2 rad/s"], model) == {
        "angle": 0.1,
        "rate": 2.0,
    }  # by its letter, by its name
    with pytest.raises(BoresightError, match="it has states angle, rate; measurements encoder; inputs rod, torque"):
        nominal.sizes(["phi 1 rad"], model)
    with pytest.raises(BoresightError, match=r"pendulum: no state has a sigma at the start; .* --set 'angle 1 rad'"):
        nominal.flight(model, SimpleNamespace(inputs={}), nominal.settings(model))
    with pytest.raises(BoresightError, match="observe: pendulum has a total state"):
        observability.observe(model, np.eye(2), [step, seen])


def test_what_cannot_be_followed_is_one_line():
    step = {"phi": np.eye(2), "q": np.zeros((2, 2)), "dt": 0.5}
    with pytest.raises(BoresightError, match="observe: there are no steps"):
        observability.observe(Given("a", "b"), np.eye(2), [])
    with pytest.raises(BoresightError, match="leave out inflate, set_block and enable"):
        observability.observe(Given("a", "b"), np.eye(2), [step, ("inflate", 0, [1.0])])
    with pytest.raises(BoresightError, match="negative"):
        observability.observe(Given("a", "b"), -np.eye(2), [step])


def test_the_command_prints_the_table_and_its_json_and_figure(tmp_path):
    words = ["observe", "euler-matching", "--motion", "still", "--motion", "sea 4", "--seconds", "20"]
    shown = CliRunner().invoke(app, words)
    assert shown.exit_code == 0 and "eps_d" in shown.output and "sea 4, 20 s:" in shown.output
    done = CliRunner().invoke(app, [*words, "--json", "-o", str(tmp_path)])
    document = json.loads(done.output)
    assert document == json.loads((tmp_path / "observe.json").read_text()) and (tmp_path / "observe.png").exists()
    still, sea = (document["motions"][name] for name in ("still", "sea 4"))
    assert still["condition"] is None and max(sea["part"]) < 0.2 < min(still["part"])
    own = tmp_path / "own.py"
    own.write_text(
        "import numpy as np\n"
        "def mine(model):\n"
        "    q = [1.0, 0, 0, 0]\n"
        "    step = {'q_b2n_wxyz': q, 'omega_in_n': np.zeros(3), 'gyro_noise': np.zeros(3), 'dt': 1.0}\n"
        "    angles = {'euler_b': np.zeros(3), 'euler_m': np.zeros(3)}\n"
        "    return np.eye(6) * 1e-4, [step, ('euler', np.full(3, 1e-8), angles)] * 3\n"
    )
    mine = CliRunner().invoke(app, ["observe", "euler-matching", "--motion", f"{own}:mine", "--json"])
    assert json.loads(mine.output)["motions"][f"{own}:mine"]["part"] == pytest.approx([np.sqrt(0.5)] * 6, rel=1e-3)
    for wrong, says in (("nowhere", "no motion 'nowhere'"), (f"{own}:other", "is no function")):
        refused = CliRunner().invoke(app, ["observe", "euler-matching", "--motion", wrong])
        assert isinstance(refused.exception, BoresightError) and says in str(refused.exception)


def test_a_start_without_variance_is_one_line(library):
    step = {"q_b2n_wxyz": [1, 0, 0, 0], "omega_in_n": np.zeros(3), "gyro_noise": np.zeros(3), "dt": 1.0}
    with pytest.raises(BoresightError, match="observe: no state has a variance at the start"):
        observability.observe(library, np.zeros((6, 6)), [step])


def test_a_measurement_without_a_size_is_named_and_one_with_a_size_is_flown():
    model = load("velocity-attitude")
    own = SimpleNamespace(measurements={**model.measurements, "wheel": model.measurements["velocity"]})
    sizes = nominal.settings(model)
    assert nominal.not_taken(own, sizes) == ["wheel"]
    assert nominal.not_taken_line(["wheel"], own) == "not flown: wheel; give the sigma, as --set 'wheel 1 m/s'\n"
    assert nominal.taken(own, sizes) == ["velocity", "dcm"]
    assert nominal.taken(own, sizes | {"wheel": 0.1}) == ["velocity", "dcm", "wheel"]
    assert nominal.not_taken(own, sizes | {"wheel": 0.1}) == nominal.not_taken(model, sizes) == []
