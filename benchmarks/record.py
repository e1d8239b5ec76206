"""What a record adds to the flight that it is of: python -m benchmarks.record

GNSS/INS in 20 runs, as examples/fly_gnss_ins.py flies it for 40 s: processor time without a record, with one in memory
and with one in files, in turn; the least of 25, after one flight that compiles.
"""

import sys
import tempfile
from importlib import import_module
from pathlib import Path
from time import process_time
from typing import Any

from boresight import CompiledFilter, Record, generate, load

EXAMPLES = Path(__file__).resolve().parent.parent / "examples"
SECONDS, REPEATS = 40, 25


def main() -> None:
    sys.path.insert(0, str(EXAMPLES))
    example: Any = import_module("fly_gnss_ins")

    example.SECONDS = SECONDS
    least: dict[str, float] = {}
    with tempfile.TemporaryDirectory() as aside:
        library = load(generate(f"{EXAMPLES / 'gnss_ins.py'}:GNSS_INS", Path(aside) / "gnss_ins").folder)
        for i in range(REPEATS + 1):
            for name in ("without", "in memory", "in files"):
                took = flown(example, library, name, Path(aside) / f"{i}")
                if i:
                    least[name] = min(least.get(name, took), took)
    for name, took in least.items():
        print(f"{name:10} {1e3 * took:6.1f} ms  {took / least['without']:.3f}")


def flown(example: Any, library: Any, name: str, folder: Path) -> float:
    records: list[Record] = []

    def kind(*args: Any, **words: Any) -> CompiledFilter:
        loop = CompiledFilter(*args, **words)
        if name != "without":
            records.append(Record(loop, folder if name == "in files" else None))
        return loop

    example.CompiledFilter = kind
    begin = process_time()
    example.fly(library)
    for record in records:
        record.stop()
    return process_time() - begin


if __name__ == "__main__":
    main()
