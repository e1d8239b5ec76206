"""What the site is made of, without Sphinx: links, clicks, prototypes of C, names; `make site` builds it."""

import re
import subprocess
from pathlib import Path
from types import SimpleNamespace

import pytest
from conftest import ROOT

import boresight
from boresight.codegen.folder import folders
from boresight.codegen.generate import COMPONENTS
from boresight.codegen.text.views import pages
from boresight.studies.known import STUDIES, study
from docs.site import build, executed, layout, links, reference, trace


def site_of(tmp_path, **pages):
    """A site of pages in HTML, by name."""
    for name, text in pages.items():
        (tmp_path / f"{name}.html").write_text(text)
    return links.read(tmp_path)


def test_a_dead_link_and_a_dead_anchor_are_seen(tmp_path):
    pages = {
        "a": '<article><a href="b.html#x">1</a><a href="b.html#y">2</a><a href="c.html">3</a></article>',
        "b": '<p id="x"><a href="#x">4</a><a href="#z">5</a><a href="http://b.org">6</a><img src="a.html?v=1"></p>',
    }
    found = site_of(tmp_path, **pages)
    assert found.dead == ("a.html: b.html#y", "a.html: c.html", "b.html: #z")
    assert found.hosts == {"b.org"} and found.count == 6
    assert found.links == {"a.html": {"b.html"}, "b.html": frozenset()}


def test_a_site_whose_equation_is_far_from_its_c_is_refused(tmp_path, monkeypatch):
    """e -> 1 -> u and back by 2 pages is near; one more page between them is not, nor is a large one or a dead link."""
    (folder,) = (folder for folder in folders() if folder.name == "euler_matching")
    (unit,) = (unit for unit in trace.units_of(folder) if unit.path.stem == "em_F")
    known = trace.Trace(units=[unit])
    monkeypatch.setattr(trace, "cited_pages", lambda folder: {"1"})
    known.equations["song-lee-2001", "20"] = one = trace.Equation("song-lee-2001", "20", "(20)", "exact", "", "")

    def written(*ring):
        for page, to in zip(ring, [*ring[1:], ring[0]], strict=True):
            path = tmp_path / f"{page}.html"
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(f'<article><a href="{layout.up(page)}{to}.html">to</a></article>')

    written(one.page, "1", unit.page, "2", "3")
    assert "clicks from an equation to its C and back: 1 by 3; no C stands on \n" in build.checked(tmp_path, known)
    written(one.page, "1", unit.page, "2", "3", "4")
    with pytest.raises(
        SystemExit, match=r"site: \S+20.html and its C are more than 3 clicks apart: 2 there, \[4\] back"
    ):
        build.checked(tmp_path, known)
    written(one.page, unit.page)
    monkeypatch.setattr(trace, "cited_pages", lambda folder: {"nowhere"})
    with pytest.raises(SystemExit, match="site: a header of euler_matching cites the page nowhere, which is not there"):
        build.checked(tmp_path, known)
    monkeypatch.setattr(build, "LARGEST", 10)
    with pytest.raises(SystemExit, match=r"bytes, more than 10"):
        build.checked(tmp_path, known)
    (tmp_path / "x.html").write_text('<a href="y.html">')
    with pytest.raises(SystemExit, match=r"site: dead links: 1; the first is x.html: y.html"):
        build.checked(tmp_path, known)


def test_clicks_are_those_of_the_shortest_path():
    ring = {"a": ["b", "c"], "b": ["d"], "c": ["e"], "d": ["e"], "e": ["a"], "f": []}
    assert links.clicks(ring, "a", {"e"}) == 2 and links.clicks(ring, "e", {"d"}) == 3
    assert links.clicks(ring, "a", {"a"}) == 0 and links.clicks(ring, "a", {"d", "c"}) == 1
    assert links.clicks(ring, "a", {"f"}) is None and links.clicks(ring, "f", {"a"}) is None


def test_a_link_that_is_fenced_stays():
    text = "[a](b.md) ![c](d.png)\n```\n[e](f.md)\n```\n[`[g]`](h)"
    assert layout.turned(text, lambda sign, words, target: f"{sign}<{words}|{target}>") == (
        "<a|b.md> !<c|d.png>\n```\n[e](f.md)\n```\n<`[g]`|h>"
    )


def test_every_link_of_docs_leads_to_a_page_of_the_site(tmp_path):
    source = layout.Source(tmp_path / "source")
    for path in layout.pages():
        source.page(path)
    pages = {layout.docname(path) for path in layout.pages()}
    written = {path.relative_to(source.folder).with_suffix("").as_posix() for path in source.folder.rglob("*.md")}
    assert written == pages and len(pages) > 50
    shown = pages | {layout.docname(path) for path in source.files}
    for page in pages:
        text = (source.folder / f"{page}.md").read_text()
        for _, _, target in layout.LINK.findall("".join(layout.FENCED.split(text)[::2])):
            place = target.partition("#")[0]
            if place.endswith(".md") and "://" not in place:
                there = (source.folder / page).parent.joinpath(place).resolve().relative_to(source.folder.resolve())
                assert there.with_suffix("").as_posix() in shown, f"{page}: {target}"


def test_a_block_that_is_a_file_shows_its_name(tmp_path):
    source = layout.Source(tmp_path / "source")
    source.write("a", "# A\n\n```python swing.py\nx = 1\n```\n\n```python\ny = 2\n```\n")
    assert (source.folder / "a.md").read_text() == (
        "# A\n\n```{code-block} python\n:caption: swing.py\n\nx = 1\n```\n\n```python\ny = 2\n```\n"
    )


def test_a_link_to_nothing_is_refused(tmp_path):
    with pytest.raises(SystemExit, match=r"site: x links to nowhere.md, which is not there"):
        layout.Source(tmp_path / "source").included("[a](nowhere.md)", ROOT / "docs", "x")


def test_every_page_of_docs_is_of_one_kind(monkeypatch):
    listed = [name for names in build.by_kind().values() for name in names]
    assert len(listed) == len(set(listed)) == len(layout.pages())
    monkeypatch.setattr(build, "KINDS", {**build.KINDS, "Tutorials": ()})
    with pytest.raises(SystemExit, match=r"site: from-nothing: name each page"):
        build.by_kind()


def test_every_public_name_stands_in_the_reference_once():
    names = [name for names in reference.groups().values() for name in names]
    assert sorted(names) == sorted(boresight.PUBLIC)


def compiled(folder, more, tmp_path):
    """What the compiler finds declared in the folder's headers, and what it says of declarations behind them."""
    headers = "".join(f'#include "{path.name}"\n' for path in sorted(folder.include.glob("*.h")))
    (tmp_path / "all.c").write_text(headers + more)
    flags = ["-std=c99", "-fsyntax-only", f"-I{folder.include}", "-aux-info", str(tmp_path / "aux")]
    done = subprocess.run(["gcc", *flags, str(tmp_path / "all.c")], capture_output=True, text=True, check=False)
    lines = (tmp_path / "aux").read_text().splitlines() if not done.returncode else []
    own = [line for line in lines if f"{folder.include}/" in line and " extern " in line]
    return {re.search(r"(\w+) \(", line.partition("*/")[2])[1] for line in own}, done.stderr


@pytest.mark.parametrize("folder", folders(), ids=lambda folder: folder.name)
def test_each_function_of_a_header_stands_on_one_page_as_it_is_declared(folder, tmp_path, monkeypatch):
    """The compiler takes what the pages show as another declaration of the same; and the comment is the header's."""
    monkeypatch.setattr(trace.statements, "table", lambda unit: "not of the header")  # which takes seconds
    source, known = layout.Source(tmp_path / "source"), trace.Trace(units=trace.units_of(folder))
    shown = []
    for unit in known.units:
        trace.unit_page(source, known, unit)
        page = (source.folder / f"{unit.page}.md").read_text()
        part = page.split("## Prototypes")[1].split("\n## ")[0]
        for text in re.findall(r"^`{5}\{code-block\} c\n(.*?)^`{5}$", part, re.MULTILINE | re.DOTALL):
            shown.append(text)
            assert any(text.strip() in path.read_text() for path in folder.include.glob("*.h"))
    names, wrong = compiled(folder, "".join(shown), tmp_path)
    assert not wrong and names == set(known.functions) and len(shown) == len(names) > 0


def test_a_graph_has_each_equation_and_an_arc_to_each_that_it_stands_on():
    html = "".join(f'<a href="#eq-{n}">({n})</a>' for n in ("1", "2", "9"))  # (9) is of no paper here
    named = {"1": ("exact", ""), "2": ("erratum: sign", ""), "3": ("definition", html)}
    of = [trace.Equation("p", n, f"({n})", status, "", text) for n, (status, text) in named.items()]
    drawn = trace.graph(of, "p/")
    assert re.findall(r'href="p/(\d).html" class="square (\S+)"', drawn) == [
        ("1", "exact"), ("2", "erratum"), ("3", "definition")
    ]  # fmt: skip
    at = [float(x) for x in re.findall(r'<text x="([\d.]+)"', drawn)]
    arcs = [(float(b), float(a)) for a, b in re.findall(r'd="M([\d.]+) .*? ([\d.]+) [\d.]+"', drawn)]
    assert sorted(arcs) == [(at[0], at[2]), (at[1], at[2])]


def test_a_prototype_that_is_not_the_headers_is_seen(tmp_path):
    (folder,) = (folder for folder in folders() if folder.name == "euler_matching")
    text = trace.prototypes(folder)["em_F"].text
    assert compiled(folder, text, tmp_path)[1] == ""
    assert "conflicting types" in compiled(folder, text.replace("em_step", "em_nav"), tmp_path)[1]


def test_every_equation_leads_to_c_or_is_named_as_one_that_does_not():
    """(7) is used by (9), which em_F cites: a page further away is reached, and one that nothing uses is not."""
    known = trace.Trace()
    known.units = [unit for folder in folders() for unit in trace.units_of(folder)]
    for number, uses in {"7": (), "20": ("7",), "30": ()}.items():
        html = "".join(f'<a href="#eq-{n}">({n})</a>' for n in uses)
        one = trace.Equation("song-lee-2001", number, f"({number})", "exact", "", html)
        known.equations["song-lee-2001", number] = one
    names = {e.number: {unit.path.stem for unit in known.reached(e)} for e in known.equations.values()}
    assert "em_F" in names["20"] and names["7"] == names["20"] and not names["30"]


@pytest.mark.parametrize("folder", folders(), ids=lambda folder: folder.name)
def test_the_headers_cite_the_pages_of_the_model_of_its_functions_and_of_their_equations(folder):
    units = trace.units_of(folder)
    equations = {(m[1], m[2]) for unit in units for one in unit.equations if (m := trace.CITED.fullmatch(one))}
    pages = {trace.Equation(*of, "", "", "", "").page for of in equations}
    cited = trace.cited_pages(folder)
    assert f"models/{folder.name}" in cited
    if folder.manifest["model"] not in COMPONENTS:
        private = {f"c/{folder.name}/{folder.manifest['c_prefix']}_{part}" for part in ("math", "identity")}
        assert cited == {f"models/{folder.name}"} | pages | {unit.page for unit in units} - private


def test_a_model_of_ones_own_has_no_page():
    named = SimpleNamespace(name="euler-matching"), SimpleNamespace(name="mine")
    found = [pages(model, "em_F", ("kim-2018 (9)",)) for model in named]
    assert found == ["c/euler_matching/em_F, equations/kim-2018/9", ""]


def test_names_in_code_become_links_to_their_pages():
    known = trace.Trace(units=[unit for f in folders() if f.name == "euler_matching" for unit in trace.units_of(f)])
    known.equations["kim-2018", "9"] = trace.Equation("kim-2018", "9", "(9)", "erratum", "", "")
    text = known.linked("<code>em_F</code> <code>em_X</code> kim-2018 (9) kim-2018 (99)", "a/b/c")
    assert text == (
        '<a href="../../c/euler_matching/em_F.html"><code>em_F</code></a> <code>em_X</code> '
        '<a href="../../equations/kim-2018/9.html">kim-2018 (9)</a> kim-2018 (99)'
    )


def test_each_study_has_a_page_which_the_equations_of_its_models_lead_to():
    found = trace.studied()
    assert {model for name in STUDIES for model in study(name).models} == {model for model, on in found.items() if on}
    assert [page.stem for page in found["euler-matching"]] == ["euler-matching"]
    assert "sea-exploration" in {page.stem for page in found["velocity-attitude-lever"]}


def test_the_tests_of_an_equation_are_those_that_are_marked_with_it():
    found = trace.tests_of()
    text = (ROOT / "tests" / "derive" / "test_kang_2025.py").read_text()
    marked = re.findall(r'@pytest.mark.equations\("([^"]*)"\)', text)
    assert sum(len(of) for (paper, _), of in found.items() if paper == "kang-2025") == sum(
        len(numbers.split()) for numbers in marked
    )
    assert all(f"def {name}(" in path.read_text() for of in found.values() for path, name in of)


def test_a_block_that_ran_shows_what_it_prints_and_draws(tmp_path):
    text = (
        "# A\n\n```python\nx = 2\nprint(x)\n```\n```text\nold\n```\n\n```python\nopen(f'{x}.png', 'w').close()\n```\n"
    )
    (tmp_path / "in").mkdir()
    (tmp_path / "out").mkdir()
    page, notebook = executed.page(text, tmp_path / "in", tmp_path / "out", "figures/")
    assert (
        "```\n```text\n2\n```\n" in page and "old" not in page and "![drawn by the lines above](figures/2.png)" in page
    )
    assert (tmp_path / "out" / "2.png").is_file() and '"text": "2\\n"' in notebook


def test_a_figure_finds_the_function_that_draws_it():
    path, name, text = reference.drawn_by("sea_slope_figure_4_compensation")
    assert (path.parent.name, path.name, name) == ("sea_state", "figures.py", "compensation")
    assert text.startswith("def compensation(") and reference.drawn_by("nobody_draws_this") is None
    shown = [Path(name).stem for name in reference.shown_on([ROOT / "README.md", *layout.pages()])]
    assert sorted(name for name in shown if not reference.code_of(name)) == sorted(reference.BY_HAND)
    path, name, text = reference.code_of("sea_slope_figure_3_with")
    assert (path.name, name) == ("figures.py", "heading") and "def draw" in reference.code_of("noise")[2]


def test_of_what_verify_prints_the_rows_that_failed_are_shown():
    text = (
        "m\n  F  1 ok\n  held against  exact  difference\n  F  a:  7 FAILED\n     more\n  G  b  ok\n"
        "  Phi c 1\n     d FAILED\nThe bits\nverify: 2 failed\n"
    )
    assert build.fault(text).splitlines() == [
        "  held against  exact  difference", "  F  a:  7 FAILED", "     more", "  Phi c 1", "     d FAILED",
        "verify: 2 failed",
    ]  # fmt: skip


def test_every_figure_is_a_page_with_its_code(tmp_path):
    source = layout.Source(tmp_path / "source")
    reference.gallery(source)
    shown = reference.shown_on([ROOT / "README.md", *layout.pages()])
    cards = re.findall(r"^:link: (gallery/.*)$", (source.folder / "gallery.md").read_text(), re.MULTILINE)
    assert sorted(cards) == sorted(f"gallery/{Path(name).stem}" for name in shown) and len(cards) > 30
    text = (source.folder / "gallery" / "sea_unknown_delay.md").read_text()
    assert "![" in text and "def unknown_delay(" in text and "../sea-state.md" in text
    assert "by hand" in (source.folder / "gallery" / "pipe.md").read_text()


def test_figures_are_svg_and_small():
    there = list((ROOT / "docs" / "figures").iterdir())
    assert there and {path.suffix for path in there} == {".svg"}
    assert not [path.name for path in there if path.stat().st_size > 650_000]


def test_the_first_flight_is_that_of_the_readme_and_keeps_its_estimates():
    readme = (ROOT / "README.md").read_text()
    code = build.flight()
    lines = [line for line in re.findall(r"```python\n(.*?)```", readme, re.DOTALL)[0].splitlines() if line]
    assert [line for line in code.splitlines() if line in lines][-1] == lines[-1]
    assert {line for line in lines if line not in code.splitlines()} == {"from boresight import Filter, load, rotation"}
