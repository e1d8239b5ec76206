"""The command line.  Each command imports what it needs when it runs: start-up stays light."""

import json
import sys
from collections.abc import Callable
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from boresight import BoresightError, __version__

if TYPE_CHECKING:
    from rich.console import Console

app = typer.Typer(no_args_is_help=True, add_completion=False, rich_markup_mode=None, pretty_exceptions_enable=False)

AsJson = Annotated[bool, typer.Option("--json", help="Print one JSON document and nothing else.")]
Out = Annotated[Path | None, typer.Option("-o", "--out", help="Folder for results.")]


def console() -> "Console":
    from rich.console import Console

    return Console(highlight=False)


def print_json(document: Any) -> None:
    print(json.dumps(document, indent=2, ensure_ascii=False, allow_nan=False))


def one_of(name: str, known: list[str], what: str) -> str:
    if name not in known:
        raise BoresightError(f"no {what} {name!r}; there are {', '.join(known)}")
    return name


@app.callback(invoke_without_command=True)
def root(version: Annotated[bool, typer.Option("--version", help="Print the version.")] = False) -> None:
    """From the equations of an inertial-navigation filter to C that can be flown."""
    if version:
        print(f"boresight {__version__}")
        raise typer.Exit


@app.command()
def models(as_json: AsJson = False) -> None:
    """The built-in models: states, measurements, and what is generated for each."""
    from boresight.runtime.manifest import built_in, folder_of, read_manifest

    manifests = [read_manifest(folder_of(name)) for name in built_in()]
    if as_json:
        print_json(
            [
                {key: m[key] for key in ("model", "title", "frame", "c_prefix", "states", "measurements")}
                | {"units": {name: unit["operations"] for name, unit in m["units"].items()}}
                for m in manifests
            ]
        )
        return
    from rich.table import Table

    for m in manifests:
        print(f"{m['model']}: {m['title']}")
        print(f"  frame {m['frame']}; C prefix {m['c_prefix']}_; states {' '.join(m['states'])}")
        for name, measurement in m["measurements"].items():
            print(f"  measurement {name} ({', '.join(measurement['rows'])}): {measurement['meaning']}")
        table = Table("C function", "operations", "inputs", "outputs", box=None)
        for unit in m["units"].values():
            outputs = [f"{r['name']} {'x'.join(map(str, r['shape']))}" for r in unit["results"]]
            table.add_row(unit["c_name"], str(unit["operations"]), ", ".join(unit["fields"]), ", ".join(outputs))
        console().print(table)


@app.command()
def equations(
    paper: Annotated[str | None, typer.Argument(help="A paper; all if left out.")] = None, as_json: AsJson = False
) -> None:
    """The ledger: each printed equation, its computed status, and every erratum with numbers."""
    import textwrap
    from collections import Counter

    from boresight.derive.ledger import PAPERS, findings, ledger

    papers = [one_of(paper, list(PAPERS), "paper")] if paper else list(PAPERS)
    entries = [entry for name in papers for entry in ledger(name)]
    if as_json:
        print_json([entry.to_dict() for entry in entries])
        return
    for name in papers:
        own = [entry for entry in entries if entry.paper == name]
        print(name)
        for entry in own:
            head = f"{'(' + entry.number + ')':>6}  {entry.status:<12}"
            if entry.status != "erratum":
                print(textwrap.fill(head + entry.evidence.split("; ")[-1], 110, subsequent_indent=" " * 20))
                continue
            print(f"{head}{entry.kind}, {entry.origin}")
            for text in (entry.note, entry.evidence):
                print(textwrap.fill(text, 110, initial_indent=" " * 10, subsequent_indent=" " * 10))
        for finding in findings(name):
            print(textwrap.fill(str(finding), 110, subsequent_indent="  "))
        counts = Counter(entry.status for entry in own)
        print(f"{name}: " + ", ".join(f"{count} {status}" for status, count in sorted(counts.items())) + "\n")


@app.command()
def show(
    name: Annotated[
        str, typer.Argument(metavar="MODEL|PAPER", help="A model, a paper, or delay-error: what an unknown delay does.")
    ],
    equation: Annotated[str | None, typer.Argument(help="Number of an equation; all if left out.")] = None,
    form: Annotated[str, typer.Option("--format", help="text, latex, html or pdf.")] = "text",
    out: Annotated[Path | None, typer.Option("-o", "--out", help="File to write; needed for pdf.")] = None,
) -> None:
    """The derivation of a paper's equations, or of those that a model stands on, step by step."""
    from boresight.codegen.generate import model_names
    from boresight.derive import render as r
    from boresight.derive.ledger import PAPERS

    one_of(name, [*PAPERS, *model_names(), "delay-error"], "paper or model")
    one_of(form, [*r.FORMATS, "pdf"], "format")
    if form == "pdf" and out is None:
        raise BoresightError("a pdf needs a file to go to; add -o FILE.pdf")
    kind = "latex" if form == "pdf" else form
    if name == "delay-error":
        text = delay_error(equation, kind)
    else:
        text = r.render(name, equation, kind) if name in PAPERS else model_equations(name, equation, kind)
    if out is None:
        sys.stdout.write(text)
    else:
        write(out, r.pdf_from_latex(text) if form == "pdf" else text.encode())


def delay_error(number: str | None, form: str) -> str:
    from boresight.derive.delay_error import derivation
    from boresight.derive.render import render_derivation

    if number is not None:
        raise BoresightError(f"delay-error is one derivation and has no ({number}); leave the number out")
    return render_derivation("Heading error of an unknown delay", derivation(), form)


def model_equations(name: str, number: str | None, form: str) -> str:
    """The equations that a model refers to, as `song-lee-2001 (19)`, in one of the formats."""
    from boresight.codegen.generate import load_model
    from boresight.derive.ledger import equations, ledger
    from boresight.derive.render import render_equations

    model = load_model(name)
    named = {*model.equations, *(e for part in (*model.measurements, *model.functions) for e in part.equations)}
    known = {
        f"{e.paper} ({e.number})": (e, entry)
        for paper in sorted({text.split(" ")[0] for text in named})
        for e, entry in zip(equations(paper), ledger(paper), strict=True)
    }
    chosen = [known[key] for key in known if key in named and number in (None, known[key][0].number)]
    if not chosen:
        raise BoresightError(f"{name} does not stand on ({number}), but on {', '.join(k for k in known if k in named)}")
    named_equations, entries = zip(*chosen, strict=True)
    return render_equations(f"{model.name}: {model.title}", named_equations, entries, form)


def write(path: Path, content: bytes) -> None:
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    except OSError as error:
        raise BoresightError(f"cannot write {path} ({error.strerror}); choose another file with -o") from None


@app.command()
def generate(
    targets: Annotated[
        list[str] | None, typer.Argument(metavar="[MODEL | FILE.py:NAME]...", show_default=False)
    ] = None,
    check: Annotated[bool, typer.Option("--check", help="Write nothing; exit 1 if anything would change.")] = False,
    out: Annotated[Path | None, typer.Option("-o", "--out", help="Folder, if there is one model.")] = None,
) -> None:
    """Make the generated C agree with its models, and say which functions changed.

    Exit status with --check: 0 no difference, 1 a difference, 3 other versions of SymPy or CasADi than those that the
    committed files were made with, so that nothing can be said.
    """
    from boresight.codegen import generate as g

    targets = targets or g.target_names()
    if out is not None and len(targets) > 1:
        raise BoresightError("-o names one folder; give one model with it")
    status = 0
    for target in targets:
        report = g.generate(target, out, check)
        label = f"{report.model} in {report.folder}"
        if not report.comparable:
            made = ", ".join(f"{k} {v}" for k, v in g.old_manifest(report.folder)["versions"].items())
            here = ", ".join(f"{k} {v}" for k, v in g.versions().items())
            print(f"{label}: not comparable; made with {made}, here are {here}")
            status = max(status, 3)
            continue
        if report.up_to_date or not report.written:
            print(f"{label}: nothing changed")
            continue
        for change in report.changes:
            print(f"  {change}")
        verb = "would change" if check else "written"
        print(f"{label}: {len(report.changes)} functions differ, {len(report.written)} files {verb}")
        if check:
            for path in report.written:
                print(f"  {path}")
            status = max(status, 1)
    raise typer.Exit(status)


@app.command()
def verify(
    targets: Annotated[
        list[str] | None, typer.Argument(metavar="[MODEL | FILE.py:NAME]...", show_default=False)
    ] = None,
    folder: Annotated[Path | None, typer.Option("--generated", help="Generated folder of a model of your own.")] = None,
    as_json: AsJson = False,
) -> None:
    """Prove the compiled C: bit for bit against CasADi's C, and within rounding of 50-digit arithmetic."""
    from rich.progress import Progress, SpinnerColumn, TextColumn
    from rich.table import Table

    from boresight.codegen import verify as v
    from boresight.codegen.generate import default_folder, model_names

    targets = targets or model_names()
    if folder is not None and len(targets) > 1:
        raise BoresightError("--generated names one folder; give one model with it")
    checks = []
    from rich.console import Console

    with Progress(
        SpinnerColumn(), TextColumn("{task.description}"), transient=True, console=Console(stderr=True)
    ) as bar:
        task = bar.add_task("")
        for target in targets:
            where = folder or (default_folder(target) if ":" in target else None)
            checks += v.verify(
                target,
                where,
                progress=lambda done, total, text: bar.update(task, description=f"{done} of {total}, {text}"),
            )
    good = all(check.ok for check in checks)
    if as_json:
        print_json(v.to_json(checks))
        raise typer.Exit(0 if good else 1)
    table = Table(
        "model", "function", "points", "outputs", "bits as CasADi", "largest error", "bound / error", "", box=None
    )
    for check in checks:
        if isinstance(check, v.UnitCheck):
            loose = f"{check.looseness:.1f}" if isfinite(check.looseness) else "exact"
            table.add_row(
                check.model, check.unit, str(check.points), str(check.outputs), "yes" if check.same_bits else "NO",
                f"{check.largest_error:.1e}", loose, "ok" if check.ok else "FAILED",
            )  # fmt: skip
    console().print(table)
    for check in checks:
        if isinstance(check, v.FirstOrderCheck):
            beyond = (
                f" where nothing is neglected, then by {check.coefficient:.3f} a unit of what is; halved, the "
                f"difference is {check.ratio:.4f} of it"
                if check.coefficient is not None
                else ""
            )
            print(
                f"{check.model} {check.unit}: differs from the exact Jacobian by {check.limit:.1e}{beyond}: "
                f"{'ok' if check.ok else 'FAILED'}"
            )
    print(f"verify: {sum(c.ok for c in checks)} passed, {sum(not c.ok for c in checks)} failed")
    raise typer.Exit(0 if good else 1)


@app.command()
def export(
    target: Annotated[str, typer.Argument(metavar="MODEL | FILE.py:NAME", show_default=False)],
    out: Annotated[Path, typer.Option("-o", "--out", help="The new folder.", show_default=False)],
    precision: Annotated[str, typer.Option(help="double, or float with the covariance as UD factors.")] = "double",
    folder: Annotated[Path | None, typer.Option("--generated", help="Generated folder of a model of your own.")] = None,
) -> None:
    """Write a folder of C that needs nothing of Python: filter, self-test, example, Makefile, CMake package."""
    from boresight.codegen.export import export as write

    written = write(target, out, precision, folder)
    print(f"{len(written)} files in {out}; try 'make -C {out} test example'")


STUDIES = ["azimuth-hold", "euler-table", "float-covariance", "sea-state"]


@app.command()
def study(
    name: Annotated[
        str,
        typer.Argument(
            help="euler-table: Table 1 of Song and Lee; azimuth-hold: the experiment of Kim; sea-state: that of Kang; "
            "float-covariance: what single precision does to a covariance."
        ),
    ],
    runs: Annotated[int, typer.Option(help="Monte Carlo runs of each case.")] = 20,
    seed: Annotated[int, typer.Option(help="Of the random numbers; a run's depend on seed and run alone.")] = 0,
    seconds: Annotated[
        float | None,
        typer.Option(help="Length of a run: 120 for euler-table, 3600 for azimuth-hold, 60 for sea-state."),
    ] = None,
    switch: Annotated[
        list[str] | None, typer.Option(help="euler-table: a departure from the declared scenario; repeat it.")
    ] = None,
    explore: Annotated[
        bool, typer.Option("--explore", help="euler-table, sea-state: everything the documentation counts; minutes.")
    ] = False,
    out: Out = None,
    as_json: AsJson = False,
) -> None:
    """Run an experiment of a paper; euler-table exits 1 where it disagrees with the paper."""
    one_of(name, STUDIES, "study")
    if switch and name != "euler-table":
        raise BoresightError(f"--switch belongs to euler-table; {name} has none")
    if explore and name not in ("euler-table", "sea-state"):
        raise BoresightError(f"--explore belongs to euler-table and sea-state; {name} has none")
    from rich.console import Console

    with Console(stderr=True).status("") as status:

        def progress(line: str) -> None:
            status.update(line)

        fly = {
            "azimuth-hold": azimuth_hold,
            "euler-table": euler_table,
            "float-covariance": float_covariance,
            "sea-state": sea_state,
        }[name]
        result, text, written, good = fly(runs, seed, seconds, tuple(switch or ()), explore, out, progress)
    if as_json:
        print_json(result)
    else:
        for path in written:
            print(f"wrote {path}")
        print(text)
    raise typer.Exit(0 if good else 1)


Flown = tuple[dict[str, Any], str, list[Path], bool]  # result, report, files written, whether all is well


def euler_table(
    runs: int,
    seed: int,
    seconds: float | None,
    switches: tuple[str, ...],
    explore: bool,
    out: Path | None,
    progress: Callable[[str], None],
) -> Flown:
    from boresight.runtime.library import load
    from boresight.studies import euler_exploration, figures
    from boresight.studies import euler_table as table

    library = load("euler-matching")
    if explore:
        result = euler_exploration.explore(library, runs=runs, seed=seed, progress=progress)
        written = [] if out is None else figures.euler_exploration(result, make(out))
        return result, euler_exploration.report(result), written, result["finished"]
    result = table.run(
        library,
        runs=runs,
        seed=seed,
        seconds=120.0 if seconds is None else seconds,
        switches=switches,
        progress=progress,
    )
    written = [] if out is None else figures.euler_figures(result, make(out))
    good = all(result[kind]["agree"] == result["cells"] for kind in ("linear", "monte_carlo"))
    return result, table.report(result), written, good


def azimuth_hold(
    runs: int,
    seed: int,
    seconds: float | None,
    switches: tuple[str, ...],
    explore: bool,
    out: Path | None,
    progress: Callable[[str], None],
) -> Flown:
    from boresight.studies import azimuth_figures
    from boresight.studies import azimuth_hold as hold

    result = hold.run(
        runs=runs,
        seed=seed,
        seconds=3600 if seconds is None else round(seconds),
        histories=out is not None,
        progress=progress,
    )
    written = [] if out is None else azimuth_figures.azimuth_figures(result, make(out))
    return result, hold.report(result), written, True


REPLAYED = ["euler-matching", "velocity-attitude", "velocity-attitude-lever", "azimuth-hold"]


def float_covariance(
    runs: int,
    seed: int,
    seconds: float | None,
    switches: tuple[str, ...],
    explore: bool,
    out: Path | None,
    progress: Callable[[str], None],
) -> Flown:
    from boresight.studies import float_covariance as single

    result = single.run(seed=seed, progress=progress)
    written = [] if out is None else single.float_figures(result, make(out))
    worst = result["worst"]["100 Hz"]
    return result, single.report(result), written, worst["dies_s"] is None and worst["deviation"] < 0.005


def sea_state(
    runs: int,
    seed: int,
    seconds: float | None,
    switches: tuple[str, ...],
    explore: bool,
    out: Path | None,
    progress: Callable[[str], None],
) -> Flown:
    from boresight.studies import sea_claims, sea_exploration, sea_figures
    from boresight.studies import sea_state as sea
    from boresight.studies.sea_flight import Scenario

    if explore:
        shown = sea_exploration.explore(runs=runs, seed=seed, progress=progress)
        varied = sea_claims.explore(runs=runs, seed=seed, progress=progress)
        written = [] if out is None else sea_exploration.exploration_figures(shown, make(out))
        report = f"{sea_exploration.report(shown)}\n{sea_claims.report(varied)}"
        return {"exploration": shown, "claims": varied}, report, written, True
    scenario = Scenario() if seconds is None else Scenario(seconds=round(seconds))
    result = sea.run(runs=runs, seed=seed, scenario=scenario, histories=out is not None, progress=progress)
    written = [] if out is None else sea_figures.sea_figures(result, make(out))
    return result, sea.report(result), written, True


@app.command()
def replay(
    recording: Annotated[str, typer.Argument(help="A recording, or the TOML file that describes one.")],
    model: Annotated[
        str | None,
        typer.Option("--model", help=f"{', '.join(REPLAYED[:3])} with a master, azimuth-hold without one."),
    ] = None,
    check: Annotated[bool, typer.Option("--check", help="Look at the recording and fly nothing.")] = False,
    delay_ms: Annotated[
        float, typer.Option(help="How old the master's data is; velocity-attitude begins there and estimates it.")
    ] = 0.0,
    rate_hz: Annotated[float | None, typer.Option(help="Use the master no more often than this.")] = None,
    measurement: Annotated[
        str, typer.Option(help="euler-matching: euler_exact, or euler as the paper has it.")
    ] = "euler_exact",
    gyro_noise: Annotated[str | None, typer.Option(help='As "0.15 deg/sqrt(h)".')] = None,
    accel_noise: Annotated[str | None, typer.Option(help='As "150 ug/sqrt(Hz)" or "0.1 m/s/sqrt(h)".')] = None,
    gyro_bias: Annotated[str | None, typer.Option(help='One sigma before, as "720 deg/h".')] = None,
    accel_bias: Annotated[str | None, typer.Option(help='One sigma before, as "50 mg".')] = None,
    velocity_noise: Annotated[str | None, typer.Option(help='Master: level and vertical, as "2, 4 mm/s".')] = None,
    attitude_noise: Annotated[str | None, typer.Option(help='Master: level and heading, as "0.1, 0.3 deg".')] = None,
    delay_noise: Annotated[str | None, typer.Option(help='Random walk of the delay, as "0.03 ms/sqrt(s)".')] = None,
    lever_arm: Annotated[
        str | None, typer.Option(help='From master to slave: front, right, down, as "-8, -2, 12 cm".')
    ] = None,
    out: Out = None,
    as_json: AsJson = False,
) -> None:
    """Fly a filter on a recording; exit 1 if its NIS is not consistent.

    With a master that has a velocity: transfer alignment by velocity and attitude, which estimates mounting, biases and
    delay; without one, by Euler angles.  The noises that are not given are chosen by likelihood.  The options from
    gyro-noise on belong to velocity-attitude.  Without a master: stationary detection and zero-velocity updates.  With
    --check: norms, gaps, rates and suspicious units; exit 1 if something is wrong.
    """
    from boresight.runtime.library import load
    from boresight.runtime.recording import read
    from boresight.runtime.units import quantity
    from boresight.studies import replay as matched
    from boresight.studies import transfer_replay, zero_velocity

    if check:
        raise typer.Exit(matched.main(recording, only_check=True, as_json=as_json))
    data = read(recording)
    master = data.master
    fits = "azimuth-hold" if master is None else "euler-matching" if master.v_n is None else "velocity-attitude"
    name = one_of(model or fits, REPLAYED, "model to replay with")
    if (name == "azimuth-hold") != (master is None):
        raise BoresightError(f"{recording} has {'no' if master is None else 'a'} master; replay it with --model {fits}")
    noise, prior = (
        {key: quantity(text, kind, count) for key, text, kind, count in rows if text is not None}
        for rows in (
            (
                ("gyro", gyro_noise, "gyro noise", 1),
                ("accel", accel_noise, "accelerometer noise", 1),
                ("velocity", velocity_noise, "velocity", 2),
                ("attitude", attitude_noise, "angle", 2),
                ("delay", delay_noise, "delay noise", 1),
            ),
            (("gyro_bias", gyro_bias, "angular rate", 1), ("accel_bias", accel_bias, "acceleration", 1)),
        )
    )
    if (noise or prior or lever_arm) and not name.startswith("velocity-attitude"):
        raise BoresightError(f"noises, biases and a lever arm are options of velocity-attitude; {name} takes none")
    folder = None if out is None else str(make(out))
    if name == "azimuth-hold":
        raise typer.Exit(zero_velocity.main(recording, folder=folder, as_json=as_json))
    if name == "euler-matching":
        status = matched.main(
            recording, folder=folder, as_json=as_json, delay=delay_ms * 1e-3, rate_hz=rate_hz, measurement=measurement
        )
        raise typer.Exit(status)
    from rich.console import Console

    with Console(stderr=True).status("") as line:
        result = transfer_replay.run(
            data, load(name), noise=noise, prior={key: float(value[0]) for key, value in prior.items()},
            lever_b=None if lever_arm is None else quantity(lever_arm, "length", 3), delay=delay_ms * 1e-3,
            rate_hz=rate_hz, progress=line.update,
        )  # fmt: skip
    raise typer.Exit(transfer_replay.finish(result, folder=folder, as_json=as_json))


def make(folder: Path) -> Path:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise BoresightError(f"cannot write to {folder} ({error.strerror}); choose another folder with -o") from None
    return folder


def main() -> None:
    """The entry point: a BoresightError becomes one line on standard error and exit status 1."""
    try:
        app()
    except BoresightError as error:
        print(f"boresight: {error}", file=sys.stderr)
        sys.exit(1)
    except KeyboardInterrupt:
        print("boresight: interrupted", file=sys.stderr)
        sys.exit(130)


if __name__ == "__main__":
    main()
