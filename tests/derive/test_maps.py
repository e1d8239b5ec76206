"""What a model makes is what the paper's equations say, in the paper's states: an edit of either is refused by name."""

from dataclasses import replace

import pytest
from sympy import Matrix

from boresight import BoresightError
from boresight.derive.ledger.carried import check_maps, model_of
from boresight.derive.ledger.map import Match, Row
from boresight.derive.papers import DERIVATIONS, PAPERS, paper
from boresight.derive.papers.song_lee_2001 import results

MAPPED = [name for name in PAPERS if paper(name).maps]
MATCHED = [(name, m.equation) for name in MAPPED for one in paper(name).maps for m in one.matches]


@pytest.mark.parametrize(("name", "number"), list(dict.fromkeys(MATCHED)))
def test_the_matrices_of_a_model_are_those_of_the_paper_in_other_states(name, number):
    check_maps(paper(name), number)


@pytest.mark.parametrize("name", MAPPED)
def test_every_equation_has_a_function_that_flies_or_a_reason(name):
    matched = {number for one, number in MATCHED if one == name}
    assert sorted([*matched, *paper(name).unflown], key=int) == [e.number for e in paper(name).equations if e.numbered]


def changed(name, which, **new):
    """The paper with another map in the place of the one to the model `which`."""
    one = paper(name)
    maps = tuple(replace(m, **new) if m.model().name == which else m for m in one.maps)
    return replace(one, maps=maps)


def refusal(one, number):
    with pytest.raises(BoresightError) as refused:
        check_maps(one, number)
    return str(refused.value)


def test_a_sign_of_the_map_is_refused_by_the_entry_that_it_turns():
    (transfer, hold) = paper("kim-2018").maps
    states = tuple(replace(row, factor="1") if row.ours == "d_tau" else row for row in transfer.states)
    assert "[velocity.e, d_tau]" in refusal(changed("kim-2018", "velocity-dcm", states=states), "6")
    states = tuple(replace(row, factor="1") if row.ours == "d_gyro_bias" else row for row in hold.states)
    assert "[phi_e, dbg_x]" in refusal(changed("kim-2018", "azimuth-hold", states=states), "7")


def test_an_edit_of_what_makes_the_c_is_refused_by_the_ledger(monkeypatch):
    hold = paper("kim-2018").maps[1]

    def edited():
        model = hold.model()
        F = model.F.copy()
        F[3, 7] = -F[3, 7]
        return replace(model, F=F)

    assert "F_k and F of azimuth-hold differ in [dv_e, phi_n]" in refusal(
        changed("kim-2018", "azimuth-hold", model=edited), "7"
    )


EDITS = {
    "measurement": ("16", lambda z: -z, "[euler.roll]"),
    "relative_euler": ("18", lambda z: z * 2, "[euler.roll]"),
    "measurement_matrix": ("19", lambda H: H[:, ::-1], "[euler.roll, eps_n]"),
    "attitude_error_matrix": ("20", lambda F: F.T, "[eps_n, eps_e]"),
    "attitude_noise_matrix": ("20", lambda G: -G, "[eps_n, gyro_noise_x]"),
    "corrected_quaternion": ("24", lambda q: q[::-1], "[q_b2n_wxyz[0]]"),
    "corrected_misalignment": ("25", lambda mu: -mu, "[mu[0]]"),
}


@pytest.mark.parametrize("name", EDITS)
def test_an_edit_of_a_function_of_song_and_lee_is_refused_by_the_ledger(name, monkeypatch):
    number, edit, place = EDITS[name]
    right = getattr(results, name)
    monkeypatch.setattr(results, name, lambda *arguments: Matrix(edit(right(*arguments))))
    (one,) = paper("song-lee-2001").maps
    edited = replace(paper("song-lee-2001"), maps=(replace(one),))  # a map of its own, whose model is made anew
    assert place in refusal(edited, number)


def test_a_map_that_varies_adds_its_own_rate():
    """Velocities in a unit which changes: T = 2, T' = 3, so the rate of T dv gains 3/2 of it."""
    transfer = paper("kim-2018").maps[0]
    states = (replace(transfer.states[0], factor="2", rate="3"), *transfer.states[1:])
    rows = (
        r"\frac{3}{2} I - 2 [\omega_{ie}^n \times] - [\omega_{en}^n \times] & 2 [f^n \times] & 0_{3 \times 4}",
        r"0_{3 \times 3} & -[\omega_{ie}^n \times] - [\omega_{en}^n \times] & 0_{3 \times 4}",
        r"0_{4 \times 3} & 0_{4 \times 3} & 0_{4 \times 4}",
    )
    written = r"\begin{bmatrix}" + r"\\".join(rows) + r"\end{bmatrix}"
    check_maps(changed("kim-2018", "velocity-dcm", states=states, matches=(Match("3", written, "F"),)), "3")
    still = (replace(states[0], rate="0"), *states[1:])
    assert "[dv_e, dv_e]" in refusal(
        changed("kim-2018", "velocity-dcm", states=still, matches=(Match("3", written, "F"),)), "3"
    )


def test_what_a_map_lacks_or_misnames_is_one_clear_line():
    transfer = paper("kim-2018").maps[0]
    short = changed("kim-2018", "velocity-dcm", states=transfer.states[:3])
    assert refusal(short, "3") == "kim-2018: 9 of the 10 states of velocity-dcm are in its map"
    unknown = changed("kim-2018", "velocity-dcm", states=(*transfer.states[:3], Row(r"\Delta t", "tau_error")))
    assert refusal(unknown, "3") == "kim-2018: velocity-dcm has no tau_error"
    inputs = {name: latex for name, latex in transfer.inputs.items() if name != "f_b"}
    assert "velocity-dcm reads 'f_x', which its map does not give" in refusal(
        changed("kim-2018", "velocity-dcm", inputs=inputs), "3"
    )
    wrong = (*transfer.matches, Match("3", r"\delta v^n", "F"))
    assert "3x1 beside 10x10" in refusal(changed("kim-2018", "velocity-dcm", matches=wrong), "3")


@pytest.mark.parametrize("name", [*PAPERS, *DERIVATIONS])
def test_what_a_map_holds_is_cited_by_what_makes_the_c(name):
    for one in paper(name).maps:
        model = model_of(one)
        measured = {m.name: m.equations for m in model.measurements}
        functions = {f.name: f.equations for f in model.functions}
        for match in one.matches:
            if (name, match.ours) == ("kang-2025", "F"):  # which that paper does not print
                continue
            cited = [measured[of] for of in match.of] or [functions.get(match.ours.partition(".")[0], model.equations)]
            assert all(f"{name} ({match.equation})" in equations for equations in cited), (model.name, match)
