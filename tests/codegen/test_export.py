"""The exported folder as a flight-software engineer takes it: built and run with the system's compiler alone."""

import json
import re
import subprocess

import numpy as np
import pytest
from building import exported_c
from conftest import ROOT

from boresight import BoresightError, cli
from boresight.codegen import requirements
from boresight.codegen.export import export
from boresight.codegen.form import self_test, with_form
from boresight.codegen.generate import generate, load_model
from boresight.runtime.manifest import generated, read_manifest

FLAGS = "-O0 -Wconversion -Wdouble-promotion -Wshadow -Wmissing-prototypes -Werror"


def make(folder, *targets):
    return subprocess.run(
        ["make", "-C", str(folder), f"CFLAGS={FLAGS}", *targets], capture_output=True, text=True, check=False
    )


@pytest.mark.parametrize("precision", ["double", "float"])
def test_an_exported_model_passes_its_tests_and_ends_where_python_does(precision, tmp_path):
    exported_c("euler-matching", tmp_path / "out", precision)
    done = make(tmp_path / "out", "test", "example")
    assert done.returncode == 0, done.stdout + done.stderr
    assert ", 0 failed" in done.stdout
    assert "60 s flown" in done.stdout


def test_a_float_export_has_no_double_in_its_sources(tmp_path):
    exported_c("euler-matching", tmp_path / "out", "float")
    listed = subprocess.run(
        [
            "cc",
            "-std=c99",
            "-E",
            "-I",
            str(tmp_path / "out" / "include"),
            str(tmp_path / "out" / "src" / "em_filter.c"),
        ],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    own = listed[listed.rindex("typedef float bs_real") :]
    assert " double " not in own


def test_the_self_test_prints_the_counter_of_a_board_where_one_is_named(tmp_path):
    """By a counter of one's own, which is ahead by one at each reading: each call then takes one."""
    exported_c("strapdown", tmp_path / "out", "float")
    (tmp_path / "out" / "selftest" / "count.c").write_text(
        "#include <stdint.h>\nuint32_t count(void);\nuint32_t count(void)\n"
        "{\n    static uint32_t n = UINT32_MAX;\n    return n++;\n}\n"
    )
    printed = []
    for flags in ([], ["-DBORESIGHT_CYCLES=count"]):
        sources = [*(tmp_path / "out").glob("src/*.c"), *(tmp_path / "out").glob("selftest/*.c")]
        places = [f"-I{tmp_path / 'out' / part}" for part in ("include", "selftest")]
        program = tmp_path / "program"
        command = ["cc", "-std=c99", "-ffp-contract=off", *FLAGS.split(), *flags, *places, *sources, "-lm"]
        subprocess.run([*command, "-o", program], check=True)
        done = subprocess.run([program], capture_output=True, text=True, check=True)
        printed.append(re.findall(r"^cycles (sd_\w+) 1, of (\d+) calls$", done.stdout, re.MULTILINE))
    assert not printed[0]
    assert {"sd_rates", "sd_step"} <= {name for name, calls in printed[1] if int(calls) > 9}


def test_the_example_notices_a_wrong_filter(tmp_path):
    exported_c("euler-matching", tmp_path / "out")
    kernel = tmp_path / "out" / "src" / "em_Qc_kernel.h"
    text = kernel.read_text()
    assert "= q_b2n_wxyz[1] * q_b2n_wxyz[1];" in text
    kernel.write_text(text.replace("= q_b2n_wxyz[1] * q_b2n_wxyz[1];", "= q_b2n_wxyz[1] + q_b2n_wxyz[1];"))
    done = make(tmp_path / "out", "example")
    assert done.returncode != 0


def test_what_the_self_test_of_a_live_loop_flies_has_the_bits_of_this_machine(tmp_path):
    """A constant of the loop that is off is seen, which no requirement's own line sees; but not on soft-float."""
    exported_c("euler-matching", tmp_path / "out")
    loop, right = tmp_path / "out" / "src" / "em_live.c", "const bs_real own = BS_REAL(0.5) * (dt / sample->dt);"
    assert make(tmp_path / "out", "test").returncode == 0
    text = loop.read_text()
    assert right in text
    loop.write_text(text.replace(right, right.replace("0.5", "0.501")))
    done = make(tmp_path / "out", "test")
    assert done.returncode != 0 and "em_live, bits of what was flown: vector 0, element 0 is off by" in done.stdout
    assert make(tmp_path / "out", "clean", "test", "CC=cc -DBORESIGHT_OTHER_BITS").returncode == 0


def test_a_total_state_of_ones_own_is_exported_and_its_example_flies_every_measurement(radar_folder, tmp_path):
    """Rows that wrap, errors that depend on each other, values that the caller brings; and the README names all."""
    out = tmp_path / "out"
    export(f"{ROOT / 'tests' / 'radar.py'}:RADAR", out, "float", radar_folder)
    done = make(out, "test", "example")
    assert done.returncode == 0 and "60 s flown" in done.stdout, done.stdout + done.stderr
    named = [f"rd_filter_measure_{name}" for name in ("compass", "fix", "mounted", "radar", "smeared")]
    assert re.findall(r"rd_filter_measure_\w+", (out / "example" / "main.c").read_text()) == named
    listed = ", ".join(f"`{name}`" for name in named)
    assert f"at every measurement {listed}; " in " ".join((out / "README.md").read_text().split())


def test_exporting_twice_gives_the_same_bytes(tmp_path):
    trees = []
    for name in ("a", "b"):
        exported_c("euler-matching", tmp_path / name)
        files = [path for path in sorted((tmp_path / name).rglob("*")) if path.is_file()]
        trees.append([(path.relative_to(tmp_path / name), path.read_bytes()) for path in files])
    assert trees[0] == trees[1]


def test_export_is_of_what_the_model_says_now(tmp_path):
    """Of a built-in model the committed C, byte for byte as it is written without a look at the model; no other C."""
    export("strapdown", tmp_path / "out", "double")
    exported_c("strapdown", tmp_path / "same")
    trees = [
        {path.relative_to(tmp_path / name): path.read_bytes() for path in (tmp_path / name).rglob("*.*")}
        for name in ("out", "same")
    ]
    assert trees[0] == trees[1]
    (tmp_path / "walk.py").write_text(WALK)
    target = f"{tmp_path / 'walk.py'}:WALK"
    generate(target, tmp_path / "there")
    (tmp_path / "walk.py").write_text(WALK.replace("-5.0, 5.0", "-6.0, 5.0"))
    with pytest.raises(BoresightError, match=f"is not what {re.escape(target)} says now"):
        export(target, tmp_path / "stale", "double", tmp_path / "there")
    assert not (tmp_path / "stale").exists()


def test_nothing_is_overwritten(tmp_path):
    (tmp_path / "notes.txt").write_text("mine")
    with pytest.raises(BoresightError, match="not empty"):
        export("euler-matching", tmp_path, "double")
    assert [path.name for path in tmp_path.iterdir()] == ["notes.txt"]


def test_a_wrong_precision_lists_the_right_ones(tmp_path):
    with pytest.raises(BoresightError, match="double or float"):
        export("euler-matching", tmp_path / "out", "half")


@pytest.mark.parametrize(
    ("model", "precision"), [("strapdown", "double"), ("phi-error", "float"), ("stationary-detector", "double")]
)
def test_what_has_no_filter_is_exported_with_its_self_test_and_precision(model, precision, tmp_path):
    """The export of strapdown in float is built and run in test_adoption, psi-error is printed as phi-error is."""
    exported_c(model, tmp_path / "out", precision)
    done = make(tmp_path / "out", "test")
    assert done.returncode == 0, done.stdout + done.stderr
    assert ", 0 failed" in done.stdout and f", {precision}, none, " in done.stdout
    assert not (tmp_path / "out" / "example").exists()


def test_the_detectors_export_begins_with_c_that_decides_as_python_does(tmp_path):
    """The C of its README alone, with the thresholds that stand in it; of its table each by the quantile itself."""
    from boresight.runtime import detector

    folder = tmp_path / "out"
    exported_c("stationary-detector", folder)
    text = (folder / "README.md").read_text()
    rows = re.findall(r"^\| (\d+) \| ([\d.]+) \| ([\d.]+) \| ([\d.]+) \| ([\d.]+) \| ([\d.]+) \|$", text, re.M)
    assert len(rows) == 12
    for N, rate, *q in ([float(cell) for cell in row] for row in rows):
        limits = [detector.threshold(name, int(N), 1.0, 1.0, rate) for name in detector.DETECTORS]
        assert N * limits[4] == pytest.approx(q[3], abs=0.006) and limits[1] == limits[3]
        assert N * np.square(limits[:3]) == pytest.approx(q[:3], abs=0.006)
    rng = np.random.default_rng(2)
    gyro, accel = 8e-4 * rng.standard_normal((600, 3)), [0, 0, -9.8] + 4e-3 * rng.standard_normal((600, 3))
    gyro[200:300] += 0.05
    code = text.split("```c\n")[1].split("```")[0]
    code += (
        "#include <stdio.h>\nint main(void)\n{\n    double w[3], f[3];\n    if (rest_begin(8e-4, 4e-3, 9.8) != BS_OK) {"
    )
    code += ' return 1; }\n    while (scanf("%lf %lf %lf %lf %lf %lf", w, w + 1, w + 2, f, f + 1, f + 2) == 6) {'
    code += ' printf("%d\\n", rest_now(w, f)); }\n    return 0;\n}\n'
    (folder / "main.c").write_text(code)
    command = ["cc", "-std=c99", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off", "-Iinclude", "main.c"]
    subprocess.run([*command, *(folder / "src").glob("*.c"), "-lm", "-o", "main"], cwd=folder, check=True)
    lines = "\n".join(" ".join(map(repr, map(float, row))) for row in np.hstack([gyro, accel]))
    done = subprocess.run([folder / "main"], input=lines, capture_output=True, text=True, check=True)
    settings = detector.settings(50, 4e-3, 8e-4, 1e-3, gravity=9.8)
    rest = detector.evaluate(settings, gyro, accel).rest_by("likelihood_ratio")
    assert rest.any() and not rest[210:330].any()
    np.testing.assert_array_equal([line == "1" for line in done.stdout.split()], rest)


def test_what_flies_is_exported_and_evidence_of_unchanged_text_stays(tmp_path):
    """One measurement of two, and in double the factors: what hangs on neither is the same text, and proven."""
    out, here = tmp_path / "out", generated() / "euler_matching"
    export("euler-matching", out, only=("euler",), form="ud")
    texts = {path.relative_to(out): path.read_text() for path in out.rglob("*.[ch]")}
    assert not [path for path, text in texts.items() if "euler_exact" in f"{path} {text}".lower()]
    assert not [path for path, text in texts.items() if re.search("Joseph|joseph_", text)]
    found = json.loads((out / "evidence.json").read_text())
    units = set(found["evidence"]["golden"]["units"])
    assert {"em_F", "em_euler_H", "em_math"} <= units and not {"em_filter", "em_covariance", "em_live"} & units
    for name in units:
        assert (out / "src" / f"{name}.c").read_text() == (here / "src" / f"{name}.c").read_text()
    assert found["verdict"] == "not made of this C" and "em_filter" in found["not_made"]["self-test, bits"]
    done = make(out, "test")
    assert done.returncode == 0 and ", double, UD, " in done.stdout, done.stderr
    (tmp_path / "other.c").write_text('#include "em_filter.h"\n'.replace("em_filter", "euler_matching_filter"))
    command = ["gcc", "-DBORESIGHT_UD=0", "-I", out / "include", "-c", tmp_path / "other.c", "-o", tmp_path / "other.o"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode and "exported with --form ud" in done.stderr


@pytest.mark.parametrize(("model", "form"), [("velocity-dcm", "joseph"), ("velocity-attitude-sensors", "ud")])
def test_of_one_form_each_requirement_is_kept_and_tried_and_no_function_is_left_over(model, form, tmp_path):
    """In loops and over non-zeros; the numbers that are the other form's alone are gone."""
    folder = generated() / model.replace("-", "_")
    manifest = read_manifest(folder)
    prefix = manifest["c_prefix"]
    texts = {path: (folder / path).read_text() for path in manifest["files"] if path.startswith(("i", "src", "self"))}
    made = with_form(texts | self_test(load_model(model), form), prefix, form)
    demanded = requirements.requirements(made, manifest)
    assert not requirements.gaps(demanded) and not requirements.unnumbered(made)
    whole = requirements.requirements(texts, manifest)
    over_nonzeros = {"C-031", "C-032"} if f"{prefix}_joseph_step" in texts[f"src/{prefix}_covariance.c"] else set()
    gone = {"C-001"} if form == "joseph" else over_nonzeros
    assert {number.split("-", 1)[1] for number in whole.keys() - demanded.keys()} == gone
    for path, text in made.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    flags = ["-std=gnu11", "-O0", "-Wall", "-Wextra", "-Wpedantic", "-Werror", f"-DBORESIGHT_UD={int(form == 'ud')}"]
    for rows in ([], ["-DBORESIGHT_ROWS"]):
        command = ["gcc", *flags, *rows, f"-I{tmp_path / 'include'}", "-o", tmp_path / "unit.o"]
        subprocess.run([*command, "-c", tmp_path / f"src/{prefix}_covariance.c"], check=True)


@pytest.mark.parametrize(
    ("model", "more", "words"),
    [
        ("euler-matching", {"only": ("eule",)}, "no measurement 'eule' (did you mean 'euler'?); there are euler, "),
        ("euler-matching", {"form": "UD"}, "no form 'UD' of a covariance; choose joseph or ud"),
        ("strapdown", {"form": "ud"}, "--form: strapdown has no filter, and so no covariance"),
        ("strapdown", {"only": ("zupt",)}, "--only: strapdown has no measurement 'zupt'; it has none"),
    ],
)
def test_what_cannot_be_chosen_is_one_line(tmp_path, model, more, words):
    with pytest.raises(BoresightError) as error:
        export(model, tmp_path / "out", **more)
    assert words in str(error.value) and len(str(error.value).splitlines()) == 1
    assert not (tmp_path / "out").exists()


SHIP = """
from sympy import Matrix

from boresight.derive.model import Measurement, Model, Struct, variable

place = variable("place", "lat lon", "rad", "latitude and longitude of the ship", (-1.4, -3.2), (1.4, 3.2))
rates = variable("rates", "north east", "rad/s", "angular rates of the ship", -1e-4, 1e-4)
dt = variable("dt", "dt", "s", "length of the step", 1e-3, 10.0)
gusts = variable("gusts", "gusts", "rad/sqrt(s)", "root density of the drift", 0.0, 1e-6)

SHIP = Model(
    name="ship", c_prefix="sh", title="a ship, 2 states", frame="none", states=(place,),
    structs=(Struct("step", "one step", (rates, dt, gusts)),), f=rates.vector, G=Matrix([1, 1]), noise=gusts.vector,
    dt=dt.scalar, measurements=(Measurement("fix", ("lat", "lon"), "rad", "a fix", h=place.vector),),
)
"""


def test_a_float_export_tells_what_a_position_in_radians_costs(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "ship.py").write_text(SHIP)

    def run(*words):
        with pytest.raises(SystemExit) as ended:
            cli.main([str(word) for word in words])
        return ended.value.code or 0, *capsys.readouterr()

    status, _, error = run("export", "ship.py:SHIP", "-o", "none")
    assert status == 1 and "run 'boresight generate ship.py:SHIP'" in error and "--generated" in error
    assert run("generate", "ship.py:SHIP", "-o", "there")[0] == 0
    status, out, error = run("export", "ship.py:SHIP", "-o", "float", "--precision", "float", "--generated", "there")
    assert status == 0 and len(error.splitlines()) == 1 and "files in float" in out
    readme = (tmp_path / "float" / "README.md").read_text()
    for text in (error, readme):
        for name, end in (("lat", 1.4), ("lon", 3.2)):
            (metres,) = re.findall(rf"\b{name} by ([\d.]+)\s+m\b", text)
            above = np.float32(end)
            below = np.nextafter(above, np.float32(0))
            assert float(metres) == pytest.approx((float(above) - float(below)) * 6378137, rel=0.05)


def test_files_that_are_not_generated_are_named_and_stay(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "ship.py").write_text(SHIP)
    for k in range(2):
        with pytest.raises(SystemExit):
            cli.main(["generate", "ship.py:SHIP"])
        out = capsys.readouterr().out
        assert ("src/mine.c" in out and "not generated" in out) == bool(k)
        mine = tmp_path / "generated" / "ship" / "src" / "mine.c"
        mine.write_text("int mine;\n")
    with pytest.raises(SystemExit):
        cli.main(["generate", "ship.py:SHIP"])
    assert "nothing changed" in capsys.readouterr().out and mine.is_file()


WALK = """
from sympy import Matrix

from boresight.derive.model import Measurement, Model, Struct, variable

level = variable("level", "level", "m", "a level that wanders", -5.0, 5.0)
dt = variable("dt", "dt", "s", "length of the step", 1e-3, 10.0)
drift = variable("drift", "drift", "m/sqrt(s)", "root density of the drift", 0.0, 0.1)

WALK = Model(
    name="walk", c_prefix="wk", title="a random walk, 1 state", frame="none", states=(level,),
    structs=(Struct("step", "one step", (dt, drift)),), f=Matrix([0]), G=Matrix([1]), noise=drift.vector,
    dt=dt.scalar, measurements=(Measurement("reading", ("level",), "m", "the level", h=level.vector),),
)
"""


def test_one_state_without_dynamics_is_exported(tmp_path):
    (tmp_path / "walk.py").write_text(WALK)
    target = f"{tmp_path / 'walk.py'}:WALK"
    generate(target, tmp_path / "there")
    export(target, tmp_path / "out", "double", tmp_path / "there")
    done = make(tmp_path / "out", "test", "example")
    assert done.returncode == 0, done.stdout + done.stderr
    assert ", 0 failed" in done.stdout and "60 s flown" in done.stdout
    assert "Precision" not in (tmp_path / "out" / "README.md").read_text()
