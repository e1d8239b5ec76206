"""Build each example by the tool that it is for, where that is here: python examples/embed/build.py [PLACE ...]

It exports strapdown in float, builds, and runs what this machine can run.  A line each: the tool, and what came of it.
"""

import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
from collections.abc import Callable
from pathlib import Path

from boresight import export

HERE = Path(__file__).resolve().parent
EXACT = ("-ffp-contract=off", "-Wall", "-Wextra", "-Werror")
# As PX4 has them for C++, those that both compilers know.
PX4 = "-std=c++14 -fno-exceptions -fno-rtti -Wall -Wextra -Werror -Wcast-align -Wdouble-promotion -Wfloat-equal"
PX4 += " -Wformat=1 -Wshadow -Wunused-variable -Wpointer-arith -Wno-missing-field-initializers"
CORE = Path("/usr/share/arduino/hardware/arduino/avr")
AVR = (
    "-mmcu=atmega2560",
    "-DF_CPU=16000000L",
    "-DARDUINO=10819",
    "-Os",
    "-ffunction-sections",
    "-ffp-contract=off",
    "-w",
    "-DDECIMAL_DIG=9",
)  # which avr-g++ 5 does not tell the core's String


def run(*command: str | Path, cwd: Path | None = None, **env: str) -> str:
    done = subprocess.run(
        [*map(str, command)], cwd=cwd, env=os.environ | env, capture_output=True, text=True, check=False
    )
    if done.returncode:
        sys.exit(f"{command[0]}: {(done.stdout + done.stderr)[-1500:]}")
    return done.stdout


def library(folder: Path, *flags: str) -> Path:
    """The exported folder as a static library."""
    run("make", "-C", folder, f"CFLAGS={' '.join(flags)}")
    return folder / "build" / "libstrapdown_f32.a"


def cmake(folder: Path, out: Path) -> str:
    run("cmake", "-S", HERE / "cmake", "-B", out, f"-DEXPORTED={folder}")
    run("cmake", "--build", out)
    run(out / "rest")
    return "built, runs"


def arduino(folder: Path, out: Path) -> str:
    """Arduino's core for AVR and the sketch, by avr-gcc as its platform.txt does."""
    places = [f"-I{p}" for p in (CORE / "cores/arduino", CORE / "variants/mega", *folder.glob("arduino/*/src"), HERE)]
    sketch = out / "rest.cpp"
    sketch.write_text("#include <Arduino.h>\n" + (HERE / "arduino/rest/rest.ino").read_text())
    objects = []
    for file in (sketch, *(CORE / "cores/arduino").glob("*.c*"), *folder.glob("arduino/*/src/*.c")):
        objects.append(out / f"{file.name}.o")
        language = ("avr-gcc", "-std=gnu11") if file.suffix == ".c" else ("avr-g++", "-std=gnu++11", "-fno-exceptions")
        run(*language, *AVR, *places, "-c", file, "-o", objects[-1])
    run("avr-gcc", *AVR, "-Wl,--gc-sections", *objects, "-lm", "-o", out / "rest.elf")
    flash = run("avr-size", out / "rest.elf").splitlines()[1].split()
    text, data, bss = map(int, flash[:3])
    built = f"built for an ATmega2560: {text + data} bytes of flash, {data + bss} of RAM"
    if not shutil.which("simavr"):
        return built
    with subprocess.Popen(
        ["simavr", "-m", "atmega2560", "-f", "16000000", out / "rest.elf"],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    ) as board:  # which does not end by itself
        assert board.stdout
        found = next((line for line in board.stdout if "at rest" in line or "not as" in line), "")
        board.kill()
    return f"{built}; on simavr: {'at rest' if 'at rest' in found else 'not as it should be'}"


def platformio(folder: Path, out: Path) -> str:
    """PyPI's platformio packs the export by its library.json, without network."""
    run("platformio", "pkg", "pack", folder, "-o", out / "packed.tar.gz")
    return "library.json is taken by 'platformio pkg pack'; nobody here built the sketch"


def idf(folder: Path, out: Path) -> str:
    """PyPI's idf-component-manager packs the export by its idf_component.yml, without network."""
    run("compote", "component", "pack", "--name", "strapdown_f32", "--project-dir", folder, "--dest-dir", out)
    return "idf_component.yml is taken by 'compote component pack'; nobody here built it in ESP-IDF"


def px4(folder: Path, out: Path) -> str:
    """The module alone, with a main of its own in place of PX4's shell."""
    (out / "main.cpp").write_text(
        'extern "C" int rest_main(int, char **);\nint main() { return rest_main(0, nullptr); }\n'
    )
    sources = HERE / "px4/rest.cpp", out / "main.cpp", library(folder)
    run("g++", *PX4.split(), f"-I{folder / 'include'}", f"-I{HERE}", *sources, "-lm", "-o", out / "rest")
    run(out / "rest")
    return "built as C++14 with PX4's warnings, runs; nobody here built it in PX4"


def python(folder: Path, out: Path) -> str:
    shared = out / f"rest{sysconfig.get_config_var('SHLIB_SUFFIX')}"
    command = ("cc", "-std=c99", "-O2", "-shared", "-fPIC", *EXACT, f"-I{folder / 'include'}")
    run(*command, *folder.glob("src/*.c"), "-lm", "-o", shared)
    run(sys.executable, HERE / "ctypes/rest.py", shared)
    return "built, runs"


def rust(folder: Path, out: Path) -> str:
    header = folder / "include/strapdown.h"
    words = ("--allowlist-function", "sd_.*")
    run("bindgen", header, *words, "-o", out / "strapdown.rs")
    built = library(folder, "-fPIC").parent
    flags = ("--edition", "2021", "-L", built, "-l", "static=strapdown_f32", "-l", "m")
    run("rustc", HERE / "rust/rest.rs", *flags, "-o", out / "rest", OUT_DIR=str(out))
    run(out / "rest")
    return "built, runs"


def freertos(folder: Path, out: Path) -> str:
    """The loop on the kernel in FREERTOS_KERNEL, on an emulated Cortex-M4F; the digest is that of a flight here."""
    kernel = os.environ.get("FREERTOS_KERNEL")
    if not kernel:
        return "not tried, FREERTOS_KERNEL does not name the folder of FreeRTOS-Kernel"
    export("velocity-attitude", out / "filter", "float")
    digests = []
    for place in ("flight", "embed/freertos"):
        unbuilt = shutil.ignore_patterns("build", "__pycache__")
        shutil.copytree(HERE.parent / place, out / place, ignore=unbuilt)
        given = f"FILTER={out / 'filter'}", f"KERNEL={Path(kernel).resolve()}", f"PYTHON={sys.executable}"
        flown = run("make", "-s", "-C", out / place, "run", *given)
        digests += re.findall(r"^[0-9a-f]{64}$", flown, re.MULTILINE)
    if len(digests) != 2 or digests[0] != digests[1]:
        sys.exit(f"freertos: not one digest: {digests}")
    return "built, flown on an emulated Cortex-M4F, with the digest of the flight here"


PLACES: dict[str, tuple[Callable[[Path, Path], str], str]] = {
    "cmake": (cmake, "cmake"),
    "arduino": (arduino, "avr-gcc"),
    "platformio": (platformio, "platformio"),
    "idf": (idf, "compote"),
    "px4": (px4, "g++"),
    "ctypes": (python, "cc"),
    "rust": (rust, "bindgen"),
    "freertos": (freertos, "qemu-system-arm"),
}


def main() -> None:
    for place in sys.argv[1:] or PLACES:
        build, tool = PLACES[place]
        with tempfile.TemporaryDirectory() as aside:
            folder, out = Path(aside) / "export", Path(aside) / "out"
            out.mkdir()
            beside = shutil.which(tool, path=f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}")
            if not beside or (place == "arduino" and not CORE.is_dir()):
                print(f"{place}: not tried, {tool} is not here")
                continue
            export("strapdown", folder, "float", places=("cmake", "arduino", "platformio", "idf", "zephyr", "px4"))
            print(f"{place}: {build(folder, out)}", flush=True)


if __name__ == "__main__":
    main()
