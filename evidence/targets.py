"""The machines that the C is built for, and what a build of a generated folder holds.

A build is the shipped C and its shipped self-test, compiled under the flags of this project with every warning an
error; the self-test's comparison is wrapped so that every number it sees can be read back (harness/recorder.c).
"""

import ctypes
import re
import shutil
from collections.abc import Collection
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.codegen.folder import Folder
from boresight.runtime import compiler
from boresight.runtime.compiler import PRECISIONS, compile_sources, run

HARNESS = Path(__file__).parent / "harness"
WARNINGS = (
    *("-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wdouble-promotion", "-Wshadow"),
    *("-Wmissing-prototypes", "-Werror", "-ffp-contract=off"),
)
ENDING = re.compile(r"_(f32_joseph|f32|ud)$")  # of functions of another precision than double, or another form
OPTIMISED = ("-O2", "-ffunction-sections", "-fdata-sections")
RENAMED = ("selftest_compare", "main")  # of the shipped selftest.c, to shipped_compare and shipped_main
ROOM, GROUPS = 400_000, 20_000  # numbers and comparisons that the recorder keeps of one test


@dataclass(frozen=True)
class Target:
    """compiler: its command.  flags: of the machine.  double: whether it has a double-precision FPU.  link: what makes
    an image of a core; empty for this machine."""

    name: str
    compiler: str
    flags: tuple[str, ...]
    double: bool = True
    link: tuple[str, ...] = ()

    @property
    def emulated(self) -> bool:
        return bool(self.link)

    @property
    def missing(self) -> str:
        """Why nothing can be built for it here, or nothing."""
        return "" if shutil.which(self.compiler) else f"{self.compiler} is not installed"

    def tool(self, name: str) -> str:
        """One of the binary utilities, such as objcopy."""
        return self.compiler.replace("gcc", name) if self.emulated else name

    @property
    def version(self) -> str:
        """First line of the compiler's --version."""
        return compiler.version(self.compiler).splitlines()[0]


GCC = Target("x86-64", "gcc", ("-fPIC",))
CLANG = Target("x86-64 clang", "clang", ("-fPIC",))
BARE = ("-nostartfiles", "--specs=nosys.specs")
M4F = Target(
    *("cortex-m4f", "arm-none-eabi-gcc"),
    ("-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"),
    double=False,
    link=BARE,
)
M7 = Target(
    *("cortex-m7", "arm-none-eabi-gcc"),
    ("-mcpu=cortex-m7", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv5-d16"),
    link=BARE,
)
MEMORY = ("flash=0x80000000", "flash_size=0x400000", "ram=0x80500000", "ram_size=0x800000", "stack_size=0x8000")
RV32 = Target(
    *("riscv32", "riscv64-unknown-elf-gcc"),
    ("-march=rv32imafdc", "-mabi=ilp32d", "--specs=picolibc.specs"),
    link=("-nostartfiles", *(f"-Wl,--defsym=__{word}" for word in MEMORY)),
)
CORES = (M4F, M7)


@dataclass(frozen=True)
class Build:
    """objects: of the units, by name.  image: what can be run: a shared library on this machine, else an ELF file."""

    folder: Folder
    target: Target
    precision: str
    objects: dict[str, Path]
    image: Path

    @property
    def real(self) -> type[np.floating]:
        return np.float32 if self.precision == "float" else np.float64


def compile_units(folder: Folder, target: Target, precision: str, out: Path, *flags: str) -> dict[str, Path]:
    """Every unit's object, by the unit's name; a warning is an error."""
    out.mkdir(parents=True, exist_ok=True)
    common = [target.compiler, *WARNINGS, *target.flags, *PRECISIONS[precision], *(flags or OPTIMISED)]
    return compile_sources([*common, "-I", folder.include], {unit.path: () for unit in folder.units}, out)


def build(folder: Folder, target: Target, precision: str, out: Path, *flags: str) -> Build:
    """The folder's units, by these flags in place of the usual ones, and its self-test for one target, below `out`.

    Of the flags its self-test has the macros.
    """
    out = out / f"{folder.name}-{target.name.replace(' ', '-')}-{precision}"
    objects = compile_units(folder, target, precision, out, *flags)
    common = [target.compiler, *WARNINGS, *target.flags, *PRECISIONS[precision], "-O0", "-I", folder.include]
    common += [flag for flag in flags if flag.startswith("-D")]
    common += [] if target.double or precision == "float" else ["-DBORESIGHT_OTHER_BITS"]  # soft-float rounds some sums
    common += ["-I", folder.path / "selftest", f"-DEVIDENCE_ROOM={ROOM}", f"-DEVIDENCE_GROUPS={GROUPS}"]
    harness = {HARNESS / f"{name}.c": ("-fno-builtin",) for name in ("recorder", "quiet")}
    tests = dict.fromkeys([*folder.files("selftest/*.c"), *folder.identity], ())
    made = compile_sources(common, {**tests, **harness}, out)
    renamed = [f"--redefine-sym={name}=shipped_{name.removeprefix('selftest_')}" for name in RENAMED]
    run([target.tool("objcopy"), *renamed, made["selftest"]])
    image = out / f"image.{'elf' if target.emulated else 'so'}"
    if target.emulated:
        kept = [f"-Wl,-u,{unit.test_function}" for unit in folder.units if unit.test.is_file()]
        link = [*target.link, "-Wl,-e,shipped_main", "-Wl,--gc-sections", *kept]
        link += ["-Wl,--no-warnings"]  # of the C library's missing files and processes, which nothing uses
    else:
        link = ["-shared", "-Wl,-Bsymbolic"]
    run([target.compiler, *target.flags, *link, *objects.values(), *made.values(), "-lm", "-o", image])
    return Build(folder, target, precision, objects, image)


def link_alone(made: Build, unit: str) -> Path:
    """One unit and what it needs of the others and of the target's libraries: what would be flown."""
    image = made.image.with_name("alone.elf")
    kept = public_functions(made.objects[unit])
    link = [*made.target.link, "-Wl,--gc-sections", f"-Wl,-e,{kept[0]}"]
    link += [f"-Wl,-u,{name}" for name in kept]
    run([made.target.compiler, *made.target.flags, *link, *made.objects.values(), "-lm", "-o", image])
    return image


def plain(function: str) -> str:
    """One name of a function in every precision and form."""
    return ENDING.sub("", function)


def symbol_table(path: Path) -> list[Any]:
    """Every symbol of an object or an ELF file that has a name."""
    from elftools.elf.elffile import ELFFile

    with path.open("rb") as file:
        table: Any = ELFFile(file).get_section_by_name(".symtab")
        return [symbol for symbol in table.iter_symbols() if symbol.name]


def public_functions(path: Path) -> list[str]:
    """Names of the functions that an object offers to others."""
    return [
        s.name
        for s in symbol_table(path)
        if s["st_info"]["type"] == "STT_FUNC" and s["st_info"]["bind"] == "STB_GLOBAL" and s["st_shndx"] != "SHN_UNDEF"
    ]


def text_size(path: Path) -> int:
    """Bytes of code and constants of one object."""
    from elftools.elf.elffile import ELFFile

    with path.open("rb") as file:
        return sum(s["sh_size"] for s in ELFFile(file).iter_sections() if re.match(r"\.(text|rodata)", s.name))


DOUBLE = re.compile(
    r"^__aeabi_(d(?!iv)|cd|f2d|i2d|ui2d|l2d|ul2d)|df[0-9]$|(?<!_invali)df$"
)  # __math_invalidf is of float


def doubles(made: Build, names: Collection[str]) -> dict[str, list[str]]:
    """What of double precision each of these units of a float build holds: instructions; without a double FPU, helpers
    too, also those of the library functions that it calls."""
    found = {}
    for name in names:
        path = made.objects[name]
        disassembly = run([made.target.tool("objdump"), "-d", path])
        found[name] = sorted({line.split("\t")[2] for line in disassembly.splitlines() if ".f64" in line})
        if not made.target.double:
            found[name] += sorted({s.name for s in symbol_table(link_alone(made, name)) if DOUBLE.search(s.name)})
    return found


@dataclass(frozen=True)
class Run:
    """What one unit's shipped test did: its verdict, and every number it compared, one array a comparison."""

    failures: int
    outputs: list[np.ndarray]


def recorded(failures: int, values: np.ndarray, lengths: np.ndarray, count: int, groups: int) -> Run:
    if count > ROOM or groups > GROUPS:
        raise BoresightError(f"{count} numbers in {groups} comparisons, room for {ROOM} in {GROUPS}")
    return Run(failures, np.split(values, np.cumsum(lengths)[:-1]))


def run_on_host(made: Build, names: Collection[str] | None = None) -> dict[str, Run]:
    """The test of each unit, or of those named, in this process, by the unit's name."""
    library = ctypes.CDLL(str(made.image))
    count, groups = (ctypes.c_int.in_dll(library, f"evidence_{name}") for name in ("count", "groups"))
    real = ctypes.c_float if made.precision == "float" else ctypes.c_double
    record = np.ctypeslib.as_array((real * ROOM).in_dll(library, "evidence_record"))
    lengths = np.ctypeslib.as_array((ctypes.c_int * GROUPS).in_dll(library, "evidence_lengths"))
    runs = {}
    for unit in made.folder.chosen(names):
        if not unit.test.is_file():
            continue
        count.value = groups.value = 0
        failures = getattr(library, unit.test_function)()
        runs[unit.name] = recorded(
            failures, record[: count.value].copy(), lengths[: groups.value].copy(), count.value, groups.value
        )
    return runs


def same_bits(a: Run, b: Run) -> bool:
    """Every bit of every number; a NaN is a NaN, whatever its bits, which no standard fixes."""

    def plain(run: Run) -> list[bytes]:
        return [np.where(np.isnan(x), np.nan, x).tobytes() for x in run.outputs]

    return plain(a) == plain(b)


def ulps_apart(a: Run, b: Run) -> float:
    """The largest difference of two runs in units in the last place of each number itself."""
    if [x.shape for x in a.outputs] != [x.shape for x in b.outputs]:
        return float("inf")
    worst = 0.0
    for x, y in zip(a.outputs, b.outputs, strict=True):
        both = np.isfinite(x) & np.isfinite(y)
        if (np.isfinite(x) != np.isfinite(y)).any():
            return float("inf")
        if both.any():
            difference = np.abs(x[both].astype(float) - y[both].astype(float))
            worst = max(worst, float((difference / np.spacing(np.abs(x[both]).astype(a.outputs[0].dtype))).max()))
    return worst
