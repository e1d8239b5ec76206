"""Pages of papers on the terminal, in LaTeX, HTML and PDF."""

import re
import shutil
from html import unescape
from html.parser import HTMLParser
from unicodedata import combining

import pytest
from conftest import ROOT
from sympy import Symbol
from tools import needs

from boresight import BoresightError, cli
from boresight.derive.ledger.differences import differences, marks
from boresight.derive.ledger.equation import Quantity, Relation
from boresight.derive.ledger.latex import latex_relation
from boresight.derive.ledger.lines import count_steps
from boresight.derive.pages import notebook
from boresight.derive.pages.booklet import pdf_from_latex, pieces, tex
from boresight.derive.pages.mathml import mathml_relation
from boresight.derive.pages.page import notation
from boresight.derive.pages.render import render
from boresight.derive.papers import DERIVATIONS, PAPERS, paper

PAPER = paper("song-lee-2001")
needs_pdflatex = needs("pdflatex")


@pytest.mark.parametrize("columns", [80, 140])
def test_terminal_shows_print_derivation_steps_and_evidence_in_100_columns_at_most(columns, monkeypatch):
    monkeypatch.setenv("COLUMNS", str(columns))
    text = render(PAPER, "9")
    assert text.startswith("song-lee-2001 (9)  erratum: letter, transcription  [source line 74]")
    for piece in (
        "printed",
        "cos(›φ‹)",
        "derived",
        "cos(›ψ‹)",
        "2. multiply",
        "As printed: ",
        "Note: Origin transcription",
    ):
        assert piece in text
    assert max(map(len, text.splitlines())) <= min(columns, 100)


@pytest.mark.parametrize("name", PAPERS)
def test_a_page_holds_every_equation_once_and_ends_by_column_100(name, monkeypatch):
    monkeypatch.setenv("COLUMNS", "100")
    one = paper(name)
    text = render(one)
    assert " ".join(text.split()).startswith(f"{one.reference} ===")
    assert f"; {count_steps(one.equations)}." in " ".join(text.split())
    shown = re.findall(rf"^{name} (\(\d+\)|\w+)  ", text, re.MULTILINE)
    assert shown == [equation.label for equation in one.equations]
    assert max(sum(not combining(c) for c in line) for line in text.splitlines()) <= 100


def test_the_counts_and_what_stands_beside_the_equations_are_shown():
    text = " ".join(render(PAPER).split())
    assert "28 equations and 2 without a number: 4 exact, 8 first-order, 8 definition, 10 erratum; steps: " in text
    assert "Table 1: 13, 12, 21, 3 cells" in text


def test_conditions_stand_where_their_numbers_do_and_letters_beside_a_single_equation():
    one = paper("kang-2025")
    for number, condition in (("2", one.conditions), ("5", one.point)):
        text = " ".join(render(one, number).split())
        assert text.count(condition.text) == 1 and text.index(condition.text) < text.index("Held by")
        assert (
            "Notation" in text
            and one.conventions[0] in text
            and re.search(r"δt_d +by how much the master's data is old +s", text)
        )


def test_the_steps_that_decide_are_those_in_which_the_right_form_first_stands():
    """By hand from the derivations: of (8) the axes after the yaw, of (9) two letters and a term, one by one."""
    decided = {
        number: re.findall(r"^(\d+)\. Decides", render(PAPER, number), re.MULTILINE) for number in ("5", "8", "25")
    }
    assert decided == {"5": [], "8": ["11"], "25": ["4"]}
    assert re.findall(r"^(\d+)\. Decides", render(paper("kim-2018"), "9"), re.MULTILINE) == ["2", "12", "15"]


def test_a_derived_form_that_is_the_print_is_not_repeated():
    text, *_ = render(paper("kim-2018"), "13").partition("\n1. ")
    assert "printed and derived" in text and text.count("Φ_{k-1}") == 1


@pytest.mark.parametrize("form", ["text", "latex", "html"])
@pytest.mark.parametrize("number", ["2", "3", "10", "11"])
def test_printed_is_the_print_with_no_bracket_of_ours(number, form):
    """Kim's print has a vector of rates beside a vector where its cross product is meant."""
    page = render(paper("kim-2018"), number, form)
    printed, derived = (
        ("Printed", "(?:Derived|As read)") if form == "latex" else ("printed", "(?:as read, and )?derived")
    )
    start, end, cross = {
        "text": (f"\n{printed}\n", f"\n{derived}\n", r"×\]"),
        "latex": (printed, derived, r"\\times\]"),
        "html": (f">{printed}<", f">{derived}<", r"×</mo><mo[^>]*>\]"),
    }[form]
    print_, ours = re.split(end, page.partition(start)[2], maxsplit=1)
    assert print_.strip() and not re.search(cross, print_) and re.search(cross, ours)


def test_each_size_and_each_letter_with_units_has_its_unit():
    kim = paper("kim-2018")
    text = " ".join(render(kim, "2").split())
    assert "at most 0.00934 m/s^2 is dropped" in text and " SI " not in text
    assert "at most 1.81e-11 (no unit), 4.73e-25 rad/m" in render(kim, "12").replace("\n  ", " ")
    assert "1.9021  3.8042   1.9021   m" in render(paper("kang-2025"), "6")
    units = {forms[0].relation.sides[0].name: unit for forms, _, unit in notation(kim).rows}
    assert (units["F_k"], units["x_v"], units["δv"]) == ("by entry", "m/s", "m/s")


def test_an_equation_without_errors_has_none_that_is_small():
    text = " ".join(render(paper("kang-2025"), "6").split())
    assert "Small" not in text and "halving" not in text.lower()
    assert "The sides differ, and no error is in them." in text


def test_what_was_judged_is_shown_where_the_print_is_read_otherwise():
    text = render(paper("kim-2018"), "2")
    assert "printed and derived" not in text and "›φ̇‹ =" in text and "›ψ̇‹ =" in text


class Page(HTMLParser):
    """Elements that do not close, where links go, and what is marked."""

    def __init__(self, text):
        super().__init__()
        self.open, self.ids, self.links, self.wrong, self.slips = [], [], [], [], []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        self.ids += [attrs["id"]] if "id" in attrs else []
        self.links += [attrs["href"]] if "href" in attrs else []
        assert "src" not in attrs
        if tag not in ("meta", "wbr"):
            self.open.append(tag)
        if attrs.get("class") == "slip":
            self.slips.append(len(self.open))

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.wrong.append(tag)


@pytest.mark.parametrize("name", PAPERS)
def test_html_stands_alone_and_its_links_go_somewhere(name):
    page = Page(render(paper(name), None, "html"))
    assert not page.open and not page.wrong
    assert [anchor for anchor in page.ids if anchor.startswith("eq-")] == [
        f"eq-{e.number}" for e in paper(name).equations if e.numbered
    ]
    assert len(page.ids) == len(set(page.ids))
    assert page.links and all(link[0] == "#" and link[1:] in page.ids for link in page.links)


def test_an_equation_that_another_cites_is_a_link_in_html_and_latex():
    assert '<a href="#eq-9">(9)</a>' in render(PAPER, None, "html")
    assert r"\hyperref[eq-9]{(9)}" in render(PAPER, None, "latex")


@pytest.mark.parametrize("name", PAPERS)
def test_every_erratum_is_marked_where_print_and_derivation_differ_in_every_format(name):
    one = paper(name)
    for equation in one.equations:
        found = differences(equation.read(), equation.derived)
        places = [
            marks(form, found, which) for form, which in ((equation.printed, "printed"), (equation.derived, "derived"))
        ]
        if "erratum" not in render(one, equation.number).splitlines()[0]:
            continue
        count = sum(len(marked) for form in places for marked in form)
        assert count > 0
        text, html, latex = (render(one, equation.number, format) for format in ("text", "html", "latex"))
        assert text.count("›") == text.count("‹") == count
        assert len(Page(html).slips) == latex.count(r"\slip{") == count


@pytest.mark.parametrize(
    "number, printed, derived", [("9", "φ", "ψ"), ("25", "δμ(k)", "- δμ(k)"), ("7", "C_b2n", "C_n2b")]
)
def test_the_slip_is_what_is_marked(number, printed, derived):
    before, after = render(PAPER, number).split("derived\n")[:2]
    for part, letter in ((before, printed), (after.split("As printed")[0], derived)):
        assert set(re.findall("›(.*?)‹", part)) == {letter}


@pytest.mark.parametrize("format", ["text", "latex", "html"])
def test_the_numbers_of_an_erratum_are_the_stated_errors_the_print_and_the_derivation(format):
    """(9) gives the slave's angle errors, which are stated: 0.1, -0.2 and 0.3 deg."""
    page = re.sub(r"<[^>]*>|[&$\\]|[a-z]*\{.*?\}", " ", render(PAPER, "9", format).replace("</td>", " "))
    rows = re.findall(r"(-?\d+\.\d+) +(-?\d+\.\d+) +(-?\d+\.\d+) +arcmin", page)
    assert [float(true) / 60 for true, *_ in rows] == pytest.approx([0.1, -0.2, 0.3], rel=1e-4)
    for true, printed, derived in rows:
        assert abs(float(derived) - float(true)) < 0.01 * abs(float(true)) < abs(float(printed) - float(true))


def test_formulas_of_a_page_are_those_of_the_writers():
    """So that what the writers' tests read back is what is shown."""
    one, equation = paper("kim-2018"), paper("kim-2018").equation("11")
    html, latex = render(one, "11", "html"), render(one, "11", "latex")
    html = re.sub("</math><wbr><math[^>]*>", "", re.sub(' form="infix"| rspace=".15em"', "", html))
    shown = re.sub(r"\\piece\{(?:\{\})?|\}%\n", " ", latex)
    for step in equation.derivation.steps:
        for relation in step.formulas:
            letters = equation.alphabet
            row = re.sub("^<math[^>]*>(?:<mrow>)?|(?:</mrow>)?</math>$", "", mathml_relation(relation, letters))
            assert unescape(row) in html
            assert re.sub(r"\s", "", latex_relation(relation, letters)) in re.sub(r"\s", "", shown)


def test_c_functions_and_the_command_that_judges_are_named(capsys):
    text = render(PAPER, "19", functions={"song-lee-2001 (19)": {"euler-matching": ("em_euler_H", "em_euler_z")}})
    assert "In C of euler-matching: em_euler_H, em_euler_z" in text
    (held,) = re.findall(r"Held by: (.+)", text)
    assert held == "boresight equations song-lee-2001 19"
    with pytest.raises(SystemExit) as ended:
        cli.main(held.split()[1:])
    assert not ended.value.code and "first-order" in capsys.readouterr().out


@pytest.mark.parametrize("name", PAPERS)
def test_the_tests_of_single_equations_name_equations_that_there_are(name):
    file = ROOT / "tests" / "derive" / f"test_{name.replace('-', '_')}.py"
    marked = re.findall(r'^@pytest\.mark\.equations\("(.+)"\)$', file.read_text(), re.MULTILINE)
    assert len(marked) >= 8
    for numbers in marked:
        assert all(paper(name).equation(number) for number in numbers.split())


@pytest.mark.parametrize("name", PAPERS)
def test_the_table_of_notation_has_every_letter_and_splits_off_its_unit(name):
    table = notation(paper(name))
    shown = [form.relation.sides[0].name for letters, _, _ in table.rows for form in letters]
    assert len(shown) == len(set(shown))
    letters = (*paper(name).quantities(), *paper(name).letters())
    assert set(shown) == {q.symbol.name for q in letters if not q.function and q.kind != "block"}
    assert not [meaning for _, meaning, _ in table.rows if re.search(r", (rad|m|s|1)(/s)?$", meaning)]


def test_latex_carries_the_print_verbatim_and_no_letter_outside_ascii():
    document = render(PAPER, None, "latex")
    assert document.isascii()
    assert r"\piece{\hat{C}_b^n(\hat{\phi}, \hat{\theta}, \hat{\psi})}%" in document
    assert document.count(r"\subsection{(") == 28 and r"\tableofcontents" in document


@pytest.mark.parametrize(
    "latex, cut",
    [
        ("z = a + (b - c) - d", ["z", "{}= a", "{}+ (b - c)", "{}- d"]),
        (r"x_k^- = -\frac{a - b}{c} b^{-1}", ["x_k^-", r"{}= -\frac{a - b}{c} b^{-1}"]),
        (r"A = \left\{ n = 1 \right\} - \begin{bmatrix} a - b \end{bmatrix}", None),
    ],
)
def test_a_formula_is_cut_before_the_signs_outside_of_brackets(latex, cut):
    found = pieces(latex)
    assert found == cut if cut else len(found) == 3
    assert "".join(found).replace("{}", "").replace(" ", "") == latex.replace(" ", "")


def test_a_formula_in_html_may_end_a_line_before_its_signs_and_its_matrices():
    shown = re.findall(r'<div class="formula">(.*?)</div>', render(paper("kim-2018"), "11", "html"))
    assert re.findall(r'<wbr><math[^>]*>(?:<mrow class="slip">)?<mo form="infix">(.)</mo>', shown[0]) == list("=−−")
    assert len(re.findall(r"<wbr><math[^>]*><mrow", render(PAPER, "9", "html"))) > 2


@needs_pdflatex
def test_latex_of_every_equation_compiles():
    assert pdf_from_latex(render(PAPER, None, "latex")).startswith(b"%PDF")


@needs_pdflatex
def test_latex_that_does_not_compile_is_one_line():
    with pytest.raises(BoresightError, match=r"pdflatex failed: ! Undefined control sequence"):
        pdf_from_latex("\\documentclass{article}\\begin{document}\\nothing\\end{document}")


@needs_pdflatex
def test_a_package_that_is_missing_is_named():
    with pytest.raises(BoresightError, match=r"pdflatex lacks nowhere.sty: install"):
        pdf_from_latex("\\documentclass{article}\\usepackage{nowhere}\\begin{document}\\end{document}")


def test_without_pdflatex_one_line_says_what_to_install(monkeypatch):
    monkeypatch.setattr(shutil, "which", lambda name: None)
    with pytest.raises(BoresightError, match="pdflatex is not installed: install"):
        pdf_from_latex("")


@pytest.mark.parametrize(
    "arguments, message",
    [
        (("29",), "song-lee-2001 has no equation '29'; it has 1, 2, "),
        (("9", "docx"), "the formats are text, latex, html and pdf"),
    ],
)
def test_a_wrong_number_or_format_lists_the_right_ones(arguments, message):
    with pytest.raises(BoresightError, match=re.escape(message)):
        render(PAPER, *arguments)


@pytest.mark.parametrize("format", ["text", "latex", "html"])
def test_a_derivation_of_no_paper_is_a_page_too(format):
    page = " ".join(render(paper("delay-error"), "2", format).split())
    assert "angular momentum" in page and "derived here" in page and "printed" not in page


def test_a_notebook_shows_an_equation_and_a_derivation():
    equation = PAPER.equation("9")
    cell = Page(notebook.html(equation))
    assert not cell.open and not cell.wrong and len(cell.slips) == 12
    assert notebook.latex(equation).count(r"\psi") == 7
    shown = Page(notebook.html(equation.derivation))
    assert not shown.open and not shown.wrong
    assert notebook.latex(equation.derivation).count("gathered") == 2


@pytest.mark.parametrize("name", [*PAPERS, *DERIVATIONS])
def test_a_page_shows_no_code(name, monkeypatch):
    monkeypatch.setenv("COLUMNS", "100")
    lines = render(paper(name)).splitlines()
    lines = [line for line in lines if "which the print calls eye(3)" not in line]
    assert not [line for line in lines if re.search(r"\w\*\w|\*\*|\b(eye|entry|transpose|Matrix|norm|vee)\(", line)]


def written_letters():
    """Every letter of every paper, by its name and as its page has it, and letters that no paper has."""
    letters = [
        letter for name in (*PAPERS, *DERIVATIONS) for letter in (*paper(name).quantities(), *paper(name).letters())
    ]
    strange = [f"x_{c}" for c in "αβγδεζηθικλμνξοπρςστυφχψωΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩℓ∂∇ϕ"]
    names = [
        *(letter.symbol.name for letter in letters),
        *strange,
        "ä_φ̂",
        "C_β2ξ",
        "[ω̃_α x]",
        "dγ/dΛ",
        "v_s(k+α)^ν",
        "x⁺",
        "P_k⁻",
        "q₀",
    ]
    formulas = [latex_relation(Relation((Symbol(name),)), ()) for name in names]
    typed = Quantity(Symbol("typed"), r"\hat{φ}_{α}^Ω", "", "")
    return [*formulas, *(letter.latex for letter in letters), latex_relation(Relation((typed.symbol,)), (typed,))]


def test_no_letter_of_a_formula_stands_in_latex_as_itself():
    assert [latex for latex in written_letters() if not latex.isascii()] == []


@needs_pdflatex
def test_every_letter_and_a_whole_page_with_greek_scripts_compile():
    formulas = dict.fromkeys(rf"${latex}$\par" for latex in written_letters())
    page = render(paper("kang-2025"), "2", "latex")
    assert r"k+\alpha" in page
    beside = r"→ ⋅ ≤ ∈ ∂ − ×"
    document = page.replace(r"\end{document}", "\n".join([*formulas, tex(beside), r"\end{document}"]))
    assert pdf_from_latex(document).startswith(b"%PDF")


@needs_pdflatex
def test_a_sign_that_latex_lacks_is_named():
    page = render(paper("delay-error"), "5", "latex").replace(r"\end{document}", "ж\n\\end{document}")
    with pytest.raises(BoresightError, match="pdflatex has no sign 'ж': write it in LaTeX, or use --format html"):
        pdf_from_latex(page)
