"""The elementary functions in C: what they err by, what they give at the ends, and equal bits by every compiler."""

import itertools
import re
import subprocess

import mpmath as mp
import numpy as np
import pytest
from building import self_test
from conftest import PENDULUM, ROOT
from tools import given, needs, tool

from boresight.codegen.functions.tape import LIBRARY, ULPS
from boresight.codegen.text.files import environment
from boresight.evidence.elementary import headers, ulps
from boresight.evidence.targets import M4F, M7, RV32, WARNINGS, Build
from boresight.runtime.compiler import PRECISIONS, run

MOST = 0.83  # ulp of sine, cosine, arctangents, exponential and logarithm; of the others ULPS
ALL = ("atan2", *sorted(LIBRARY))
CALLS = """
#include <stdio.h>
#include "boresight_math.h"
int main(void)
{
    double y, x;
    while (scanf("%la %la", &y, &x) == 2) {
        bs_real sine, cosine;
        bs_sincos((bs_real)y, &sine, &cosine);
        printf("%a %a %a", (double)sine, (double)cosine, (double)bs_atan2((bs_real)y, (bs_real)x));
        bs_real (*const all[])(bs_real) = { NAMES };
        for (unsigned int i = 0; i < sizeof all / sizeof all[0]; ++i) {
            printf(" %a", (double)all[i]((bs_real)y));
        }
        printf("\\n");
    }
    return 0;
}
"""
NAMES = sorted(LIBRARY)
COLUMNS = ("sine", "cosine", "atan2", *NAMES)
BITS = """
#include <string.h>
#include "boresight_math.h"
#include <stdio.h>
static uint32_t hash = 2166136261U;
static void add(bs_real value)
{
    unsigned char bytes[sizeof value];
    if (!(value <= value)) {
        value = BS_REAL(12345.0); /* which NaN it is no standard says */
    }
    memcpy(bytes, &value, sizeof value);
    for (unsigned int i = 0; i < sizeof value; ++i) {
        hash = (hash ^ bytes[i]) * 16777619U;
    }
}
int main(void)
{
    uint32_t state = 1U;
    for (int i = 0; i < 20000; ++i) {
        bs_real number[2], sine, cosine;
        for (int j = 0; j < 2; ++j) {
            state = (state * 1664525U) + 1013904223U;
            const bs_real unit = (bs_real)(state >> 8) / BS_REAL(8388608.0) - BS_REAL(1.0);
            const bs_real scale = bs_power_of_two((int)((state >> 3) % 60U) - 40);
            number[j] = (i % 3 == 0) ? unit : ((i % 3 == 1) ? unit * BS_REAL(8.0) : unit * scale);
        }
        bs_sincos(number[0], &sine, &cosine);
        add(sine); add(cosine); add(bs_sin(number[1])); add(bs_cos(number[1]));
        add(bs_atan2(number[0], number[1])); add(bs_exp(number[0])); add(bs_log(number[0]));
        add(bs_asin(number[0])); add(bs_acos(number[0])); add(bs_atan(number[0]));
        add(bs_sinh(number[0])); add(bs_cosh(number[0])); add(bs_tanh(number[0]));
    }
    printf("%08lx\\n", (unsigned long)hash);
    return 0;
}
"""


@pytest.fixture(scope="module", params=sorted(PRECISIONS))
def precision(request):
    return request.param


@pytest.fixture(scope="module")
def include(tmp_path_factory):
    return headers(tmp_path_factory.mktemp("include"))


@pytest.fixture(scope="module")
def values(precision, include, tmp_path_factory):
    """Pairs of numbers -> each function's value at the first of them, of atan2 at both."""
    out = tmp_path_factory.mktemp(precision)
    (out / "calls.c").write_text(CALLS.replace("NAMES", ", ".join(f"bs_{name}" for name in NAMES)))
    program, real = out / "calls", np.float32 if precision == "float" else np.float64
    run(["gcc", *WARNINGS[:-1], "-O2", *PRECISIONS[precision], "-I", include, out / "calls.c", "-lm", "-o", program])

    def called(pairs):
        text = "\n".join(" ".join(float(real(v)).hex() for v in pair) for pair in pairs)
        done = subprocess.run([program], input=text, capture_output=True, text=True, check=True).stdout
        rows = [[float.fromhex(word.replace("-nan", "nan")) for word in line.split()] for line in done.splitlines()]
        return dict(zip(COLUMNS, np.array(rows).T, strict=True))

    return called


def same(a, b):
    """Equal to the bit; a NaN is a NaN."""
    a, b = (np.broadcast_to(np.asarray(v, float), np.broadcast(a, b).shape) for v in (a, b))
    return np.where(np.isnan(a), np.nan, a).tobytes() == np.where(np.isnan(b), np.nan, b).tobytes()


# ---- what they err by


def test_no_function_errs_by_more_than_is_stated(precision, tmp_path):
    found = ulps(tmp_path, precision, 20_000, 99_991)
    assert {name.split()[0] for name in found} == {"sin", "cos", "atan2"} | LIBRARY
    for name, (worst, at) in found.items():
        assert worst <= ULPS.get(name.split()[0], MOST), (name, worst, at)


@pytest.mark.parametrize("name", ["sin", "cos"])
def test_a_large_angle_is_reduced_by_as_many_digits_as_it_needs(name, precision, values):
    rng = np.random.default_rng(3)
    real, most = (np.float32, 38) if precision == "float" else (np.float64, 308)
    near = [6381956970095103 * 2.0**797, 1e22] if precision == "double" else [16367173 * 2.0**72, 1e22]
    angles = real([*near, *(10.0 ** rng.uniform(1, most, 400)), *(np.arange(1, 30_000, 97) * np.pi / 2)]).astype(float)
    angles = np.concatenate([angles, np.nextafter(real(angles), real(0)).astype(float), -angles])
    got = values([(x, 1) for x in angles])["sine" if name == "sin" else "cosine"]
    with mp.workprec(1400):
        for x, value in zip(angles, got, strict=True):
            wanted = getattr(mp, name)(mp.mpf(x))
            unit = float(np.spacing(max(real(abs(float(wanted))), np.finfo(real).tiny)))
            assert abs(value - wanted) <= MOST * unit, (x.hex(), value)


POLYNOMIALS = {  # the whole, the function, x if the error is relative to it, from where to where, log2 of the error
    "sin": ("x - x^3*p(x^2)", "sin(x)", "x", "1b-20", "pi/4", -27.89, -57.88),
    "cos": ("1 - x^2/2 + x^4*p(x^2)", "cos(x)", "1", "1b-20", "pi/4", -33.1, -64.07),
    "atan": ("x + x^3*p(x^2)", "atan(x)", "x", "1b-20", "tan(pi/8)", -30.41, -59.44),
    "exp": ("1 + x + x^2/2 + x^3*p(x)", "exp(x)", "1", "-log(2)/2", "log(2)/2", -27.52, -56.86),
    "log": ("2*x + x^3*p(x^2)", "log((1+x)/(1-x))", "x", "1b-20", "(sqrt(2)-1)/(sqrt(2)+1)", -34.98, -59.49),
    "sinh": ("x + x^3*p(x^2)", "sinh(x)", "x", "1b-20", "1", -31.35, -61.5),
}


@needs("sollya")
@pytest.mark.parametrize("name", POLYNOMIALS)
def test_a_polynomial_errs_by_what_sollya_bounds(name, precision, tmp_path):
    """The coefficients are read from the C; the bound is certified, by supnorm."""
    text = environment().get_template("include/boresight_math.h.j2").render()
    body = re.search(
        rf"bs_{name}_polynomial\(bs_real \w\)\n{{\n#ifdef BORESIGHT_FLOAT\n(.*?)#else\n(.*?)#endif", text, re.S
    )
    printed = body[1 if precision == "float" else 2].replace("return", "").strip().rstrip(";")
    numbers = [float(word) for word in re.findall(r"-?\d+\.\d+(?:e-\d+)?", printed)]
    if precision == "float":
        numbers = [float(np.float32(number)) for number in numbers]
    form, goal, scale, low, high, in_float, in_double = POLYNOMIALS[name]
    horner = " + ".join(f"({number.hex().replace('p+0', '')})*y^{k}" for k, number in enumerate(numbers))
    inner = re.search(r"p\((.*?)\)", form)
    whole = form.replace(inner[0], "(" + horner.replace("y", f"({inner[1]})") + ")")
    bound = in_float if precision == "float" else in_double
    script = tmp_path / "bound.sollya"
    script.write_text(
        f"display=decimal!; prec=300!; w = ({whole}); s = supnorm(w, {goal}, [{low};{high}], "
        f"{'relative' if scale == 'x' else 'absolute'}, 1b-10); print(round(log2(sup(s)), 30, RU)); quit;\n"
    )
    found = float(run([tool("sollya"), script]).split()[-1])
    assert bound - 0.1 < found < bound + 0.01


# ---- ends, signs, pairs

INF, NAN, ZEROS = float("inf"), float("nan"), [0.0, -0.0]


def test_what_has_no_value_is_no_number_and_what_is_infinite_stays(values):
    of = values([(INF, 1), (-INF, 1), (NAN, 1), (1.5, 1), (-1.5, 1), (-1, 1)])
    for name in ("sine", "cosine", "sin", "cos"):
        assert np.isnan(of[name][:3]).all()
    assert all(np.isnan(of[name][2]) for name in COLUMNS)
    assert np.isnan([of[name][i] for name in ("asin", "acos") for i in (0, 1, 3, 4)]).all()
    assert np.isnan(of["log"][[1, 4, 5]]).all() and of["log"][0] == INF
    assert of["exp"][:2].tolist() == [INF, 0] and of["cosh"][:2].tolist() == [INF, INF]
    assert of["sinh"][:2].tolist() == [INF, -INF] and of["tanh"][:2].tolist() == [1, -1]
    assert of["atan"][:2].tolist() == [-of["atan"][1], -of["atan"][0]] == pytest.approx([np.pi / 2, -np.pi / 2])


def test_zeros_keep_their_sign(values):
    of = values([(zero, 1) for zero in ZEROS])
    for name in ("sine", "sin", "asin", "atan", "sinh", "tanh", "atan2"):
        assert same(of[name], ZEROS), name
    for name in ("cosine", "cos", "exp", "cosh"):
        assert of[name].tolist() == [1, 1]
    assert of["log"].tolist() == [-INF, -INF]
    assert values([(1, 1)])["log"][0] == 0 and values([(1, 1)])["acos"][0] == 0


def test_the_angle_of_a_point_is_as_c99_has_it(values):
    ends = [0.0, -0.0, 1.0, -1.0, INF, -INF, NAN, 1e-45, -1e30]
    pairs = list(itertools.product(ends, ends))
    wanted = np.arctan2(*np.array(pairs).T)
    assert np.allclose(values(pairs)["atan2"], wanted, rtol=2e-7, atol=1e-44, equal_nan=True)
    assert (np.signbit(values(pairs)["atan2"]) == np.signbit(wanted))[~np.isnan(wanted)].all()


def test_sines_are_odd_cosines_even_and_each_alone_is_that_of_the_pair(values):
    rng = np.random.default_rng(5)
    angles = np.concatenate([rng.uniform(-8, 8, 3000), 10 ** rng.uniform(-40, 30, 1000), np.arange(64) * np.pi / 4])
    ahead, back = values([(x, 0.3) for x in angles]), values([(-x, 0.3) for x in angles])
    assert same(ahead["sine"], ahead["sin"]) and same(ahead["cosine"], ahead["cos"])
    for name in ("sin", "atan2", "atan", "sinh", "tanh"):
        assert same(ahead[name], -back[name]), name
    assert same(ahead["cos"], back["cos"]) and same(ahead["cosh"], back["cosh"])
    assert (abs(ahead["sin"]) <= 1).all() and (abs(ahead["cos"]) <= 1).all()


# ---- the same bits

LEVELS = [f"-O{level}" for level in "0123s"]
V3 = ["-O3 -march=x86-64-v3"]


def bits(build, emulator, precision, include, out):
    """The hash of what a build prints, run by an emulator if it is named."""
    (out / "bits.c").write_text(BITS)
    flags = ["-std=c99", "-ffp-contract=off", *PRECISIONS[precision], "-I", include]
    run([*build, *flags, out / "bits.c", "-lm", "-o", out / "bits"])
    return run([*emulator, out / "bits"]).strip()


@pytest.mark.parametrize(
    ("compiler", "builds"),
    [
        ("gcc", LEVELS),
        pytest.param("gcc", V3, marks=needs("x86-64-v3")),
        given("clang", LEVELS),
        given("clang", V3, also=["x86-64-v3"]),
        given("aarch64-linux-gnu-gcc", ["-O2 -static"]),
        given("arm-linux-gnueabihf-gcc", ["-O2 -static", "-Os -static -mfpu=neon-vfpv4"]),
    ],
)
def test_every_compiler_and_machine_gives_the_same_bits(compiler, builds, precision, include, tmp_path):
    emulator = [tool(f"qemu-{core}") for core in ("aarch64", "arm") if compiler.startswith(f"{core}-")]
    found = {flags: bits((compiler, *flags.split()), emulator, precision, include, tmp_path) for flags in builds}
    found["here"] = bits(("gcc", "-O1"), [], precision, include, tmp_path)
    assert len(set(found.values())) == 1, found


@pytest.mark.parametrize(
    "target", [pytest.param(target, marks=needs(target.compiler), id=target.name) for target in (M4F, M7, RV32)]
)
def test_no_warning_and_no_double_in_float_on_a_target(target, include, tmp_path):
    calls = "".join(
        f"bs_real {name}_(bs_real x);\nbs_real {name}_(bs_real x)\n{{\n    return bs_{name}(x);\n}}\n" for name in NAMES
    )
    (tmp_path / "all.c").write_text('#include "boresight_math.h"\n' + calls)
    for precision in PRECISIONS:
        out = tmp_path / f"{precision}.o"
        run(
            [
                target.compiler,
                *WARNINGS,
                *target.flags,
                *PRECISIONS[precision],
                "-O2",
                "-I",
                include,
                "-c",
                tmp_path / "all.c",
                "-o",
                out,
            ]
        )
    text = run([target.tool("objdump"), "-dr", tmp_path / "float.o"])
    assert not re.findall(r"\.f64|__aeabi_d|__aeabi_f2d|fcvt\.d|\bf(?:add|mul|sub|div)\.d\b", text)


# ---- what they cost, and where they stand

COUNTED = """
#include "boresight_math.h"
void pairs(void);
static volatile bs_real angle[4] = { BS_REAL(0.7), BS_REAL(-2.5), BS_REAL(6.0), BS_REAL(-40.0) };
static volatile bs_real sum;
void pairs(void)
{
    for (int i = 0; i < 4; ++i) {
        bs_real sine, cosine;
        bs_sincos(angle[i], &sine, &cosine);
        sum = sine + cosine;
    }
}
"""


@needs("arm-none-eabi-gcc")
def test_a_pair_in_float_costs_at_most_85_instructions_on_a_cortex_m4f(include, tmp_path):
    """Up to 50 rad, in any quadrant; 71 as this is written, and one more for the jump from the model's own name."""
    from boresight.evidence.machine import Machine

    (tmp_path / "pairs.c").write_text(COUNTED)
    flags = [*WARNINGS, *M4F.flags, *M4F.link, "-Os", *PRECISIONS["float"], "-I", include]
    image = tmp_path / "pairs.elf"
    run([M4F.compiler, *flags, "-Wl,-e,pairs", "-Wl,--no-warnings", tmp_path / "pairs.c", "-lm", "-o", image])
    machine = Machine(Build(None, M4F, "float", {}, image), image, ("bs_sincos",))
    machine.call("pairs")
    cost = machine.costs["bs_sincos"]
    assert cost.calls == 4 and cost.most <= 85, cost


@pytest.fixture(scope="module")
def pendulum(folder_of):
    return folder_of(PENDULUM)


def test_a_sine_and_a_cosine_of_one_angle_are_one_call(folder_of):
    """In each function of each kernel; elsewhere a sine and a cosine stand alone."""
    pairs = 0
    for folder in (
        ROOT / "generated" / "euler_matching",
        folder_of(f"{ROOT / 'tests' / 'codegen' / 'sonde.py'}:SONDE"),
    ):
        for path in sorted(folder.glob("src/*_kernel.h")):
            for body in re.findall(r"^{\n(.*?)^}$", path.read_text(), re.M | re.S):
                sines, cosines = (set(re.findall(rf"BS_{name}\((.*)\);", body)) for name in ("SIN", "COS"))
                both = re.findall(r"BS_SINCOS\((.*), &", body)
                assert not sines & cosines and not (sines | cosines) & set(both) and len(both) == len(set(both)), path
                pairs += len(both)
    assert pairs > 10


def test_the_library_of_the_target_may_stand_in_and_both_precisions_link(pendulum, tmp_path):
    for flags in (["-DBORESIGHT_LIBM"], ["-DBORESIGHT_LIBM", *PRECISIONS["float"]]):
        done = self_test(pendulum, tmp_path, "-O0", *flags)
        assert done.returncode == 0, done.stdout
    (source,) = pendulum.glob("src/*_math.c")
    (tmp_path / "main.c").write_text("int main(void)\n{\n    return 0;\n}\n")
    for precision, flags in PRECISIONS.items():
        run(["gcc", "-std=c99", *flags, "-I", pendulum / "include", "-c", source, "-o", tmp_path / f"{precision}.o"])
    run(["gcc", tmp_path / "main.c", tmp_path / "float.o", tmp_path / "double.o", "-lm", "-o", tmp_path / "both"])
