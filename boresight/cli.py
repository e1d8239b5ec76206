"""The command line.  Each command imports what it needs when it runs: start-up stays light."""

import inspect
import json
import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any, NoReturn

from boresight import __version__
from boresight.errors import BoresightError
from boresight.errors import need as require

try:
    import typer
    import typer.core
    from typer.main import get_command_from_info
    from typer.models import CommandInfo
except ModuleNotFoundError:
    sys.exit("boresight: the command line needs more packages; install them with pip install 'boresight[cli]'")


class Commands(typer.core.TyperGroup):
    """Ctrl-C is one line on standard error and exit status 130; typer would end without it."""

    def invoke(self, ctx: Any) -> Any:
        try:
            return super().invoke(ctx)
        except KeyboardInterrupt as error:
            print(f"boresight: interrupted{f'; {error}' if error.args else ''}", file=sys.stderr)
            raise typer.Exit(130) from None


app = typer.Typer(cls=Commands, no_args_is_help=True, rich_markup_mode=None, pretty_exceptions_enable=False)


def model_names() -> list[str]:
    from boresight.runtime.manifest import built_in

    return built_in()


def new_kinds() -> list[str]:
    from boresight.codegen.new import KINDS, PAPER

    return [*KINDS, PAPER]


def paper_names() -> list[str]:
    from boresight.derive.papers import PAPERS

    return list(PAPERS)


def derived_names() -> list[str]:
    from boresight.derive.papers import DERIVATIONS, PAPERS

    return [*PAPERS, *DERIVATIONS]


def completed(*sources: Callable[[], list[str]]) -> Callable[[str], list[str]]:
    """What the shell offers for a word that was begun."""
    return lambda incomplete: [name for source in sources for name in source() if name.startswith(incomplete)]


FORMATS = ["text", "latex", "html", "pdf"]
DERIVED = ["rate", "step"]
AsJson = Annotated[bool, typer.Option("--json", help="Print one JSON document and nothing else.")]
Out = Annotated[Path | None, typer.Option("-o", "--out", help="Folder for results.")]
Generated = Annotated[Path | None, typer.Option("--generated", help="Generated folder of a model of your own.")]
Targets = Annotated[
    list[str] | None,
    typer.Argument(
        metavar="MODEL | FILE.py:NAME",
        help="All built-in models if left out.",
        show_default=False,
        autocompletion=completed(model_names),
    ),
]


def print_json(document: Any) -> None:
    print(json.dumps(document, indent=2, ensure_ascii=False, allow_nan=False))


def counted(number: int, noun: str) -> str:
    return f"{number} {noun}{'s' * (number != 1)}"


def paper_of(name: str) -> str:
    """The name of a paper that there is, or of a folder that holds one."""
    from boresight.derive.papers import is_folder
    from boresight.derive.papers.files import FILES

    if is_folder(name):
        return name
    if Path(name).is_dir():
        raise BoresightError(f"{name} holds no {FILES[0]}; 'boresight new NAME --kind paper' begins a paper")
    return one_of(name, derived_names(), "paper")


def one_of(name: str, known: list[str], what: str, more: str = "") -> str:
    if name not in known:
        raise BoresightError(f"no {what} {name!r}; there are {', '.join(known)}{f'; {more}' * bool(more)}")
    return name


@app.callback(invoke_without_command=True)
def root(version: Annotated[bool, typer.Option("--version", help="Print the version.")] = False) -> None:
    """From the equations of an inertial-navigation filter to C that can be flown."""
    if version:
        print(f"boresight {__version__}")
        raise typer.Exit


@app.command()
def new(
    name: Annotated[
        str, typer.Argument(help="Lower-case words joined by '-'; NAME.py and fly_NAME.py, or a folder NAME.")
    ],
    kind: Annotated[
        str,
        typer.Option(
            help="total-state, flown by f: a pendulum; error-state, with feedback: height and speed aided by a "
            "barometer; ins: GNSS/INS with lever arm and delay, 15 states; paper: a folder with two equations.",
            autocompletion=completed(new_kinds),
        ),
    ] = "total-state",
    out: Annotated[Path, typer.Option("-o", "--out", help="Folder to write to.")] = Path(),
) -> None:
    """Begin a model of your own and its flight, or a paper."""
    from boresight.codegen import new as begin

    model, script = begin.new(name, kind, out)
    if kind == begin.PAPER:
        print(f"{model}, {script}")
        print(f"try 'boresight equations {model.parent}', 'boresight show {model.parent}'; see docs/your-paper.md")
        return
    constant = model.stem.upper()
    print(f"{model}, {script}")
    print(f"try 'boresight generate {model}:{constant}', 'boresight verify {model}:{constant}', 'python {script}'")


@app.command()
def models(
    name: Annotated[
        str | None,
        typer.Argument(metavar="MODEL", help="All if left out.", autocompletion=completed(model_names)),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """The built-in models; with a name, its states and functions."""
    from boresight.runtime.manifest import folder_of, read_manifest

    more = "'boresight show FILE.py:NAME' describes one of your own"
    names = [one_of(name, model_names(), "model", more)] if name else model_names()
    manifests = [read_manifest(folder_of(name)) for name in names]
    if as_json:
        print_json(
            [
                {key: m[key] for key in ("model", "title", "frame", "c_prefix", "states", "measurements")}
                | {"units": {name: unit["operations"] for name, unit in m["units"].items()}}
                for m in manifests
            ]
        )
        return
    from boresight import report, terminal

    terminal.page(*(report.model(manifests[0]) if name else report.models(manifests)))


@app.command()
def equations(
    paper: Annotated[
        str | None,
        typer.Argument(
            metavar="PAPER | FOLDER",
            help="A paper, or a folder with one of your own; all papers if left out.",
            autocompletion=completed(derived_names),
        ),
    ] = None,
    number: Annotated[
        str | None, typer.Argument(metavar="NUMBER", help="Number of one equation, to print its evidence.")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """The computed status of each printed equation, with evidence."""
    from boresight import report, terminal
    from boresight.kept_ledger import equation, functions, ledger

    if paper and number is not None:
        name = paper_of(paper)
        one = equation(name, number.strip("()"), lambda wanted, numbers: one_of(wanted, numbers, "equation"))
        (row,) = one["entries"]
        of = functions().get(f"{name} ({row['number']})", {})
        if as_json:
            print_json([row])
        else:
            terminal.page(*report.equation(row, one["conditions"], [unit for names in of.values() for unit in names]))
        if row["number"] in one["refused"]:
            raise typer.Exit(1)
        return
    papers = [paper_of(paper)] if paper else paper_names()
    with terminal.progress() as progress:
        ledgers = {name: ledger(name, progress) for name in papers}
    rows = {name: kept["entries"] for name, kept in ledgers.items()}
    if as_json:
        print_json([entry for entries in rows.values() for entry in entries])
    elif paper is None:
        terminal.page(*report.equations(rows))
    else:
        terminal.page(*report.paper(paper, rows[paper], ledgers[paper]))
    if any(kept["refused"] for kept in ledgers.values()):
        raise typer.Exit(1)


@app.command()
def show(
    name: Annotated[
        str,
        typer.Argument(
            metavar="MODEL | FILE.py:NAME | PAPER | FOLDER",
            help="A model or a paper, of your own too, or delay-error: what an unknown delay does.",
            autocompletion=completed(model_names, derived_names),
        ),
    ],
    number: Annotated[
        str | None, typer.Argument(metavar="NUMBER", help="Number of one equation; all if left out.")
    ] = None,
    form: Annotated[
        str,
        typer.Option(
            "--format",
            help="text, latex, html or pdf.",
            autocompletion=completed(lambda: FORMATS),
        ),
    ] = "text",
    out: Annotated[Path | None, typer.Option("-o", "--out", help="File to write; needed for pdf.")] = None,
    derived: Annotated[
        str,
        typer.Option(
            help="For an error state: rate prints F, G and H, step prints Phi and Q of a step, as they follow from its "
            "strapdown and feedback and not as the model gives them.",
            autocompletion=completed(lambda: DERIVED),
        ),
    ] = "",
) -> None:
    """Describe a model, or derive the equations of a paper by steps.

    With MODEL NUMBER: the equation of a paper that the model uses.
    """
    from boresight import terminal
    from boresight.derive.papers import is_folder

    own = is_folder(name)
    if ":" not in name and not own:
        from boresight.codegen.generate import COMPONENTS

        if name in COMPONENTS:
            raise BoresightError(f"{name} is C without a model; 'boresight show kim-2018 31' shows its equation")
        if Path(name).is_dir() and name not in model_names():
            paper_of(name)
        from boresight.studies.known import STUDIES

        own_one = "your own is FILE.py:NAME, or the folder of a paper"
        more = f"'boresight study {name}' runs the study of that name" if name in STUDIES else own_one
        one_of(name, [*derived_names(), *model_names()], "paper or model", more)
    one_of(form, FORMATS, "format")
    if derived:
        one_of(derived, DERIVED, "what is derived")
        if number is not None or name in derived_names() or own:
            raise BoresightError("--derived needs a model and no NUMBER; leave it out, or name only a model")
    if form == "pdf" and out is None:
        raise BoresightError("a pdf must be written to a file; add -o FILE.pdf")
    kind = "latex" if form == "pdf" else form
    if name in derived_names() or own:
        from boresight.kept_ledger import page

        text = page(name, number and number.strip("()"), kind, terminal.columns())
    elif number is None:
        from boresight.kept_ledger import model_page

        text = model_page(name, kind, terminal.columns(), derived)
    else:
        text = model_equations(name, number.strip("()"), kind)
    if form == "pdf" and out is not None:
        from boresight.derive.pages.booklet import pdf_from_latex

        write(out, pdf_from_latex(text))
    elif out is not None:
        write(out, text.encode())
    elif form == "text":
        terminal.page_text(terminal.marked(text))
    else:
        sys.stdout.write(text)


def model_equations(name: str, number: str, form: str) -> str:
    """The equations of this number that a model refers to, as `song-lee-2001 (19)`, in one of the formats."""
    from boresight.codegen.generate import load_model
    from boresight.derive.pages.render import render_equations
    from boresight.derive.papers import paper
    from boresight.kept_ledger import functions

    model = load_model(name)
    named = {*model.equations, *(e for part in (*model.measurements, *model.functions) for e in part.equations)}
    if not named:
        raise BoresightError(f"{name} uses no equation of a paper; 'boresight models {name}' prints what it has")
    papers = [paper(name) for name in sorted({text.split(" ")[0] for text in named})]
    known = [(one, e) for one in papers for e in one.equations if f"{e.paper} ({e.number})" in named]
    chosen = [(one, e) for one, e in known if number == e.number]
    if not chosen:
        listed = ", ".join(f"{e.paper} ({e.number})" for _, e in known)
        raise BoresightError(f"{name} is not made from an equation {number}, but from {listed}")
    return render_equations(f"{model.name}: {model.title}", chosen, form, functions())


def write(path: Path, content: bytes) -> None:
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)
    except OSError as error:
        raise BoresightError(f"cannot write {path} ({error.strerror}); choose another file with -o") from None


@app.command()
def generate(
    targets: Targets = None,
    check: Annotated[bool, typer.Option("--check", help="Write nothing; exit 1 if anything would change.")] = False,
    out: Annotated[Path | None, typer.Option("-o", "--out", help="Folder, if there is one model.")] = None,
) -> None:
    """Make the generated C agree with its models; name what changed.

    Exit status with --check: 0 no difference, 1 a difference, 3 if the committed files were made with other versions of
    SymPy or CasADi, so that they cannot be compared.
    """
    from boresight import terminal
    from boresight.codegen import generate as g

    if not targets and not check and not g.is_checkout():
        raise BoresightError(
            "the C of the built-in models is there already; name a model to write its C to ./generated, or your own "
            "as FILE.py:NAME"
        )
    targets = targets or g.target_names()
    if out is not None and len(targets) > 1:
        raise BoresightError("-o is the folder of one model; name only one model")
    status, unchanged, lines = 0, 0, []
    with terminal.progress() as progress:
        for done, target in enumerate(targets):
            progress(done, len(targets), target)
            report = g.generate(target, out, check, tell=lambda line: print(line, file=sys.stderr))
            label = f"{report.model} in {report.folder}"
            if not report.comparable:
                made = ", ".join(f"{k} {v}" for k, v in g.old_manifest(report.folder)["versions"].items())
                here = ", ".join(f"{k} {v}" for k, v in g.versions().items())
                lines.append(f"{label}: not comparable; made with {made}, here are {here}")
                status = max(status, 3)
            elif report.up_to_date or not report.written:
                unchanged += 1
            else:
                verb = "would change" if check else "written"
                lines += [f"  {change}" for change in report.changes]
                differ = f"{counted(len(report.changes), 'function')} differ{'s' * (len(report.changes) == 1)}"
                lines.append(f"{label}: {differ}, {counted(len(report.written), 'file')} {verb}")
                if check:
                    lines += [f"  {path}" for path in report.written]
                    status = max(status, 1)
            if report.strange:
                named = ", ".join(report.strange[:3]) + ", ..." * (len(report.strange) > 3)
                lines.append(f"{label}: not generated, remove or move it: {named}")
    if unchanged:
        lines.append(
            f"{label}: nothing changed" if len(targets) == 1 else f"nothing changed in {counted(unchanged, 'model')}"
        )
    print("\n".join(lines))
    raise typer.Exit(status)


@app.command()
def diff(
    target: Annotated[
        str | None,
        typer.Argument(
            metavar="MODEL | FILE.py:NAME | FOLDER",
            help="A model, or a folder with a paper of your own; all built-in models if left out.",
            show_default=False,
            autocompletion=completed(model_names),
        ),
    ] = None,
    against: Annotated[
        str, typer.Option(metavar="REVISION | DIR", help="A revision of git, or another generated folder.")
    ] = "HEAD",
    form: Annotated[
        str, typer.Option("--format", help="text, latex or html.", autocompletion=completed(lambda: FORMATS[:3]))
    ] = "text",
    out: Annotated[Path | None, typer.Option("-o", "--out", help="File to write.")] = None,
    studied: Annotated[
        str | None,
        typer.Option(
            "--study",
            metavar="'NAME ...'",
            help="Run this study, with its options, in the revision and in the present source.",
            show_default=False,
        ),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Show what an edit changed, in a model or a paper of your own.

    Compares the present source with the equations.json that was committed with the generated C.  Prints entries of F,
    f, G, Q, z, h, H and functions before and after, with the largest difference of their values over the box; then
    states and inputs, operations and code size.  Exits 1 if something differs.
    """
    from boresight import terminal
    from boresight.codegen import difference as d
    from boresight.codegen.difference_page import differences_page
    from boresight.derive.pages.render import write as written
    from boresight.derive.papers import is_folder

    one_of(form, FORMATS[:3], "format")
    if target and is_folder(target):
        paper_diff(target, against, as_json)
    flown = None
    if studied is not None:
        from boresight.side_by_side import both_flown, report

        with terminal.working() as working:
            flown = both_flown(studied, against, working)
    targets = [target] if target else model_names()
    with terminal.progress() as progress:
        found = []
        for done, name in enumerate(targets):
            progress(done, len(targets), name)
            found.append(d.difference(name, against))
    if as_json:
        print_json({"models": [d.to_json(one) for one in found], "study": flown})
    else:
        text = written(differences_page(found), form)
        if out is not None:
            write(out, text.encode())
        elif form == "text":
            terminal.page_text(terminal.marked(text))
        else:
            sys.stdout.write(text)
        if flown is not None:
            terminal.page(*report(flown, against))
    same = all(one.same for one in found) and (flown is None or flown["before"] == flown["after"])
    raise typer.Exit(0 if same else 1)


def paper_diff(folder: str, against: str, as_json: bool) -> NoReturn:
    from boresight import terminal
    from boresight.codegen.revision import paper_as_of
    from boresight.derive.papers.edits import changed, lines, statuses

    with paper_as_of(Path(folder), against) as before:
        old, new = statuses(before), statuses(Path(folder))
    if as_json:
        print_json(changed(old, new))
    else:
        terminal.page_text("\n".join([*lines(old, new)] or [f"{folder}: the same statuses"]) + "\n")
    raise typer.Exit(0 if old == new else 1)


@app.command()
def watch(
    target: Annotated[
        str,
        typer.Argument(
            metavar="MODEL | FILE.py:NAME | FOLDER", show_default=False, autocompletion=completed(model_names)
        ),
    ],
) -> None:
    """Check a model, or a paper of your own, after each save.

    Prints what differs from the last correct state and whether exact mechanics agrees, then generates; of a paper,
    which statuses have changed.  An error in the file is reported in one line.  Ctrl-C ends it.
    """
    from boresight import terminal
    from boresight.codegen.watch import watch as look

    look(target, lambda text: print(terminal.marked(text), flush=True))


@app.command()
def verify(
    targets: Targets = None,
    folder: Generated = None,
    strict: Annotated[
        bool, typer.Option("--strict", help="Count what a model lists as unheld as not checked.")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Check the C, and compare the model with exact mechanics.

    The C must have CasADi's bits, and agree with 50 digits within rounding.  A function with which nothing exact can be
    compared is 'not checked', unless the model lists it with a reason.  Exit status: 0 all passed, 1 something is
    wrong, 3 nothing is wrong but not all was checked.
    """
    from boresight import report, terminal
    from boresight.codegen import generate as g
    from boresight.codegen import verify as v

    targets = targets or g.model_names()
    if folder is not None and len(targets) > 1:
        raise BoresightError("--generated is the folder of one model; name only one model")
    for target in targets:
        if target.endswith(".py"):
            g.known(target, g.model_names())  # which names the models in it
    folders = {target: g.generated_folder(target, folder) if ":" in target else folder for target in targets}
    with terminal.progress() as progress:
        checks = v.verify_all(list(folders.items()), progress=progress)
    if as_json:
        print_json(v.to_json(checks))
    else:
        # where C fails that was made of an earlier equation, this is why
        failed = any(isinstance(check, v.UnitCheck) and not check.ok for check in checks)
        old = [target for target, where in folders.items() if failed and not g.unchanged(target, where)]
        *parts, verdict = report.verified(checks)
        hints = (f"The C is not of {target} as it is now; 'boresight generate {target}' makes it." for target in old)
        terminal.page(*parts, *hints, verdict)
    raise typer.Exit(v.status(checks, strict))


Form = Annotated[
    str,
    typer.Option(
        help="joseph or ud: only this form of the covariance; by default both, double flies joseph, float ud.",
        autocompletion=completed(lambda: ["joseph", "ud"]),
    ),
]
Only = Annotated[
    str,
    typer.Option(metavar="MEASUREMENT,...", help="Only these measurements, without the others."),
]


def listed(names: str) -> tuple[str, ...]:
    """Those between commas."""
    return tuple(name for name in names.replace(" ", "").split(",") if name)


@app.command()
def export(
    target: Annotated[
        str,
        typer.Argument(metavar="MODEL | FILE.py:NAME", show_default=False, autocompletion=completed(model_names)),
    ],
    out: Annotated[Path, typer.Option("-o", "--out", help="The new folder.", show_default=False)],
    precision: Annotated[
        str,
        typer.Option(
            help="double, or float with the covariance as UD factors.",
            autocompletion=completed(lambda: ["double", "float"]),
        ),
    ] = "double",
    folder: Generated = None,
    box: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME=LOW:HIGH",
            help="Another box of a component of an input or a state, in its unit; may be repeated.  The hash changes, "
            "and there is no evidence of it.",
        ),
    ] = None,
    places: Annotated[
        str,
        typer.Option(
            "--for",
            metavar="PLACE,...",
            help="Add files for other build tools: arduino, platformio, idf, zephyr, px4.",
        ),
    ] = "",
    form: Form = "",
    only: Only = "",
    against: Annotated[
        Path | None,
        typer.Option(
            metavar="OLD",
            help="Print what changed in flash, RAM, stack, instructions since this exported folder, as Markdown.",
        ),
    ] = None,
) -> None:
    """Write a folder of C that needs nothing of Python.

    It holds the functions, the filter of a model that has one with an example, their self-test, a Makefile, a CMake
    package and pkg-config; LICENSE, sbom.json, manifest.json with hashes; the evidence of exactly this C, as
    EVIDENCE.html and evidence.json; trace.csv and trace-back.csv, from each numbered requirement to its equations,
    statements, tests and results, and back.
    """
    from boresight.codegen.export import export as export_model

    if against:
        require("evidence")
        from boresight.evidence.against import against as compared
        from boresight.evidence.against import exported

        exported(against)
    written = export_model(target, out, precision, folder, tuple(box or ()), listed(places), listed(only), form)
    if written.warning:
        print(f"boresight: {written.warning}", file=sys.stderr)
    goals = "test example" if out / "example" / "main.c" in written.files else "test"
    print(f"{counted(len(written.files), 'file')} in {out}; try 'make -C {out} {goals}'")
    if against:
        print(f"\n{compared(against, out)}")


@app.command()
def evidence(
    target: Annotated[
        str,
        typer.Argument(metavar="MODEL | FILE.py:NAME", show_default=False, autocompletion=completed(model_names)),
    ],
    quick: Annotated[
        bool,
        typer.Option(
            "--quick",
            help="Make only what takes some 3 minutes: no mutants, Eva, hostile calls or verify; of more than 6 states "
            "no emulated Cortex-M.",
        ),
    ] = False,
    folder: Annotated[Path | None, typer.Option("--generated", help="Its generated folder.")] = None,
    form: Form = "",
    only: Only = "",
) -> None:
    """Make the evidence of your own model, or of a part of one.

    A part is one form of the covariance, or some measurements, as `export` writes it; of a built-in model too.

    Uses the tools that are installed.  Each kind of evidence is kept with a hash of its C, and made again only if this
    changes: the self-test on emulated cores, its coverage with MC/DC, bad input, stack of each entry point, rounding,
    MISRA, mutants, hostile calls and verify.
    """
    require("evidence")
    from boresight.evidence.own import make_own

    make_own(target, quick, folder, listed(only), form)


Svg = Annotated[bool, typer.Option("--svg", help="Figures as SVG, for a paper, and not as PNG.")]


class StudyCommand(typer.core.TyperCommand):
    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        try:
            return super().parse_args(ctx, args)
        except Exception as error:
            if type(error).__name__ != "NoSuchOption":
                raise
            known = ", ".join(option.opts[-1] for option in self.params)
            raise BoresightError(f"study {self.name} takes no {error.option_name}; there are {known}") from None  # type: ignore[attr-defined]


class Studies(typer.core.TyperGroup):
    """A command for each study, made of its scenario's options when it is asked for."""

    def list_commands(self, ctx: Any) -> list[str]:
        from boresight.studies.known import names

        return names()

    def format_epilog(self, ctx: Any, formatter: Any) -> None:
        from boresight.studies.known import STUDIES, elsewhere

        if elsewhere():
            with formatter.section("In the checkout"):
                formatter.write_dl([(name, STUDIES[name]) for name in elsewhere()])

    def get_command(self, ctx: Any, name: str) -> Any:
        from boresight.studies.known import STUDIES, study

        one = study(name)

        def command(out: Path | None, svg: bool, as_json: bool, seeds: int | None = None, **chosen: Any) -> None:
            chosen = {
                key: tuple(value or ()) if isinstance(value, list | None) else value for key, value in chosen.items()
            }
            fly(one, one.scenario(**chosen), out, svg, as_json, seeds)

        def asked(name: str, kind: Any, default: Any) -> inspect.Parameter:
            return inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, annotation=kind, default=default)

        options = [
            asked(
                option.name,
                Annotated[
                    list[str] if option.type == tuple[str, ...] else option.type,
                    typer.Option(help=option.metadata["help"]),
                ],
                option.default if option.default != () else None,
            )
            for option in one.options()
        ]
        if one.claims is not None:
            options.append(
                asked(
                    "seeds",
                    Annotated[
                        int | None, typer.Option(help="Fly so many seeds from --seed on; print each claim as a band.")
                    ],
                    None,
                )
            )
        parameters = [*options, asked("out", Out, None), asked("svg", Svg, False), asked("as_json", AsJson, False)]
        command.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
        command.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters}
        info = CommandInfo(name, cls=StudyCommand, callback=command, help=STUDIES[name], short_help=STUDIES[name])
        return get_command_from_info(info, pretty_exceptions_short=True, rich_markup_mode=None)


def no_study() -> None:
    """Run the experiment of a paper, or one of our own.  Exits 1 if a study's own criterion is not met."""


app.add_typer(typer.Typer(cls=Studies, callback=no_study, no_args_is_help=True, rich_markup_mode=None), name="study")


def fly(one: Any, scenario: Any, out: Path | None, svg: bool, as_json: bool, seeds: int | None = None) -> None:
    """Run a study, print it, draw it; exits 0 if all is well."""
    from boresight import terminal
    from boresight.analysis.figures import Sheets
    from boresight.studies import study as s

    if out is not None:
        require("replay")  # for the figures; said before the flight and not after it
        make(out)
    with terminal.working() as progress:
        if seeds is not None:
            document = s.over_seeds(one, scenario, seeds, progress)
            good, text = True, s.seeds_report(document)
        else:
            result = one.run(scenario, progress)
            good, text = one.good(result), one.report(result)
            sheets = Sheets(out or Path(), one.made_from(scenario), svg)
            if out is not None and one.figures is not None:
                progress("figures")
                one.figures(result, sheets)
            document = s.document(one, scenario, result, sheets.written)
            if sheets.written:
                text += "".join(f"\n{'- ' * one.markdown}wrote {path}" for path in sheets.written)
    if as_json:
        print_json(document)
    elif one.markdown:
        terminal.page_markdown(text)
    else:
        terminal.page_text(text + "\n")
    raise typer.Exit(0 if good else 1)


def library_of(target: str, folder: Path | None, grade: str | None) -> Any:
    """The compiled model; of a grade, of velocity and attitude, the one that has states for it."""
    from boresight.runtime.library import load

    if ":" in target:
        from boresight.codegen.generate import generated_folder

        return load(generated_folder(target, folder))
    from boresight.runtime.transfer.sensors import MODEL

    name = one_of(target, model_names(), "model")
    return load(MODEL if grade is not None and name.startswith("velocity-attitude") else name)


def motion_names() -> list[str]:
    from boresight.runtime.simulation.motions import MOTIONS

    return list(MOTIONS)


Target = Annotated[
    str, typer.Argument(metavar="MODEL | FILE.py:NAME", show_default=False, autocompletion=completed(model_names))
]
Seconds = Annotated[float, typer.Option("--seconds", help="How long.")]
StepHz = Annotated[float, typer.Option("--step-hz", help="Predictions per second.")]
UpdateHz = Annotated[float, typer.Option("--update-hz", help="Measurements per second.")]
Grade = Annotated[
    str | None,
    typer.Option(
        "--grade", help="Sizes of scale factors, axes and instability: mems, industrial, tactical, navigation."
    ),
]
Sizes = Annotated[
    list[str] | None,
    typer.Option("--set", help='A size, as "gyro_noise 0.1 deg/sqrt(h)", "dcm 0.2 mrad" or "dmu 1, 1, 3 deg".'),
]
MOTION = (
    'As "s turn" or "sea 4"; a recording; or a function of your own that is called with the model and returns P0 and '
    "steps, and x for a total state."
)


@app.command()
def budget(
    target: Target,
    motion: Annotated[
        str,
        typer.Option(
            metavar="NAME | RECORDING.toml | FILE.py:NAME",
            help=MOTION,
            autocompletion=completed(motion_names),
        ),
    ] = "s turn",
    seconds: Seconds = 60.0,
    step_hz: StepHz = 10.0,
    update_hz: UpdateHz = 1.0,
    grade: Grade = None,
    set_: Sizes = None,
    believe: Annotated[
        list[str] | None,
        typer.Option(help="What the filter assumes instead, in the same words; or FILE.py:NAME, as with --motion."),
    ] = None,
    consider: Annotated[
        list[str] | None, typer.Option(help="States, or a block of them, that no measurement corrects.")
    ] = None,
    estimate: Annotated[
        bool,
        typer.Option(
            "--estimate", help="With --grade: estimate scale factors and axes, which otherwise are considered."
        ),
    ] = False,
    omit: Annotated[list[str] | None, typer.Option(help="States, or a block, that the filter does not have.")] = None,
    uncertain: Annotated[
        list[str] | None,
        typer.Option(help='One sigma of a constant that is not estimated, as "lever_b 1 cm" or "dcm 0.1 mrad".'),
    ] = None,
    offset: Annotated[
        list[str] | None, typer.Option(help="The same for a constant with a known value, which the filter ignores.")
    ] = None,
    need: Annotated[
        str | None, typer.Option(help='As "heading 0.3 mrad": which source must be smaller, and by which factor.')
    ] = None,
    against: Annotated[
        Path | None, typer.Option(help="Another design: a file with its --json output.", show_default=False)
    ] = None,
    at: Annotated[list[float] | None, typer.Option(help="A time to print, s; the end if none.")] = None,
    state: Annotated[list[str] | None, typer.Option(help="A state to print and to draw; all if none.")] = None,
    folder: Generated = None,
    out: Out = None,
    svg: Svg = False,
    as_json: AsJson = False,
) -> None:
    """Split a filter's error by source, along a nominal motion.

    Prints, to first order and without random numbers, the true sigma of each state by each noise, each part of the
    start and each constant, and the filter's own sigma.  With -o also writes budget.csv, budget.json and a figure.
    Exits 1 if a --need is not met.
    """
    from boresight import terminal
    from boresight.analysis import nominal
    from boresight.analysis.budget import budget as split
    from boresight.analysis.figures import Sheets

    if estimate and not grade:
        raise BoresightError("--estimate is of scale factors and axes; give a --grade, which has them")
    if out is not None:
        require("replay")
        make(out)
    library = library_of(target, folder, grade)
    how: dict[str, Any] = {
        "uncertain": nominal.sizes(uncertain or (), library, negative=False),
        "offsets": nominal.sizes(offset or (), library, negative=True),
        "considered": [*(consider or ()), *(nominal.CALIBRATION if grade and not estimate else ())],
        "omitted": omit,
    }
    own, left = ".py:" in motion, []
    functions = [word for word in believe or () if ".py:" in word]
    if own and (set_ or grade or len(believe or ()) > 1 or functions != (believe or [])):
        raise BoresightError(
            f"{motion} returns the sizes; change them there, and give --believe one function FILE.py:NAME"
        )
    if functions and not own:
        raise BoresightError(f"--believe {functions[0]} needs a --motion FILE.py:NAME; give sizes by name")
    if own:
        start, steps, how["x"] = own_flight(motion, library)
        if believe:
            how["believed"] = own_flight(believe[0], library)[:2]
    else:
        given = nominal.settings(library, grade) | nominal.sizes(set_ or (), library)
        along = nominal.named_or_recorded(library, motion, seconds, step_hz, update_hz)
        start, steps = nominal.flight(library, along, given)
        if believe:
            how["believed"] = nominal.flight(library, along, given | nominal.sizes(believe, library))
        left = nominal.not_taken(library, given)
    with terminal.working() as working:
        working("each source along the motion")
        found = split(library, start, steps, **how)
        state, needed = [found.states[i] for name in state or () for i in found.places(name)], None
        if need is not None:
            wanted, _, size = need.strip().partition(" ")
            unit = found.units[found.state(wanted)]
            working(f"which source must be smaller, for {need}")
            needed = found.need(wanted, float(nominal.amount(size, unit, need)[0]))
    title = f"{library.name}, {motion}, {found.times[-1]:g} s"
    document = found.document(at or ()) | {"motion": motion, "need": needed, "not_flown": left}
    text = found.report(at or (), state, title) + nominal.not_taken_line(left, library)
    if needed is not None:
        text += "\n" + found.need_report(needed)
    if against is not None:
        chosen = needed["state"] if needed else state[0] if state else None
        text += "\n" + found.beside(other_design(against), str(against), chosen)
    if out is not None:
        sheets = Sheets(out, f"boresight {__version__}, {title}", svg)
        drawn = state or ([needed["state"]] if needed else [])
        found.draw(sheets, drawn, needed["limit"] if needed and drawn[:1] == [needed["state"]] else None)
        sheets.text("budget.csv", found.csv(at or ()))
        sheets.text("budget.json", json.dumps(document, indent=2, allow_nan=False) + "\n")
        text += "".join(f"wrote {path}\n" for path in sheets.written)
    if as_json:
        print_json(document)
    else:
        terminal.page_text(text)
    raise typer.Exit(1 if needed is not None and not needed["met"] else 0)


def own_flight(target: str, library: Any) -> tuple[Any, Any, Any]:
    """P0, steps and x, or None, of a function FILE.py:NAME that is called with the model."""
    from boresight.codegen.generate import source_of
    from boresight.derive import user_file

    path = source_of(target)
    assert path is not None
    function = getattr(user_file.run(path), target.rsplit(":", 1)[1], None)
    if not callable(function):
        raise BoresightError(f"{target} is no function; name one that is called with the model and returns P0, steps")
    try:
        made = function(library)
    except BoresightError:
        raise
    except Exception as error:
        user_file.explain(error, path)
    if not isinstance(made, tuple) or len(made) not in (2, 3):
        raise BoresightError(f"{target} returned {type(made).__name__}; it must return P0, steps, or P0, steps, x")
    return made if len(made) == 3 else (*made, None)


def other_design(path: Path) -> Any:
    """What `budget --json` printed of another design."""
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
        if (
            not isinstance(document, dict)
            or not {"states", "sources", "whole_sigma", "sigma", "mean", "times_s"} <= document.keys()
        ):
            raise ValueError("it is no error budget")
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else error
        raise BoresightError(
            f"{path} cannot be compared ({reason}); write it with 'boresight budget ... --json'"
        ) from None
    return document


@app.command()
def many(
    out: Annotated[
        str | None,  # a Path of nothing would be the current folder
        typer.Option("-o", "--out", metavar="<path>", help="Folder that keeps every run; a second call continues it."),
    ] = None,
    runs: Annotated[int, typer.Option(help="Largest number of runs.")] = 10_000,
    seed: Annotated[
        int, typer.Option(help="Seed of the random numbers; those of a run depend only on seed and run.")
    ] = 0,
    motion: Annotated[str, typer.Option(help="wave, slope or sea, as in 'study sea-state'.")] = "sea",
    grade: Annotated[int, typer.Option(help="Sea state, 1 to 6.")] = 4,
    within: Annotated[
        float | None,
        typer.Option(
            help="End when the 95 % limit of the heading error is known to plus or minus this many mil.",
            show_default=False,
        ),
    ] = None,
    jobs: Annotated[int, typer.Option(help="Processes.")] = 1,
    dask: Annotated[
        str | None, typer.Option(help="Address of a Dask scheduler, whose workers do the runs.", show_default=False)
    ] = None,
    device: Annotated[
        str, typer.Option(help="cpu, or gpu: one thread of an NVIDIA GPU for each run, with the same SHA-256.")
    ] = "cpu",
    chunk: Annotated[
        int | None, typer.Option(help="Runs per call, or per launch of a GPU.", show_default=False)
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Fly a transfer alignment at sea in very many runs.

    Prints percentiles of the heading error and whether the filter is consistent.  The result depends only on the number
    of runs, motion, grade and seed, and its SHA-256 is printed.  With a folder, no finished run is lost by Ctrl-C.
    Exits 1 if --within was not reached.
    """
    from boresight import terminal
    from boresight.runtime import runs as r
    from boresight.studies.sea_state import many as sea

    for extra, asked in (("parquet", out), ("cluster", dask), ("gpu", device == "gpu")):
        if asked:
            require(extra)  # before the C of the model is compiled
    flown = sea.experiment(sea.Sea(motion, grade))
    goal = None if within is None else r.Goal("heading_mil", within)
    with terminal.progress() as progress:
        found = r.many(
            flown, runs=runs, seed=seed, chunk=chunk, jobs=jobs, dask=dask, device=device, directory=out, goal=goal,
            progress=progress,
        )  # fmt: skip
    if as_json:
        print_json(found.document())
    else:
        terminal.page_text(found.report() + "\n")
    raise typer.Exit(1 if found.reached is False else 0)


REPLAYED = ["euler-matching", "velocity-attitude", "velocity-attitude-lever", "azimuth-hold"]


@app.command()
def replay(
    recording: Annotated[
        str | None, typer.Argument(help="A recording, or the TOML file that describes one.", show_default=False)
    ] = None,
    example: Annotated[
        bool,
        typer.Option("--example", help="Take the recording that comes with Boresight, which is simulated."),
    ] = False,
    template: Annotated[
        bool, typer.Option("--template", help="Print a description of the recording, to be filled in, and end.")
    ] = False,
    model: Annotated[
        str | None,
        typer.Option(
            "--model",
            help=f"{', '.join(REPLAYED[:3])} with a master, azimuth-hold without one.",
            autocompletion=completed(lambda: REPLAYED),
        ),
    ] = None,
    check: Annotated[bool, typer.Option("--check", help="Check the recording, and fly nothing.")] = False,
    begin: Annotated[
        str | None, typer.Option("--from", help='Begin here: "12.5 s" as --check shows it, or a date.')
    ] = None,
    end: Annotated[str | None, typer.Option("--to", help="End here.")] = None,
    bridge: Annotated[str | None, typer.Option(help='Fill gaps up to this length, as "20 ms".')] = None,
    regular_clock: Annotated[
        bool, typer.Option("--regular-clock", help="The slave's samples are regular; only their tags scatter.")
    ] = False,
    allow: Annotated[
        list[str] | None, typer.Option(help="Allow an error of --check, by its name; may be repeated.")
    ] = None,
    delay_ms: Annotated[
        float, typer.Option(help="How old the master's data is; velocity-attitude begins there and estimates it.")
    ] = 0.0,
    rate_hz: Annotated[float | None, typer.Option(help="Use the master no more often than this.")] = None,
    measurement: Annotated[
        str, typer.Option(help="euler-matching: euler_exact, or euler as the paper has it.")
    ] = "euler_exact",
    gyro_noise: Annotated[str | None, typer.Option(help='As "0.15 deg/sqrt(h)".')] = None,
    accel_noise: Annotated[str | None, typer.Option(help='As "150 ug/sqrt(Hz)" or "0.1 m/s/sqrt(h)".')] = None,
    gyro_bias: Annotated[str | None, typer.Option(help='Initial sigma, as "720 deg/h".')] = None,
    accel_bias: Annotated[str | None, typer.Option(help='Initial sigma, as "50 mg".')] = None,
    velocity_noise: Annotated[str | None, typer.Option(help='Master: level and vertical, as "2, 4 mm/s".')] = None,
    attitude_noise: Annotated[str | None, typer.Option(help='Master: level and heading, as "0.1, 0.3 deg".')] = None,
    delay_noise: Annotated[str | None, typer.Option(help='Random walk of the delay, as "0.03 ms/sqrt(s)".')] = None,
    with_: Annotated[
        list[str] | None,
        typer.Option(
            "--with",
            help='Errors that the filter also models, as "scale 1000 ppm", "axes 1 mrad" or "bending 2 mrad 0.1 Hz".',
        ),
    ] = None,
    grade: Grade = None,
    estimate: Annotated[
        bool, typer.Option("--estimate", help="Estimate scale factors and axes, which otherwise are considered.")
    ] = False,
    gyro_instability: Annotated[
        str | None, typer.Option(help='Of the gyro biases, as "3 deg/h"; if not given, chosen as a random walk.')
    ] = None,
    accel_instability: Annotated[str | None, typer.Option(help='Of the accelerometer biases, as "50 ug".')] = None,
    correlation: Annotated[str | None, typer.Option(help='Correlation time of both instabilities, as "300 s".')] = None,
    lever_arm: Annotated[
        str | None, typer.Option(help='From master to slave: front, right, down, as "-8, -2, 12 cm".')
    ] = None,
    smooth: Annotated[
        bool, typer.Option("--smooth", help="velocity-attitude: also estimate each instant from all messages.")
    ] = False,
    out: Out = None,
    svg: Svg = False,
    as_json: AsJson = False,
) -> None:
    """Fly a filter on a recording.

    Exits 1 if the NIS is not consistent.  With a master that has a velocity: transfer alignment by velocity and
    attitude, which estimates mounting, biases and delay; without one, by Euler angles.  The noises that are not given
    are chosen by likelihood.  The options from gyro-noise on belong to velocity-attitude.  Without a master: stationary
    detection and zero-velocity updates.  With --check: norms, gaps, rates and suspicious units; exits 1 if something is
    wrong.
    """
    from boresight.runtime.recording import read
    from boresight.runtime.recording.check import shown
    from boresight.runtime.recording.read import EXAMPLE
    from boresight.runtime.recording.read import template as description
    from boresight.runtime.units import quantity
    from boresight.studies.replays import euler_matching as matched
    from boresight.studies.replays import velocity_attitude as transfer_replay
    from boresight.studies.replays import zero_velocity
    from boresight.studies.study import Replay

    if example:
        if recording is not None:
            raise BoresightError(f"--example is a recording already; leave out {recording}, or --example")
        recording = str(EXAMPLE)
    if template:
        sys.stdout.write(description(recording))
        raise typer.Exit
    if recording is None:
        raise BoresightError("no recording is named; 'boresight replay --template' shows how one is described")
    data = read(
        recording, strict=not check, begin=begin, end=end, bridge=bridge, regular=regular_clock, allow=allow or ()
    )
    if check:
        raise typer.Exit(shown(data, as_json=as_json))
    master = data.master
    by_velocity = "velocity-attitude-lever" if lever_arm is None else "velocity-attitude"
    fits = "azimuth-hold" if master is None else "euler-matching" if master.v_n is None else by_velocity
    more = "one of your own flies in Python: docs/how-to/my-log-my-model.md"
    name = one_of(model or fits, REPLAYED, "model to replay with", more)
    if (name == "azimuth-hold") != (master is None):
        raise BoresightError(f"{recording} has {'no' if master is None else 'a'} master; replay it with --model {fits}")
    # of the description, where an option does not say otherwise
    described = data.noise if name.startswith("velocity-attitude") else {}
    gyro_noise, accel_noise = gyro_noise or described.get("gyro"), accel_noise or described.get("accel")
    velocity_noise = velocity_noise or described.get("velocity")
    attitude_noise = attitude_noise or described.get("attitude")
    delay_noise, correlation = delay_noise or described.get("delay"), correlation or described.get("correlation")
    gyro_instability = gyro_instability or described.get("gyro_instability")
    accel_instability = accel_instability or described.get("accel_instability")
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
    if smooth and not name.startswith("velocity-attitude"):
        raise BoresightError(f"--smooth is an option of velocity-attitude; leave it out with {name}")
    options = (with_, grade, gyro_instability, accel_instability, correlation)
    if (estimate or any(options)) and not name.startswith("velocity-attitude"):
        raise BoresightError(f"sizes of the sensors' errors are options of velocity-attitude; {name} takes none")
    sensors = None
    if estimate or any(options):
        import numpy as np

        from boresight.runtime.transfer.sensors import MODEL, Sensors, sized

        sensors = sized(with_ or (), grade, gyro_instability, accel_instability, correlation, estimated=estimate)
        # what is told of an instability, if only that there is none, is not looked for
        walks = (("gyro_walk", gyro_instability), ("accel_walk", accel_instability))
        noise |= {walk: np.zeros(1) for walk, text in walks if text}
        sensors, name = (None, name) if sensors == Sensors() else (sensors, MODEL)
    settings: dict[str, Any] = {}
    if name == "azimuth-hold":
        one, settings = zero_velocity.STUDY, dict(data.stops)
    elif name == "euler-matching":
        one = matched.STUDY
        settings = {"delay": delay_ms * 1e-3, "rate_hz": rate_hz, "measurement": measurement}
    else:
        one = transfer_replay.study(name)
        # What is told of scale factors and axes stands, if only that there are none.
        if grade or any(word.strip().startswith(("scale", "axes")) for word in with_ or ()):
            settings["assumed"] = None
        settings |= {
            "noise": noise, "prior": {key: float(value[0]) for key, value in prior.items()},
            "lever_b": None if lever_arm is None else quantity(lever_arm, "length", 3), "delay": delay_ms * 1e-3,
            "rate_hz": rate_hz, "sensors": sensors, "grade": grade, "smooth": smooth,
        }  # fmt: skip
    fly(one, Replay(data, settings), out, svg, as_json)


@app.command()
def observe(
    target: Target,
    motion: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME | RECORDING.toml | FILE.py:NAME",
            help=f"{MOTION}  May be repeated.",
            autocompletion=completed(motion_names),
        ),
    ] = None,
    seconds: Seconds = 60.0,
    step_hz: StepHz = 10.0,
    update_hz: UpdateHz = 1.0,
    grade: Grade = None,
    set_: Sizes = None,
    formulas: Annotated[
        bool,
        typer.Option(
            "--formulas",
            help="Also print what is never observable on straight lines and in steady turns, by SymPy; slow.",
        ),
    ] = False,
    folder: Generated = None,
    out: Out = None,
    svg: Svg = False,
    as_json: AsJson = False,
) -> None:
    """Show which motion makes which state observable, and how soon.

    Prints the sigma of each state at the end divided by that at the start, by the covariance along the true motion,
    with a column for each motion (still, straight, steady turn and s turn if none is named), and the direction with the
    largest remaining sigma, in words.  With -o also writes observe.json and a figure.
    """
    from boresight import terminal
    from boresight.analysis import nominal, observability
    from boresight.analysis.figures import Sheets

    if out is not None:
        require("replay")  # for the figure; said before the flight and not after it
        make(out)
    library = library_of(target, folder, grade)
    found, left = {}, []
    measured: set[str] = set()
    with terminal.working() as working:
        for name in motion or ["still", "straight", "steady turn", "s turn"]:
            working(name)
            if ".py:" in name:
                if set_ or grade:
                    raise BoresightError(f"{name} returns the sizes; change them there")
                start, steps, x = own_flight(name, library)
            else:
                along = nominal.named_or_recorded(library, name, seconds, step_hz, update_hz)
                sizes = nominal.settings(library, grade) | nominal.sizes(set_ or (), library)
                (start, steps), x = nominal.flight(library, along, sizes), None
                left = nominal.not_taken(library, sizes)
            steps = list(steps)
            found[name] = observability.observe(library, start, steps, x=x)
            measured |= {step[0] for step in steps if isinstance(step, tuple)}
    text = observability.report(found) + nominal.not_taken_line(left, library)
    shown = {name: one.document() for name, one in found.items()}
    document = {"model": library.name, "motions": shown, "not_flown": left}
    if formulas:
        from boresight.analysis.symbolic import never_shown
        from boresight.codegen.generate import load_model

        model = load_model(library.name if library.name in model_names() else target)
        directions = never_shown.never_shown(model, measured=measured)
        document["never_shown"] = never_shown.document(directions)
        text += "\n" + never_shown.lines(directions)
    if out is not None:
        sheets = Sheets(out, f"boresight {__version__}, {library.name}", svg)
        observability.draw(found, sheets)
        sheets.text("observe.json", json.dumps(document, indent=2, allow_nan=False) + "\n")
        text += "".join(f"wrote {path}\n" for path in sheets.written)
    if as_json:
        print_json(document)
    else:
        terminal.page_text(text)


@app.command()
def noise(
    log: Annotated[
        str | None,
        typer.Argument(
            help="A log at rest: a recording, or its description in TOML.  With --model: the folder of a Record.",
            show_default=False,
        ),
    ] = None,
    model: Annotated[
        str | None,
        typer.Option(
            metavar="MODEL | FILE.py:NAME",
            help="The model of the flight in LOG, whose noises are then found.",
            show_default=False,
            autocompletion=completed(model_names),
        ),
    ] = None,
    folder: Annotated[Path | None, typer.Option("--generated", help="Generated folder of a model of your own.")] = None,
    datasheet: Annotated[
        str | None,
        typer.Option(help='In place of a log, a line of a datasheet, as "ARW 0.15 deg/rt-hr".', show_default=False),
    ] = None,
    rate: Annotated[
        str | None, typer.Option(help='With --datasheet: rate of a sigma per sample, as "100 Hz".', show_default=False)
    ] = None,
    correlation: Annotated[
        str | None, typer.Option(help='With --datasheet: correlation time of a bias, as "300 s".', show_default=False)
    ] = None,
    begin: Annotated[str | None, typer.Option("--from", help='Begin here, as "60 s", or a date.')] = None,
    end: Annotated[str | None, typer.Option("--to", help="End here.")] = None,
    bridge: Annotated[str | None, typer.Option(help='Fill gaps up to this length, as "20 ms".')] = None,
    regular_clock: Annotated[
        bool, typer.Option("--regular-clock", help="The samples are regular; only their tags scatter.")
    ] = False,
    allow: Annotated[
        list[str] | None, typer.Option(help="Allow an error of the check, by its name; may be repeated.")
    ] = None,
    out: Out = None,
    svg: Svg = False,
    as_json: AsJson = False,
) -> None:
    """Find a unit's noises from a log at rest, or those of a flight.

    Prints quantisation, random walk, instability, rate random walk and ramp, each with its interval and the averaging
    time at which it was read, and the lines to paste into a recording's description.  Exits 1 if the log is not static,
    or is clipped, quantised, driven by temperature or otherwise no log of noise.  With --datasheet: converts a line of
    a datasheet to what a filter needs.  With --model: finds the noises of a flight that `Record` wrote to a folder, for
    any model, by the likelihood of its innovations; -o draws the Allan deviation of the innovations, with that of the
    white noise that the model predicts.
    """
    from boresight.analysis import noise as n
    from boresight.runtime.units import quantity

    if model is not None:
        if log is None or datasheet or begin or end or bridge or regular_clock or allow:
            raise BoresightError("--model needs the folder of a Record, and allows only -o, --svg and --json")
        noise_of_flight(log, model, folder, out, svg, as_json)
        return
    if (log is None) == (datasheet is None):
        raise BoresightError("name a log at rest, or a line of a datasheet with --datasheet")
    if datasheet is not None:
        line = n.datasheet(
            datasheet,
            rate_hz=None if rate is None else float(quantity(rate, "frequency")[0]),
            correlation_s=None if correlation is None else float(quantity(correlation, "time")[0]),
        )
        print_json(line.document()) if as_json else print(line.report())
        return
    assert log is not None
    if rate or correlation:
        raise BoresightError("--rate and --correlation are for a line of a datasheet; leave them out")
    from boresight import terminal
    from boresight.runtime.recording.read import read_at_rest

    if out is not None:
        require("replay")  # for the figure; said before the fit and not after it
        make(out)
    with terminal.working() as progress:
        progress("reading")
        recording = read_at_rest(log, begin=begin, end=end, bridge=bridge, regular=regular_clock, allow=allow or ())
        progress("Allan deviations")
        found = n.identify(recording)
    written = None
    if out is not None:
        made_from = f"noise {recording.name}, boresight {__version__}"
        written = found.draw(out / f"noise.{'svg' if svg else 'png'}", made_from, recording.noise)
    if as_json:
        print_json(found.document() | {"figures": [str(written)] if written else []})
    else:
        terminal.page_text(found.report() + (f"\nwrote {written}" if written else "") + "\n")
    raise typer.Exit(0 if found.good else 1)


def noise_of_flight(log: str, target: str, folder: Path | None, out: Path | None, svg: bool, as_json: bool) -> None:
    """`boresight noise LOG --model MODEL`."""
    from boresight import Record, terminal
    from boresight.analysis.likelihood import likeliest

    if out is not None:
        require("replay")
        make(out)
    library = library_of(target, folder, None)
    with terminal.working() as progress:
        progress("reading")
        found = likeliest(Record.open(log, library), progress=progress)
    name = Path(log).name
    where = None if out is None else out / f"noise-{name}.{'svg' if svg else 'png'}"
    written = None if where is None else found.draw(where, f"noise {name}, {library.name}, boresight {__version__}")
    if as_json:
        print_json(
            {"record": name, "model": library.name} | found.document() | {"figures": [str(written)] if written else []}
        )
    else:
        terminal.page_text(found.report() + (f"\nwrote {written}" if written else "") + "\n")


def make(folder: Path) -> Path:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise BoresightError(f"cannot write to {folder} ({error.strerror}); choose another folder with -o") from None
    return folder


def main(words: list[str] | None = None) -> None:
    """The entry point: a BoresightError becomes one line on standard error and exit status 1."""
    if sys.stdout is None:  # closed by whoever called
        sys.stdout = open(os.devnull, "w")  # noqa: SIM115
    try:
        app(words, prog_name="boresight")
        sys.stdout.flush()
    except BoresightError as error:
        print(f"boresight: {error}", file=sys.stderr)
        sys.exit(1)
    except UnicodeEncodeError as error:
        lacks = f"the output has signs that {error.encoding} lacks"
        print(f"boresight: {lacks}; set PYTHONIOENCODING=utf-8", file=sys.stderr)
        sys.exit(1)
    except OSError as error:  # a full disk, a terminal that is gone
        print(f"boresight: the output cannot be written ({error.strerror})", file=sys.stderr)
        sys.stdout = open(os.devnull, "w")  # noqa: SIM115
        sys.exit(1)


if __name__ == "__main__":
    main()
