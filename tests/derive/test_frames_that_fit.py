"""Every term of every equation and line stands in frames that fit, and a letter in another frame is named."""

import random
import re
import shutil

import pytest
from conftest import ROOT
from sympy import Add, MatAdd, MatMul, Mul, Pow, Symbol
from sympy.matrices import ImmutableMatrix, MatrixBase

from boresight.derive.dimensions import Mismatch
from boresight.derive.ledger import dimensions, frames
from boresight.derive.ledger.entries import findings, unheld
from boresight.derive.ledger.equation import Relation, as_written
from boresight.derive.ledger.judge import judge
from boresight.derive.ledger.lines import judge_line
from boresight.derive.ledger.reader import read
from boresight.derive.papers import DERIVATIONS, PAPERS, paper
from boresight.derive.papers.own import own

pytestmark = pytest.mark.usefixtures("many_digits")

EXAMPLES = sorted(path for path in (ROOT / "examples" / "papers").iterdir() if path.is_dir())
SEED, DRAWN, NAMED = 34, 100, 90


@pytest.mark.parametrize("name", [*PAPERS, *DERIVATIONS])
def test_every_equation_and_every_line_of_a_derivation_fits(name):
    found = frames.found(paper(name))
    assert found.held > 200 and not found.misfits


@pytest.mark.parametrize("folder", EXAMPLES, ids=lambda folder: folder.name)
def test_of_the_papers_of_ones_own_a_planted_slip_alone_does_not_fit(folder):
    found = [number for number, _, _ in frames.found(own(folder)).misfits]
    assert found == ["6b"] * (folder.name == "quaternion-error-state")  # a noise in b beside vectors in n


def test_what_is_declared_of_lines_is_at_most_one_in_twenty():
    steps = sum(len(e.derivation.steps) for name in (*PAPERS, *DERIVATIONS) for e in paper(name).equations)
    assert 20 * sum(len(paper(name).frames) for name in (*PAPERS, *DERIVATIONS)) <= steps


def known(one):
    """The frames of a paper's letters, from all its lines."""
    found = frames.Frames(one)
    for equation in one.equations:
        for at, claim, relation in equation.stated:
            named(found, equation, at, claim, relation)
    return found


def named(found, equation, at, claim, relation):
    """Why the relation's frames do not fit in place of this line."""
    try:
        frames.line(found, equation, at, claim).relation(relation)
    except Mismatch as error:
        return str(error)
    except ValueError:
        pass
    return ""


def test_a_rate_on_the_side_of_the_other_frame_is_named():
    """Of Kim (2), line 7."""
    one = paper("kim-2018")
    equation = one.equation("2")
    wrong = r"\dot{C}_n^c = [\omega_{en}^n \times] C_n^c - C_n^c [\hat{\omega}_{en}^c \times]"
    (relation,) = read((wrong,), equation.alphabet)
    assert named(known(one), equation, "7", equation.derivation.steps[6].claim, relation) == "n and c"
    assert not judge_line(one, equation, 6, relation).holds


# ---------------------------------------------------------------- slips: one letter of a frame, drawn from all

INDEX = re.compile(r"[_^](?:\{([^{}]*)\}|(.))")


def spelled(letter, names):
    """How it is written without the frames in its indices, and these."""
    found = []

    def taken(index):
        parts = re.findall(r"[A-Za-z]'?|.", index[1] if index[1] is not None else index[2])
        found.extend(part for part in parts if part in names)
        return index[0][0] + "".join("#" if part in names else part for part in parts)

    return INDEX.sub(taken, letter.latex), found


def places(e, path=()):
    if isinstance(e, Symbol):
        yield path, e.name
    for i, part in enumerate(e if isinstance(e, MatrixBase) else e.args):
        yield from places(part, (*path, i))


def put(e, path, new):
    if not path:
        return new
    parts = list(e if isinstance(e, MatrixBase) else e.args)
    parts[path[0]] = put(parts[path[0]], path[1:], new)
    if isinstance(e, MatrixBase):
        return ImmutableMatrix(e.rows, e.cols, parts)
    if isinstance(e, Add | Mul | MatAdd | MatMul):
        return as_written(type(e), parts)
    return e.func(*parts, evaluate=False) if isinstance(e, Pow) else e.func(*parts)


def slips(one, names):
    """(equation, index of the step, relation) of each line with one frame's letter another, units and shapes kept."""
    for equation in one.equations:
        letters = {q.symbol.name: q for q in equation.alphabet}
        grids = {name: dimensions.of_letter(one.units, q).rows for name, q in letters.items()}
        spellings = {name: spelled(q, names) for name, q in letters.items()}
        for index, step in enumerate(equation.derivation.steps):
            for relation in step.formulas:
                for side, path, name in ((i, *place) for i, e in enumerate(relation.sides) for place in places(e)):
                    if name not in letters or not letters[name].shape:
                        continue
                    text, of = spellings[name]
                    for other, (its_text, its) in spellings.items():
                        alike = its_text == text and letters[other].shape == letters[name].shape
                        if alike and grids[other] == grids[name] and sum(map(str.__ne__, of, its)) == 1:
                            sides = list(relation.sides)
                            sides[side] = put(sides[side], path, letters[other].symbol)
                            yield equation, index, Relation(tuple(sides))


def test_the_numbers_too_see_c_for_n_in_the_lines_of_kim_2_that_are_exact():
    one, seen = paper("kim-2018"), 0
    for equation, index, relation in slips(one, {"c", "n"}):
        step = equation.derivation.steps[index]
        if equation.number == "2" and step.claim.kind == "exact":
            assert not judge_line(one, equation, index, relation).holds, (index + 1, relation)
            seen += 1
    assert seen > 10


def test_of_a_hundred_slips_of_a_frame_that_are_errors_most_are_named():
    """Drawn by a seed from all; the judge of numbers says which are errors to the line's order."""
    drawn = []
    for name in (*PAPERS, *DERIVATIONS):
        one = paper(name)
        found = known(one)
        drawn += [(one, found, *slip) for slip in slips(one, found.names | {"i"})]
    assert len(drawn) > 1500
    random.Random(SEED).shuffle(drawn)
    wrong = missed = 0
    for one, found, equation, index, relation in drawn:
        if not judge_line(one, equation, index, relation).holds:
            wrong += 1
            missed += not named(found, equation, str(index + 1), equation.derivation.steps[index].claim, relation)
        if wrong == DRAWN:
            break
    print(f"{wrong - missed} of {wrong} are named")
    assert wrong - missed >= NAMED


def test_a_paper_of_ones_own_is_told_of_its_frames(tmp_path):
    folder = tmp_path / "ecef"
    shutil.copytree(ROOT / "examples" / "papers" / "gnss-ins-ecef", folder)
    printed = folder / "printed.tex"
    right = r"[(C_b^e l^b) \times] \psi^e"
    assert right in printed.read_text()
    printed.write_text(printed.read_text().replace(right, r"[l^b \times] \psi^e"))
    (finding,) = (text for text in findings(own(folder)) if "frames" in text)
    assert re.fullmatch(r"The frames of \(2\.\d+\) do not fit: [be] and [be]\.", finding)
    assert not any("frames of" in text for text in unheld(own(folder)))


# ---- papers of one's own: a letter's frame by its value, in every type

MOTION = {  # LaTeX: value
    r"\mathbf{C}_b^n": "C_b2n", "C^b_n": "T(C_b2n)", "C_n^{n'}": "C_hat*T(C_b2n)", "C_b^{n'}": "C_hat",
    "R_b^l": "C_b2n", "R_s^b": "rotation(stack(0.3, 0.2, -0.1))", "R_s^n": "C_b2n*rotation(stack(0.3, 0.2, -0.1))",
    r"\omega_{nb}^b": "omega_b", r"\omega_{ns}^s": "T(rotation(stack(0.3, 0.2, -0.1)))*omega_b",
    r"\Omega": "skew(omega_b)", r"\mathbf{f}": "f_b", "f_z": "f_b[2]", "v_z": "v_n[2]", "e_3": "stack(0, 0, 1)",
    r"\mathbf{v}": "v_n", "v^l": "v_n", r"\mathbf{1}": "eye(3)", r"\rho": "rotation_vector(C_b2n)",
    r"\vec{q}": "q_b2n[1:4]", "q_0": "q_b2n[0]", "g^l": "gravity_n", "q": "q_b2n", r"\bar{m}": "stack(0, field_n)",
    r"\bar{y}": "stack(0, field_b)", "m": "field_n", "y": "field_b", "a": "a_n", r"\tilde{\mathbf{f}}": "accel",
    "n": "accel_noise", "b": "accel_bias", r"\theta": "theta_local", r"\delta f^n": "C_hat*f_b - C_b2n*f_b",
    "f^{n'}": "C_hat*f_b", "f^n": "C_b2n*f_b", r"\hat{y}": "T(C_hat)*field_n", "z": "field_b - T(C_hat)*field_n",
}  # fmt: skip
TRUE = [
    r"\dot{\mathbf{C}}_b^n = \mathbf{C}_b^n \Omega",
    r"C^b_n \mathbf{C}_b^n = \mathbf{1}",
    r"C_b^{n'} = C_n^{n'} \mathbf{C}_b^n",
    r"\delta f^n = f^{n'} - f^n",  # components in n' less those in n: that is the error of the components
    r"\omega_{nb}^b = R_s^b \omega_{ns}^s",  # s is fixed in b
    r"R_s^n = \mathbf{C}_b^n R_s^b",
    r"f_z = e_3^T \mathbf{f}",
    r"v_z = e_3^T \mathbf{v}",  # an axis is three numbers, in any frame
    r"a = \mathbf{C}_b^n \mathbf{1} \mathbf{f} + \mathbf{1} g^l",
    r"\mathbf{C}_b^n \rho = \rho",  # the axis of a turn is one in both frames
    r"\mathbf{C}_b^n = (q_0^2 - \vec{q}^T \vec{q}) \mathbf{1} + 2 \vec{q} \vec{q}^T + 2 q_0 [\vec{q} \times]",
    r"\dot{v}^l = R_b^l \mathbf{f} + g^l",
    r"\bar{y} = q^* \otimes \bar{m} \otimes q",
    r"\tilde{\mathbf{f}} = \mathbf{f} + b + n",  # the letters are called b and n
    r"z = [\hat{y} \times] \theta",
]
WRONG = [
    r"\dot{\mathbf{C}}_b^n = \Omega \mathbf{C}_b^n",
    r"C^b_n \mathbf{f} = \mathbf{v}",
    r"C_b^{n'} = \mathbf{C}_b^n C_n^{n'}",
    r"R_s^n = R_s^b \mathbf{C}_b^n",
    r"f_z = \mathbf{v}^T \mathbf{f}",
    r"a = \mathbf{1} \mathbf{f} + g^l",
    r"\dot{v}^l = \mathbf{f} + g^l",
    r"\bar{y} = q \otimes \bar{m} \otimes q^*",
    r"a = \mathbf{C}_b^n (\tilde{\mathbf{f}} - b) - n + g^l",
    r"z = [m \times] \theta",
]


def of_ones_own(folder, lines):
    """A paper of these lines and of the letters of MOTION; two are called n and b, as frames are."""
    names = (latex if latex in "nb" else f"letter {i}" for i, latex in enumerate(MOTION))
    rows = (
        f"\"{name}\" = {{ latex = '''{latex}''', value = \"{value}\" }}"
        for name, (latex, value) in zip(names, MOTION.items(), strict=True)
    )
    text = "\n".join(('title = "-"', 'witness = "motion"', "[letters]", *rows))
    (folder / "paper.toml").write_text(text, encoding="utf-8")
    shown = (rf"\begin{{equation}} {line} \tag{{{i}}} \end{{equation}}" for i, line in enumerate(lines))
    (folder / "printed.tex").write_text("\n".join(shown), encoding="utf-8")
    return own(folder)


def test_what_is_true_fits_in_every_type_and_convention(tmp_path):
    one = of_ones_own(tmp_path, TRUE)
    statuses = {judge(one, equation, equation.printed).status for equation in one.equations}
    assert statuses == {"exact", "first-order"} and not frames.found(one).misfits


def test_of_slips_each_is_named_and_no_line_beside_it(tmp_path):
    one = of_ones_own(tmp_path, [*TRUE, *WRONG])
    found = [number for number, _, _ in frames.found(one).misfits]
    assert found == [str(len(TRUE) + i) for i in range(len(WRONG))]
