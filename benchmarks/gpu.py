"""Hashes and times of flights on a GPU, in some three minutes: python -m benchmarks.gpu

A thread flies a run: the plain filter of azimuth-hold (a minute at 100 Hz, each second a propagation, a velocity of
zero and a correction), and the sea experiment of `boresight many`.  The first 4096 runs are flown on the host as well,
by scalar C, and have its hash, whatever the blocks.  Times are the least of three, with and without the way there and
back; the host's is of one core.  Without a GPU it says so and ends with status 1.
"""

import argparse
import ctypes
import hashlib
import os
import sys
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from time import perf_counter, process_time
from typing import Any

import numpy as np

from boresight import BoresightError, many
from boresight.codegen.folder import Folder, folders
from boresight.evidence.gpu import run_of
from boresight.runtime import compiler
from boresight.runtime.array import Array
from boresight.runtime.compiler import PRECISIONS
from boresight.runtime.gpu import text
from boresight.runtime.gpu.card import Card
from boresight.runtime.gpu.machine_code import machine_code
from boresight.runtime.library import load
from boresight.runtime.manifest import folder_of
from boresight.studies.sea_state import many as sea

HEADERS = "".join(f"#include <{name}.h>\n" for name in ("float", "math", "stddef", "stdint", "string"))
FLAGS = ("-std=c++17", "-O2", "-fPIC", "-shared", "-ffp-contract=off", "-w")
SEED, COMPARED, BLOCKS = 1, 4096, (64, 128, 256)
SIZES = (4096, 32_768, 65_536, 1_048_576)
REPEATS = 3


def by_host(source: str, folder: Path) -> ctypes.CDLL:
    """The text for a GPU, compiled by g++."""
    library = folder / f"flights-{hashlib.sha256(source.encode()).hexdigest()[:16]}.so"  # a name opens one file once
    file = library.with_suffix(".cpp")
    file.write_text(HEADERS + source)
    compiler.run(["g++", *FLAGS, file, "-o", library])
    return ctypes.CDLL(str(library))


@dataclass(frozen=True)
class Flights:
    """What is flown: the model's folder, the C of a run, what it is given, its columns."""

    name: str
    folder: Path
    source: Path
    given: Array
    columns: int


def flights(out: Path, most: int) -> Iterator[Flights]:
    hold = Folder(folder_of("azimuth-hold"))
    run, file = run_of(hold, ["zupt"]), out / "hold.c"
    file.write_text(run.source)
    yield Flights("azimuth-hold", hold.path, file, run.given, run.columns)
    kind, model = sea.experiment(sea.Sea("sea", 4)), load(sea.MODEL)
    given = sea.numbers(model, kind.settings, SEED, range(most))
    yield Flights("sea", folder_of(sea.MODEL), sea.SOURCE, given, len(kind.columns))


def digest(flown: tuple[Array, Array]) -> str:
    """Of final states and statuses."""
    return hashlib.sha256(b"".join(part.tobytes() for part in flown)).hexdigest()


def flown_by_host(of: Flights, precision: str, runs: range) -> tuple[tuple[Array, Array], float]:
    """With the seconds of one core that a run takes."""
    library, begun = text.host(of.folder, of.source, precision), process_time()
    flown = text.fly(library, of.given, SEED, runs, of.columns)
    return flown, (process_time() - begun) / len(runs)


def on_the_host(of: Flights, precision: str, runs: int) -> tuple[str, float]:
    """The hash of the first runs, and the seconds of a core for each."""
    text.host(of.folder, of.source, precision)  # compiled once, before the processes
    jobs = os.cpu_count() or 1
    parts = [range(first, min(first + 64, runs)) for first in range(0, runs, 64)]
    with ProcessPoolExecutor(jobs) as pool:
        answers = [*pool.map(flown_by_host, [of] * len(parts), [precision] * len(parts), parts)]
    rows, status = (np.concatenate(part) for part in zip(*(flown for flown, _ in answers), strict=True))
    return digest((rows, status)), float(np.mean([seconds for _, seconds in answers]))


def on_the_card(card: Any, of: Flights, precision: str, sizes: tuple[int, ...], compared: int) -> bool:
    """Hashes and times of one kind of flights, printed; whether the hash is the host's."""
    begun = process_time()
    source = text.device(of.folder, of.source, precision)
    code = machine_code(source, card.architecture)
    kernel = card.kernel(of.folder, of.source, precision)
    print(f"\n{of.name}, {precision}: {len(code)} bytes, made or read in {process_time() - begun:.1f} s of a core")
    for what, value in card.needs(kernel).items():
        print(f"  {what:32} {value}")
    wanted, host_s = on_the_host(of, precision, compared)
    print(f"  {'host, scalar C':32} {wanted}  {1e6 * host_s:.0f} us a run of one core")
    good = True
    for together in BLOCKS:
        found = digest(card.fly(kernel, of.given, SEED, range(compared), of.columns, together))
        good &= found == wanted
        print(f"  {f'card, blocks of {together}':32} {found}  {'equal' if found == wanted else 'DIFFERS'}")
    print(f"  {'runs':>10} {'card, ms':>10} {'us a run':>10} {'and back, ms':>13}")
    for runs in sizes:
        times = []
        for _ in range(REPEATS):
            begun = perf_counter()
            card.fly(kernel, of.given, SEED, range(runs), of.columns)
            times.append((card.flown_s, perf_counter() - begun))
        least, whole = (min(part) for part in zip(*times, strict=True))
        print(f"  {runs:10} {1e3 * least:10.1f} {1e6 * least / runs:10.2f} {1e3 * whole:13.1f}")
    return good


def texts(runs: int) -> bool:
    """Without a card: texts by g++ against scalar C, in both precisions; whether all are equal."""
    good = []
    with TemporaryDirectory() as out:
        for of in (*flights(Path(out), runs), *of_all_models(Path(out))):
            for precision in PRECISIONS:
                wanted, host_s = on_the_host(of, precision, runs)
                library = by_host(text.device(of.folder, of.source, precision), Path(out))
                found = digest(text.fly(library, of.given, SEED, range(runs), of.columns))
                good.append(found == wanted)
                how = "equal" if good[-1] else "DIFFERS"
                print(f"{of.name:26} {precision:7} {1e6 * host_s:6.0f} us a run  {wanted}  g++ {how}", flush=True)
    return all(good)


def of_all_models(out: Path) -> Iterator[Flights]:
    """Short ones, by every measurement."""
    for folder in folders():
        if folder.manifest.get("filter"):
            run, file = run_of(folder, cycles=5, samples=20), out / f"{folder.name}.c"
            file.write_text(run.source)
            yield Flights(f"{folder.name}, in short", folder.path, file, run.given, run.columns)


def command(card: Any, runs: int, compared: int) -> bool:
    """`boresight many` as a user has it, on both."""
    kind = sea.experiment(sea.Sea("sea", 4))
    pair = [many(kind, runs=compared, seed=SEED, device=device).digest for device in ("cpu", "gpu")]
    print(f"\nmany: {compared} runs\n  cpu {pair[0]}\n  gpu {pair[1]}  {'equal' if pair[0] == pair[1] else 'DIFFERS'}")
    sea.shared.cache_clear()
    begun = perf_counter()
    found = many(kind, runs=runs, seed=SEED, device="gpu")
    print(f"many: {runs} runs in {perf_counter() - begun:.1f} s, truth and summaries included\n{found.report()}")
    return pair[0] == pair[1]


def main(words: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--most", type=int, default=SIZES[-1], help="runs at most (%(default)s)")
    parser.add_argument("--texts", type=int, metavar="RUNS", help="no card: g++ against scalar C, of so many runs")
    given = parser.parse_args(words)
    if given.texts:
        return 0 if texts(given.texts) else 1
    most = given.most
    sizes, compared = tuple(size for size in SIZES if size <= most) or (most,), min(COMPARED, most)
    try:
        card = Card()
        print(f"{card.name}, {card.architecture}")
        with TemporaryDirectory() as out:
            good = [
                on_the_card(card, of, precision, sizes, compared)
                for of in flights(Path(out), max(sizes))
                for precision in PRECISIONS
            ]
            good.append(command(card, most, compared))
    except BoresightError as error:
        print(f"gpu: {error}", file=sys.stderr)
        return 1
    return 0 if all(good) else 1


if __name__ == "__main__":
    sys.exit(main())
