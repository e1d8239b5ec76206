"""`make site`: the pages of docs/, and a page of every equation, model, unit of C, public name and command.

    python -m docs.site.build [-o FOLDER]

FOLDER-source is what Sphinx reads, FOLDER what it makes; a warning is an error.  At the end all links are followed:
none may be dead, and an equation and its C are at most three clicks apart.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from docs.site import executed, layout, links, reference, trace
from docs.site.layout import ROOT, fenced, toctree

HERE = Path(__file__).resolve().parent
CLICKS = 3
LARGEST = 300_000  # bytes of a page without its figures
DOCS = ROOT / "docs"
SYMPTOMS = ("my-sensor-is-late", "my-log-has-only-a-rate", "nis-is-3", "bs-out-of-range", "which-noise", "which-sensor")
# The pages of docs/ itself by kind, in the order of reading; those of its folders follow by name.
KINDS: Mapping[str, tuple[str, ...]] = {
    "Something is wrong": tuple(f"how-to/{name}" for name in SYMPTOMS),
    "Tutorials": ("tutorial", "from-nothing", "your-paper", "smoother", "observability"),
    "How-to": ("design-questions", "error-budget", "noise", "recordings", "transfer-alignment", "live", "zero-velocity",
               "stationary-detectors", "batch", "from-ekf2-and-kf-gins"),
    "Explanation": ("conventions", "own-model", "mechanics", "covariance", "float", "evidence", "cross-checks",
                    "benchmarks"),
    "Studies": ("euler-matching", "azimuth-hold", "sea-state", "sea-exploration"),
}  # fmt: skip
FOLDERS = {"How-to": "how-to", "Explanation": "decisions", "Studies": "derivations", "Reference": "reference"}
PROJECT = ("README", "CHANGELOG", "CONTRIBUTING", "SECURITY")
NOTEBOOK = DOCS / "from-nothing.md"
WRONG = "wrong_axes.py:WRONG"  # of examples/


def by_kind() -> dict[str, list[str]]:
    """Kind -> names of the pages of docs/, each in one kind.  Raises SystemExit on a page that is in none."""
    found = {kind: list(names) for kind, names in KINDS.items()}
    for kind, folder in FOLDERS.items():
        names = (f"{folder}/{path.stem}" for path in sorted((DOCS / folder).glob("*.md")) if path.stem not in SYMPTOMS)
        found.setdefault(kind, []).extend(names)
    listed = [name for names in found.values() for name in names]
    there = {layout.docname(path) for path in layout.pages()}
    if wrong := sorted(set(listed) ^ there):
        raise SystemExit(f"site: {wrong[0]}: name each page of docs/ in KINDS of {Path(__file__).name}, and no other")
    return found


def flight() -> str:
    """The first flight of the README, with what keeps it and what draws it."""
    (code,) = re.findall(r"```python\n(.*?)```", (ROOT / "README.md").read_text(encoding="utf-8"), re.DOTALL)
    begin = "\nfor k in range"
    assert code.count(begin) == 1
    kept = code.replace("import Filter,", "import Filter, Record,").replace(begin, "record = Record(loop)\n" + begin)
    return kept + (
        "\nimport matplotlib.pyplot as plt\n\n"
        'after = record.rows("feedback")\n'
        'plt.figure(figsize=(7, 2.6), layout="constrained")\n'
        'plt.plot(np.degrees(record.nav["mu"][after]), label=["front", "right", "down"])\n'
        'plt.hlines(np.degrees(mu), 0, len(after), "k", "dotted", linewidth=1)\n'
        'plt.xlabel("time [s]")\n'
        'plt.ylabel("misalignment [deg]")\n'
        "plt.legend()\n"
        'plt.savefig("first-flight.svg")\n'
    )


def home(source: layout.Source, kinds: Mapping[str, list[str]]) -> None:
    """What it does, a fault that it finds, how it is installed, a first flight, and four doors."""
    (source.folder / "figures").mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        shutil.copy(ROOT / "examples" / WRONG.partition(":")[0], place)
        executed.command("generate", WRONG, folder=place)
        found, status = executed.command("verify", WRONG, folder=place)
        if status != 1:
            raise SystemExit(f"site: verify of {WRONG} ended with {status}, not with 1")
        flown, _ = executed.page(f"```python\n{flight()}```\n", place, source.folder / "figures", "figures/")
    names = {"fault": fenced("$ boresight verify " + WRONG + "\n" + fault(found)), "flight": flown}
    text = source.included((HERE / "home.md").read_text(encoding="utf-8"), HERE, "index")
    for name, value in names.items():
        text = text.replace(f"<!-- {name} -->", value)
    source.write("index", "\n".join([text, *(toctree(of, kind) for kind, of in kinds.items())]))


def fault(found: str) -> str:
    """Of what `verify` prints the rows that failed, each whole, and its last line."""
    lines = found.rstrip().splitlines()
    first = next(i for i, line in enumerate(lines) if "held against" in line)
    shown, rows = lines[first : first + 1], []
    for line in lines[first + 1 :]:
        if not line.startswith("  "):
            break
        rows += [[line]] if line[2] != " " else []
        rows[-1] += [line] if line[2] == " " else []
    shown += [line for row in rows if any("FAILED" in line for line in row) for line in row]
    return "\n".join([*shown, lines[-1]])


def menu(source: layout.Source) -> dict[str, list[str]]:
    """Kind -> names of all pages of the menu; those of the reference are written."""
    kinds = by_kind()
    kinds["Reference"] = [*reference.names(source), reference.commands(source), *kinds["Reference"]]
    kinds["Equation to C"] = ["equations/index", "models/index", "gallery"]
    kinds["Project"] = [f"files/{name}" for name in PROJECT]
    return kinds


def written(source: layout.Source) -> trace.Trace:
    """All that Sphinx reads."""
    for path in layout.pages():
        if path != NOTEBOOK:
            source.page(path)
    notebook(source)
    for name in PROJECT:
        source.page(ROOT / f"{name}.md")
    known, kinds = trace.write(source), menu(source)
    reference.gallery(source)
    home(source, kinds)
    about = (HERE / "home.md").read_text(encoding="utf-8").split("\n\n")[1]
    reference.for_programs(source, about.replace("\n", " "), kinds)
    source.shown_files()
    return known


def notebook(source: layout.Source) -> None:
    """The page whose blocks run now, and the same as a notebook."""
    (source.folder / "figures").mkdir(exist_ok=True)
    text = source.included(NOTEBOOK.read_text(encoding="utf-8"), DOCS, "from-nothing")
    with tempfile.TemporaryDirectory() as folder:
        text, cells = executed.page(text, Path(folder), source.folder / "figures", "figures/")
    (source.extra / "from-nothing.ipynb").write_text(cells, encoding="utf-8")
    title, rest = text.split("\n", 1)
    link = '<a href="from-nothing.ipynb">This page as a notebook</a>; all of it ran when the site was built.'
    source.write("from-nothing", f"{title}\n\n{link}\n{rest}")


def checked(out: Path, known: trace.Trace) -> str:
    """One line on the site.  Raises SystemExit on a dead link, a page that is too large, an equation far from its C."""
    site = links.read(out)
    if site.dead:
        raise SystemExit(f"site: dead links: {len(site.dead)}; the first is {site.dead[0]}")
    sizes = {path: path.stat().st_size for path in out.rglob("*.html")}
    path, size = max(sizes.items(), key=lambda item: item[1])
    if size > LARGEST:
        raise SystemExit(f"site: {path.relative_to(out)} has {size} bytes, more than {LARGEST}")
    for folder in dict.fromkeys(unit.folder for unit in known.units):
        if gone := sorted(page for page in trace.cited_pages(folder) if f"{page}.html" not in site.links):
            raise SystemExit(f"site: a header of {folder.name} cites the page {gone[0]}, which is not there")
    far: Counter[int] = Counter()
    without = []
    for equation, units in trace.ends(known):
        page, wanted = f"{equation.page}.html", {f"{unit.page}.html" for unit in units}
        there = links.clicks(site.links, page, wanted) if wanted else None
        back = [links.clicks(site.links, unit, {page}) for unit in wanted]
        worst = max((n for n in (there, *back) if n is not None), default=0)
        if not wanted:
            without.append(f"{equation.paper} {equation.title}")
            continue
        if there is None or None in back or worst > CLICKS:
            raise SystemExit(f"site: {page} and its C are more than {CLICKS} clicks apart: {there} there, {back} back")
        far[worst] += 1
    clicks = ", ".join(f"{count} by {n}" for n, count in sorted(far.items()))
    return (
        f"site: {len(sizes)} pages, {site.count} links, none dead; the largest page has {size // 1000} kB\n"
        f"site: clicks from an equation to its C and back: {clicks}; no C stands on {', '.join(without)}\n"
        f"site: other hosts are {', '.join(sorted(site.hosts))}"
    )


def main(arguments: Any = None) -> None:
    parser = argparse.ArgumentParser(description="Make the site of the documentation.")
    parser.add_argument("-o", "--out", type=Path, default=ROOT / "out" / "site")
    out = parser.parse_args(arguments).out.resolve()
    os.environ.setdefault("MPLBACKEND", "agg")
    source = layout.Source(out.with_name(out.name + "-source"))
    known = written(source)
    print(f"site: laid out in {time.process_time():.0f} s of processor time", flush=True)
    shutil.rmtree(out, ignore_errors=True)
    options = ["-W", "--keep-going", "-q", "-c", str(HERE), "-d", str(out.with_name(out.name + "-doctrees"))]
    run = [sys.executable, "-m", "sphinx", *options, str(source.folder), str(out)]
    if subprocess.run(run, check=False).returncode:
        raise SystemExit("site: Sphinx warns, see above")
    shutil.copytree(source.extra, out, dirs_exist_ok=True)
    shutil.rmtree(out / ".doctrees", ignore_errors=True)
    print(checked(out, known))
    print(f"site: {out / 'index.html'}; {sum(os.times()[:4]):.0f} s of processor time")


if __name__ == "__main__":
    main()
