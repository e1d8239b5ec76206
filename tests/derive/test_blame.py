"""Which of two equations is wrong, a term that is lost or left out on purpose, and by how much a row is off."""

import json
import re

import pytest

from boresight import BoresightError
from boresight.derive.ledger.entries import entry_of
from boresight.derive.ledger.evaluate import DIGITS
from boresight.derive.ledger.mends import mends
from boresight.derive.ledger.numbers import digits
from boresight.derive.papers import of_folder
from boresight.derive.papers.own import own

KALMAN = {
    "x": ("\\hat{x}", "x"), "xp": ("\\hat{x}^+", "x_plus"), "P": ("P", "P"), "Pp": ("P^+", "P_plus"), "H": ("H", "H"),
    "z": ("z", "z"), "K": ("K", "K"), "I": ("I", "I"),
}  # fmt: skip
ENU = {
    "C": ("C", "C_b2n"), "f": ("f^b", "f_b"), "g": ("g", "gravity_n"), "v": ("v", "v_n"),
    "ω_ie": ("\\omega_{ie}", "omega_ie_n"), "ω_en": ("\\omega_{en}", "omega_en_n"),
    "V_N": ("V_N", "v_n[1]"), "δV_N": ("\\delta V_N", "v_n_hat[1] - v_n[1]"), "L": ("L", "lat"),
    "δL": ("\\delta L", "lat_hat - lat"), "R": ("R", "R_M"), "δR": ("\\delta R", "R_M_hat - R_M"),
    "h": ("h", "height"), "δh": ("\\delta h", "height_hat - height"),
}  # fmt: skip
RATE = r"\delta \dot{L} = \frac{1}{R + h} \delta V_N - \frac{V_N}{(R + h)^2} \delta h"


def paper(folder, witness, letters, equations, more=""):
    rows = [f"{json.dumps(name, ensure_ascii=False)} = {{ latex = '{a}', value = '{b}' }}"
            for name, (a, b) in letters.items()]  # fmt: skip
    (folder / "paper.toml").write_text(
        "\n".join([f'title = "A"\nwitness = "{witness}"\n[letters]', *rows, more]) + "\n"
    )
    (folder / "printed.tex").write_text(
        "\n".join(rf"\begin{{equation}} {latex} \tag{{{n}}} \end{{equation}}" for n, latex in equations.items())
    )
    return own(folder)


def found(one):
    return {e.number: (entry_of(one, e).status, entry_of(one, e).found) for e in one.equations}


NU = '"ν" = { latex = "\\\\nu", shape = 2 }\n'


def test_a_slip_in_a_definition_is_blamed_on_it_and_not_on_what_uses_it(tmp_path):
    """The innovation with the other sign: the update that is printed right fails with it."""
    equations = {"1": r"\nu = z + H \hat{x}", "2": r"\hat{x}^+ = \hat{x} + K \nu"}
    one = found(paper(tmp_path, "kalman", KALMAN, equations, NU))
    assert one["1"] == ("erratum", "With it (2) fails. True with one edit: sign of H x.")
    assert one["2"] == ("exact", "With (1) as it is mended both sides agree to 28 digits.")


def test_a_slip_in_what_uses_a_definition_is_its_own(tmp_path):
    equations = {"1": r"\nu = z - H \hat{x}", "2": r"\hat{x}^+ = \hat{x} - K \nu"}
    one = found(paper(tmp_path, "kalman", KALMAN, equations, NU))
    assert one["1"] == ("definition", "With it (2) fails: (1) or (2) is wrong.")
    assert one["2"][0] == "erratum" and one["2"][1].endswith("True with one edit: sign of -K ν.")


def test_a_slip_is_found_behind_a_definition_that_passes_it_on(tmp_path):
    equations = {"1": r"\nu = z + H \hat{x}", "2": r"\mu = \nu", "3": r"\hat{x}^+ = \hat{x} + K \mu"}
    one = found(paper(tmp_path, "kalman", KALMAN, equations, NU + '"μ" = { latex = "\\\\mu", shape = 2 }'))
    assert [status for status, _ in one.values()] == ["erratum", "definition", "exact"]
    assert one["1"][1] == "With it (3) fails. True with one edit: sign of H x."
    assert one["2"][1] == "It holds in every equation that uses μ."


def test_where_either_of_two_definitions_could_be_wrong_none_is_called_so(tmp_path):
    """A sign in u or in w would do; which of them has it, nothing tells."""
    letters = {"v": ("v", "v_n"), **{f"v_{i}": (f"v_{i}", f"v_n[{i - 1}]") for i in (1, 2, 3)}}
    equations = {
        "1": r"u = \begin{bmatrix} 2 v_1 \\ 3 v_2 \\ - 5 v_3 \end{bmatrix}",
        "2": r"w = \begin{bmatrix} v_1 / 2 \\ v_2 / 3 \\ v_3 / 5 \end{bmatrix}",
        "3": "v^T v = u^T w",
    }
    more = '"u" = { latex = "u", shape = 3 }\n"w" = { latex = "w", shape = 3 }'
    one = found(paper(tmp_path, "strapdown-enu", letters, equations, more))
    assert [status for status, _ in one.values()] == ["definition", "definition", "erratum"]
    assert one["1"][1].startswith("With it (3) fails: (1) or (2) or (3) is wrong; with one edit of this one")
    assert one["3"][1].endswith("No single edit makes it true. One edit of (1) or of (2) would.")


def test_a_term_that_was_lost_is_among_the_mends(tmp_path):
    """Newton's law without the part of the Coriolis acceleration that the Earth's rate adds once more."""
    newton = r"\dot{v} = C f^b - (\omega_{ie} + \omega_{ie} + \omega_{en}) \times v"
    one = paper(tmp_path, "strapdown-enu", ENU, {"1": newton})
    with_g = [mend.what for mend in mends(one, one.equation("1"))]
    assert with_g[0] == "with term + g"


def test_what_is_left_out_on_purpose_is_named_judged_and_sized(tmp_path):
    """The change of the meridian radius is V_N δR / (R + h)^2, some 1e-6 of the row; the height's is not neglected."""
    bare = found(paper(tmp_path, "strapdown-enu", ENU, {"1": RATE}))["1"]
    assert bare[0] == "erratum" and "It is off by 2.4e-6 of what the errors make of it." in bare[1]
    assert 'neglects = "..."' in bare[1]
    term = "[equations.\"1\"]\nneglects = '- \\frac{V_N \\delta R}{(R + h)^2}'"
    named = found(paper(tmp_path, "strapdown-enu", ENU, {"1": RATE}, term))["1"]
    assert named[0] == "first-order" and "It neglects -V_N⋅δR/(R + h)^2, at most 2.66e-9 deg/h." in named[1]
    wrong = found(paper(tmp_path, "strapdown-enu", ENU, {"1": RATE}, term.replace("- ", "")))["1"]
    assert wrong[0] == "erratum"
    slip = found(paper(tmp_path, "strapdown-enu", ENU, {"1": RATE.replace("V_N - ", "V_N + ")}, term))["1"]
    assert slip[0] == "erratum"


@pytest.mark.parametrize(
    "latex, term, why",
    [(RATE, "\\epsilon", "cannot read"), (rf"{RATE}, \quad L = L", "\\delta R", "several relations"),
     (RATE, "\\delta R = 0", "cannot read")],
)  # fmt: skip
def test_what_is_left_out_is_refused_with_its_line(tmp_path, latex, term, why):
    more = f"[equations.\"1\"]\nneglects = '{term}'"
    with pytest.raises(BoresightError, match=rf"paper.toml:\d+:\d+: \(1\): .*{why}"):
        assert paper(tmp_path, "strapdown-enu", ENU, {"1": latex}, more).equations


# ---- What is no proof, and what is no mend ---------------------------------------------------------------------------

PRESSURE = """
from dataclasses import dataclass

from boresight.derive.ledger.numbers import Matrix, exp
from boresight.derive.ledger.paper import Stated, Witness
from boresight.derive.ledger.witness import draw


@dataclass(frozen=True, eq=False)
class Base:
    place: tuple
    error: tuple


@dataclass(frozen=True)
class Sizes:
    place: float = 1.0
    error: float = 1e-3


def values(base, definitions):
    a, e = Matrix(base.place), Matrix(base.error)
    p0, h, H = 101325 + 2000 * a[0], 3000 + 2000 * a[1], 8000 + 500 * a[2]
    return {"p": p0 * exp(-h / H), "p0": p0, "h": h, "H": H, "δH": H * e[0]}


WITNESS = Witness(Base, values, Sizes(), ("error",), "heights", {"error": "the error of the scale"})
SIZES = Stated(Sizes(), "small errors", 4)
POINT = Stated(draw(Base, 1, Sizes()), "a point")
"""


@pytest.mark.parametrize(
    ("latex", "edits"),
    [(r"p = p_0 \exp(h)", []), (r"p = p_0 \exp(h H)", []), (r"p = p_0 \exp(h^3 H^5)", []),
     (r"p = p_0 \exp(h / \delta H)", []), (r"p = p_0 \exp(h / H)", ["sign of h/H in exp"])],
)  # fmt: skip
def test_what_no_float_holds_is_no_proof_and_no_mend(tmp_path, latex, edits):
    """exp(3000) and exp(3000 * 8000) are finite, and larger than any float; the ball of exp(1e30) knows nothing."""
    (tmp_path / "witness.py").write_text(PRESSURE)
    letters = {"p": "p", "p0": "p_0", "h": "h", "H": "H", "δH": r"\delta H"}
    rows = [f"'{name}' = {{ latex = '{latex}', unit = '{'Pa' if 'p' in name else 'm'}' }}"
            for name, latex in letters.items()]  # fmt: skip
    (tmp_path / "paper.toml").write_text("\n".join(['title = "A"\nwitness = "witness.py"\n[letters]', *rows]))
    (tmp_path / "printed.tex").write_text(rf"\begin{{equation}} {latex} \tag{{1}} \end{{equation}}")
    one = of_folder(tmp_path)
    with digits(DIGITS):
        assert entry_of(one, one.equation("1")).status == "erratum"
        assert [mend.what for mend in mends(one, one.equation("1"))] == edits


MOTION = {
    "C": ("C", "C_b2n"), "Ĉ": (r"\hat{C}", "C_hat"), "θ": (r"\theta", "theta_local"), "φ": (r"\phi", "theta_global"),
    "δq": (r"\delta q", "quaternion(T(C_hat)*C_b2n)"), "l": (r"\ell", "lever_b"), "ω": (r"\omega", "omega_b"),
}  # fmt: skip


def test_the_sign_of_an_argument_is_an_edit(tmp_path):
    one = found(paper(tmp_path, "motion", MOTION, {"1": r"C = \hat{C} \exp(-[\theta \times])"}))
    assert one["1"][0] == "erratum" and one["1"][1].endswith("True with one edit: sign of [θ x] in exp.")


VAIN = {  # a term of second order, and how much of what is left without it is left with it
    r"C = \hat{C} (I_3 + [\theta \times] + [\theta \times]^2)": ("[θ ×]^2", 1),
    r"C = \hat{C} (I_3 + [\theta \times] - \frac{1}{2} [\theta \times]^2)": ("-1/2⋅[θ ×]^2", 2),
    r"C = \hat{C} (I_3 + [\theta \times] + \frac{1}{4} [\theta \times]^2)": ("1/4⋅[θ ×]^2", 0.5),
    r"\delta q = \begin{bmatrix} 1 - \frac{1}{4} \theta^T \theta \\ \frac{1}{2} \theta \end{bmatrix}": (
        "-1/4⋅θ^T⋅θ", 1),
    r"C - \hat{C} = \hat{C} [\theta \times] + \hat{C} [\theta \times] [\omega \times] [\theta \times]": (
        "Ĉ⋅[θ ×]⋅[ω ×]⋅[θ ×]", None),
    r"C = \hat{C} (I_3 + [\theta \times] + \frac{1}{2} [\theta \times]^2)": None,
    r"C = \hat{C} (I_3 + [\theta \times] + \frac{1}{2} (\theta \theta^T - \theta^T \theta I_3))": None,
    r"\delta q = \begin{bmatrix} 1 - \frac{1}{8} \theta^T \theta \\ \frac{1}{2} \theta \end{bmatrix}": None,
    r"C = \hat{C} (I_3 + [\theta \times])": None,
}  # fmt: skip


@pytest.mark.parametrize("latex", VAIN)
def test_a_printed_term_of_second_order_that_is_no_use_is_named_with_what_is_left(tmp_path, latex):
    """The term is half [θ x]^2, or of the quaternion an eighth of θ^T θ."""
    status, text = found(paper(tmp_path, "motion", MOTION, {"1": latex}))["1"]
    assert status == "first-order" and ("second order" in text) == bool(VAIN[latex]), text
    if VAIN[latex]:
        term, share = VAIN[latex]
        assert f" The term {term} of second order does not bring it clearly nearer to the truth: " in text
        left = re.search(r"is at most (\S+) \(no unit\) with it, and at most (\S+) \(no unit\) without it.$", text)
        assert share is None or float(left[1]) / float(left[2]) == pytest.approx(share, rel=0.01)


LEVER = r"C \ell - \hat{C} \ell = "


@pytest.mark.parametrize(
    ("latex", "status", "says"),
    [(r"\frac{d}{dt}(C \ell) = C (\omega \times \ell - \dot{\ell})", "exact", True),
     (r"\frac{d}{dt}(C \ell) = C (\omega \times \ell + \dot{\ell})", "exact", False),
     (r"\frac{d}{dt}(C \ell) = C (\omega \times \ell)", "exact", False),
     (rf"{LEVER} -\hat{{C}} [\ell \times] \theta + 3 C \dot{{\ell}}", "first-order", True),
     (r"\dot{\ell} = 0_{3 \times 1}", "exact", False),
     (rf"{LEVER} -\frac{{1}}{{3}} \hat{{C}} [\ell \times] \theta", "erratum", False),
     (r"C \ell = C [\theta \times] \ell", "erratum", False)],
)  # fmt: skip
def test_a_letter_that_is_zero_everywhere_is_no_mend_and_what_it_hides_is_said(tmp_path, latex, status, says):
    """The lever of the witness is constant: of its rate any sign and factor would do, and it would mend all."""
    one = paper(tmp_path, "motion", MOTION, {"1": latex})
    kind, text = found(one)["1"]
    remark = " The witness has l̇ zero everywhere: what stands before it is not held."
    assert kind == status and text.endswith(remark) == says == ("zero everywhere" in text), text
    assert status != "erratum" or not any("l̇" in mend.what for mend in mends(one, one.equation("1")))
