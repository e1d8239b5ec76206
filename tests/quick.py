"""`make quick`: style and types, a law of each room, and the tests of what was edited, in about a minute on two cores.

    python tests/quick.py [BASE]

Edited is what differs from BASE (HEAD if left out) in the checkout, committed or not.  Its tests are those that import
it, the nearest first and of them the cheapest, as many as fit; of what makes C, `generate --check` of models besides.
The last line says what was run and what was not.
"""

import shlex
import subprocess
import sys
from collections import defaultdict, deque
from collections.abc import Iterator
from pathlib import Path

from boresight.codegen import stamp
from boresight.codegen.generate import source_of

TESTS = Path(__file__).resolve().parent
ROOT = TESTS.parent
BUDGET = 45.0  # processor seconds for the tests of what was edited
FAR = 3  # imports between a test and what was edited, from which on it is not asked
LAYERS = ("derive", "codegen", "runtime", "analysis", "studies", "evidence")
CHECKED = "tests/test_promises.py::test_what_is_committed_is_what_its_source_makes"
CHEAPEST = ("strapdown", "euler-matching")  # of the models that are generated; most of what is written is in them
ROOMS = (
    "tests/test_promises.py::test_style_and_types_hold",
    "tests/test_promises.py::test_no_generated_file_was_edited",
    "tests/test_promises.py::test_a_folder_was_made_by_the_sources_that_are_here",
    "tests/test_imports.py::test_a_layer_imports_only_along_the_arrows",
    f"{CHECKED}[strapdown]",
    "tests/derive/test_maps.py",
    "tests/runtime/test_total_state.py",
    "tests/runtime/test_recording.py",
    "tests/studies/test_euler_table.py::test_the_closed_loop_gives_the_papers_147_cells",
    "tests/evidence/test_results.py",
)


def costs() -> dict[str, float]:
    """Processor seconds of each file of tests and of the dearest tests, as tests/costs.py found them."""
    rows = (line.split(maxsplit=1) for line in (TESTS / "costs.txt").read_text(encoding="utf-8").splitlines())
    return {name: float(cost) for cost, name in rows}


def edited(base: str) -> list[Path]:
    """What differs from a revision, or is new; nothing where git knows no such tree."""
    found: list[str] = []
    for words in (f"diff --name-only {shlex.quote(base)}", "ls-files --others --exclude-standard"):
        try:
            done = subprocess.run(["git", *shlex.split(words)], cwd=ROOT, capture_output=True, text=True, check=False)
        except FileNotFoundError:
            return []
        if done.returncode:
            if base != "HEAD":
                raise SystemExit(f"quick: git knows no {base}; give a revision")
            return []
        found += done.stdout.splitlines()
    return [ROOT / name for name in dict.fromkeys(found)]


def imports(path: Path) -> Iterator[Path]:
    """The files of this project that a file imports, at any depth in it; a test also what lies beside it."""
    for name in stamp.imported(path):
        yield from stamp.located(name, stamp.FRONT)
        places = (home.joinpath(*name.split(".")) for home in (ROOT, path.parent, TESTS))
        yield from (file for place in places if (file := place.with_suffix(".py")).is_file())


def all_importers() -> dict[Path, list[Path]]:
    """The files that import each."""
    found = defaultdict(list)
    for folder in (*LAYERS, "boresight", "tests"):
        for file in (ROOT / folder).rglob("*.py"):
            for other in imports(file):
                found[other].append(file)
    return found


def near(path: Path, importers: dict[Path, list[Path]]) -> dict[str, int]:
    """Files of tests, and how many imports each is away from what was edited; of what is no module, those that name
    it.  What is generated is held by the hashes in its manifest."""
    if path.is_relative_to(ROOT / "generated"):
        return {}
    if path.suffix != ".py":
        named = (test for test in TESTS.rglob("test_*.py") if path.name in test.read_text(encoding="utf-8"))
        return {test.relative_to(ROOT).as_posix(): 1 for test in named}
    found, waiting = {path: 0}, deque([path])
    while waiting:
        file = waiting.popleft()
        for importer in importers[file]:
            if importer not in found:
                found[importer] = found[file] + 1
                waiting.append(importer)
    tests = {file: far for file, far in found.items() if TESTS in file.parents and file.name.startswith("test_")}
    return {file.relative_to(ROOT).as_posix(): far for file, far in tests.items()}


def models(path: Path) -> list[str]:
    """The models whose C a file makes, of those that are generated to check it."""
    generator = {p for f in ("functions", "text", "templates") for p in (ROOT / "codegen" / f).rglob("*")}
    if path in stamp.reached({p for p in generator if p.suffix in (".py", ".j2")}):
        return list(CHEAPEST)
    return [name for name in CHEAPEST if (source := source_of(name)) and path in stamp.reached({source})]


def chosen(paths: list[Path]) -> tuple[list[str], list[str]]:
    """What pytest is given for what was edited, and the tests that are left out: where a file does not fit, its dearest
    tests, and where it does not fit without them, all of it."""
    known, importers, spent = costs(), all_importers(), 0.0
    checks, distance = dict.fromkeys(name for path in paths for name in models(path)), {}
    for path in paths:
        for name, far in near(path, importers).items():
            distance[name] = min(far, distance.get(name, FAR))
    run, left = [f"{CHECKED}[{name}]" for name in checks], []

    def first(name: str) -> tuple[int, bool, float, str]:
        """Near, then called after what was edited, as tests/runtime/test_filter.py is, then cheap."""
        called = Path(name).stem.removeprefix("test_")
        return distance[name], not any(called in path.as_posix() for path in paths), known.get(name, 1.0), name

    for name in sorted(distance, key=first):
        dear = [] if spent + known.get(name, 1.0) <= BUDGET else [n for n in known if n.startswith(f"{name}::")]
        cost = known.get(name, 1.0) - sum(known[test] for test in dear)
        if distance[name] < FAR and spent + cost <= BUDGET:
            run += [name, *(f"--deselect={test}" for test in dear)]
            left += dear
            spent += cost
        else:
            left.append(name)
    return run, left


def main(base: str = "HEAD") -> int:
    paths = edited(base)
    run, left = chosen([path.resolve() for path in paths if path.is_file()])
    rooms = [law for law in ROOMS if law.split("::")[0] not in run]
    tests = [word for word in run if not word.startswith("--")]
    words = ["-n", "2", "-q"]
    done = subprocess.run([sys.executable, "-m", "pytest", *words, *dict.fromkeys([*rooms, *run])], cwd=ROOT)
    of = f"{len(tests)} files of tests or checks for {len(paths)} edited files" if paths else "nothing was edited"
    rest = f"; not run: {len(left)} files of tests or dear tests that reach them" if left else ""
    print(f"quick: {len(rooms)} laws of the rooms, {of}{rest}; make test runs everything")
    return done.returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
