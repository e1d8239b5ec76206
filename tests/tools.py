"""What a test needs beside gcc, make, Python and its packages: each tool is asked for here, by its name.

A mark, `needs("clang")`, or a parameter, `given("clang", "-O3")`, skips a test whose tool is missing; `tool("clang")`
gives the command to a test that runs, or skips it.  The reason of each skip says what to install.  A test that starts
a tool without asking fails, whether the tool is there or not.
"""

import os
import re
import shlex
import shutil
import subprocess
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
SHARED = ROOT.parent / "shared"  # where data may lie that is not of this project
CPU = Path("/proc/cpuinfo")


def printed(*command):
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout.strip()


def finds(compiler, file):
    """Whether a compiler finds a file of its library: of one that it does not find it prints the bare name."""
    return Path(printed(compiler, f"-print-file-name={file}")).is_absolute()


@dataclass(frozen=True)
class Tool:
    """packages: Debian's.  command: what is started; by default the tool's name, "" for what is no program.
    also: what must be true beside.  hint: what to do where no package helps."""

    packages: str = ""
    command: str | None = None
    also: Callable[[], bool] = lambda: True
    hint: str = ""


TOOLS = {
    "clang": Tool("clang"),
    "clang++": Tool("clang"),
    "clang-19": Tool("clang-19 libclang-rt-19-dev"),  # 18 and newer count conditions
    "llvm-cov-19": Tool("llvm-19"),
    "llvm-profdata-19": Tool("llvm-19"),
    "libclang-rt": Tool(
        *("clang libclang-rt-dev", "clang"),
        lambda: any(Path(printed("clang", "-print-resource-dir")).glob("lib/*/libclang_rt.ubsan_standalone*")),
    ),
    "g++": Tool("g++"),
    "cmake": Tool("cmake"),
    "git": Tool("git"),
    "pkg-config": Tool("pkg-config"),
    "arm-none-eabi-gcc": Tool(
        "gcc-arm-none-eabi libnewlib-arm-none-eabi", also=lambda: finds("arm-none-eabi-gcc", "nosys.specs")
    ),
    "arm-linux-gnueabihf-gcc": Tool(
        "gcc-arm-linux-gnueabihf libc6-dev-armhf-cross", also=lambda: finds("arm-linux-gnueabihf-gcc", "libc.a")
    ),
    "aarch64-linux-gnu-gcc": Tool(
        "gcc-aarch64-linux-gnu libc6-dev-arm64-cross", also=lambda: finds("aarch64-linux-gnu-gcc", "libc.a")
    ),
    "riscv64-unknown-elf-gcc": Tool(
        "gcc-riscv64-unknown-elf picolibc-riscv64-unknown-elf",
        also=lambda: finds("riscv64-unknown-elf-gcc", "picolibc.specs"),
    ),
    "qemu-system-arm": Tool("qemu-system-arm"),
    "qemu-arm": Tool("qemu-user"),
    "qemu-armeb": Tool("qemu-user"),
    "qemu-aarch64": Tool("qemu-user"),
    "gappa": Tool("gappa"),
    "coqc": Tool("coq libcoq-gappa", also=lambda: Path(printed("coqc", "-where"), "user-contrib/Gappa").is_dir()),
    "sollya": Tool("sollya"),
    "frama-c": Tool("frama-c-base"),
    "cppcheck": Tool("cppcheck"),
    "pdflatex": Tool(
        "texlive-latex-base texlive-latex-recommended texlive-latex-extra",
        also=lambda: bool(printed("kpsewhich", "xcolor.sty")),
    ),
    "chromium": Tool("chromium"),
    "valgrind": Tool("valgrind"),
    "x86-64-v3": Tool(command="", also=lambda: "avx2" in text_of(CPU), hint="a processor with AVX2"),
    "x87": Tool(
        command="",
        also=lambda: "__FLT_EVAL_METHOD__ 2" in printed("gcc", "-mfpmath=387", "-dM", "-E", "-x", "c", os.devnull),
        hint="a gcc for x86",
    ),
    "IPython": Tool(command="", also=lambda: find_spec("IPython") is not None, hint="pip install ipython"),
    "nvrtc": Tool(
        command="",
        also=lambda: all(find_spec(name) is not None for name in ("cuda", "nvidia")),
        hint="pip install 'boresight[gpu]'",
    ),
    "gpu": Tool(command="", also=lambda: there("nvrtc") and has_gpu(), hint="an NVIDIA GPU, and its driver"),
    "papers": Tool(
        command="", also=(SHARED / "papers").is_dir, hint="the papers' texts in shared/papers beside the checkout"
    ),
}


def has_gpu():
    from boresight import BoresightError
    from boresight.runtime.gpu.card import Card

    try:
        return bool(Card().name)
    except BoresightError:
        return False


def text_of(path):
    return path.read_text() if path.is_file() else ""


def command(name):
    """What is started of a tool, or "" of what is no program."""
    own = TOOLS[name].command
    return name if own is None else own


@cache
def there(name):
    return (not command(name) or shutil.which(command(name)) is not None) and TOOLS[name].also()


def reason(missing):
    """Why a test that needs these is skipped, and what to do."""
    packages = install(missing)
    hints = [f"apt-get install {packages}"] if packages else []
    return f"needs {', '.join(missing)}: {'; '.join([*hints, *(TOOLS[n].hint for n in missing if TOOLS[n].hint)])}"


def install(names):
    """The packages of these tools, as apt-get takes them."""
    return " ".join(dict.fromkeys(word for name in names if name in TOOLS for word in TOOLS[name].packages.split()))


# ---- what a test says


def needs(*names):
    """A mark: the test is skipped where one of these tools is missing."""
    for name in names:
        assert name in TOOLS, f"{name} is not in the table of tests/tools.py"
    return pytest.mark.needs(*names)


def given(name, *values, also=()):
    """A parameter: the tool's command, and what goes with it; `also` names what else it needs."""
    return pytest.param(command(name), *values, marks=needs(name, *also))


def tool(name):
    """The tool's command; the running test is skipped where it is missing."""
    asked.add(name)
    if not there(name):
        pytest.skip(reason([name]))
    return command(name)


def lacks(name, hint):
    """Skip the running test for want of something that is in no package: a file, or a tool's other version."""
    pytest.skip(f"needs {name}: {hint}")


def real_recording(name):
    """The path of recorded data, under BORESIGHT_DATA or in shared/data beside the checkout."""
    folder = Path(os.environ.get("BORESIGHT_DATA") or SHARED / "data")
    if not (folder / name).is_file():
        lacks("recordings", f"set BORESIGHT_DATA to a folder that holds {name}; here it is {folder}")
    return folder / name


# ---- what the tests' run makes of it

asked = set()  # by the running test


def started(words):
    """The commands of tools that a command line names, itself or by `CC=clang`: a list of words, or a shell's line."""
    words = shlex.split(words) if isinstance(words, str) else map(str, words)
    names = {os.path.basename(word.rpartition("=")[2]) for word in words}
    names |= {re.sub("-(ar|ld|nm|objcopy|objdump|size|strip)$", "-gcc", name) for name in names}
    return names & (set(map(command, TOOLS)) - {""})


class Guarded(subprocess.Popen):
    """A process of a test, which starts no tool that the test has not asked for."""

    def __init__(self, args, *others, **named):
        unasked = started(args) - set(map(command, asked)) if running else set()
        if unasked:
            name = sorted(unasked)[0]
            raise AssertionError(f'{name} is started and not asked for: mark the test with needs("{name}")')
        super().__init__(args, *others, **named)


running = []  # the test that runs, or nothing


def pytest_addoption(parser):
    parser.addoption(
        "--may-skip",
        metavar="NAMES",
        help="what tests may be skipped for: tools by their names, or a share such as 5%%; any other skip is an error",
    )
    parser.addoption("--skipped", metavar="FILE", help="write the names of the skipped tests, to be run as @FILE")


def pytest_configure():
    subprocess.Popen = Guarded


def pytest_unconfigure():
    subprocess.Popen = Guarded.__base__


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item):
    names = [name for mark in item.iter_markers("needs") for name in mark.args]
    asked.clear()
    asked.update(names)
    missing = [name for name in dict.fromkeys(names) if not there(name)]
    if missing:
        pytest.skip(reason(missing))
    running.append(item)


def pytest_runtest_logfinish():
    running.clear()


def why(report):
    """What a skipped test needs, by its reason; a reason that is not of this file is given whole."""
    text = report.longrepr[2].removeprefix("Skipped: ")
    found = re.match(r"needs ([^:]*): ", text)
    return found[1].split(", ") if found else [text]


def refused(skipped, count, may_skip):
    """Why a run of `count` tests, of which these are skipped, may not end well, or ""."""
    if may_skip.endswith("%"):
        share = 100 * len(skipped) / max(count, 1)
        return f"{share:.1f} % of the tests are skipped, and {may_skip} may be" if share > float(may_skip[:-1]) else ""
    wrong = sorted({name for report in skipped for name in why(report)} - set(may_skip.split()))
    return f"tests are skipped that may not be, for want of {', '.join(wrong)}" if wrong else ""


def verdict(config):
    """What --may-skip has against this run, or ""."""
    stats = config.pluginmanager.get_plugin("terminalreporter").stats
    count = sum(len(stats.get(name, ())) for name in ("passed", "failed", "skipped"))
    may_skip = config.option.may_skip
    return "" if may_skip is None else refused(stats.get("skipped", ()), count, may_skip)


@pytest.hookimpl(trylast=True)
def pytest_terminal_summary(terminalreporter, config):
    """One table: how many passed, and what the skipped ones need."""
    if config.option.collectonly:
        return
    stats = {name: terminalreporter.stats.get(name, ()) for name in ("passed", "failed", "error", "skipped")}
    needed = Counter(name for report in stats["skipped"] for name in why(report))
    lines = [", ".join(f"{len(reports)} {name}" for name, reports in stats.items())]
    lines += [f"{number:6} skipped for want of {name}" for name, number in needed.most_common()]
    if install(needed):
        lines.append(f"to run them too: apt-get install {install(needed)}")
    terminalreporter.write_sep("-", "tests")
    terminalreporter.write_line("\n".join(lines))
    if config.option.skipped:
        names = sorted({report.nodeid for report in stats["skipped"]})
        Path(config.option.skipped).write_text("".join(f"{name}\n" for name in names))
    if verdict(config):
        terminalreporter.write_line(f"error: {verdict(config)}", red=True)


def pytest_sessionfinish(session):
    if not hasattr(session.config, "workerinput") and verdict(session.config):
        session.exitstatus = pytest.ExitCode.TESTS_FAILED
