"""The steps of a live loop, for a `Record`: what each call of its background changed in the memory of the C.

nav of a step is the filter's own at the instant that the covariance has reached: what was flown there, with the errors
that are known and not taken out of it yet.  So a correction that reaches the newest sample later is none of the steps.
"""

import copy
import ctypes
import functools
import json
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from boresight.runtime.array import Array
from boresight.runtime.compiler import PRECISIONS, open_library, shared_library
from boresight.runtime.filter.memory import packed
from boresight.runtime.library import Library
from boresight.runtime.live import Live

IDLE, SETTLE, POST = 0, 5, 6  # stages of a measurement, of PREFIX_live.c
WATCHED = {"since": ctypes.c_int64, "at": ctypes.c_int64, "measuring.stage": ctypes.c_uint16} | dict.fromkeys(
    ("behind", "passed", "opening", "judged.count", "counts.overruns"), ctypes.c_uint32
)
Place = tuple[bytes, bytes]


class Step(NamedTuple):
    """A step, in bytes as they lie in the C.

    at_us: by the loop's own clock.  x: what a measurement has found, and no feedback has taken out.  place: all that
    is carried, then the error that is known in it; and the entry of the past that holds what of it the
    strapdown moves, or b"" where that is so already.  given: of a prediction and of inflate P before it, and all from
    what is carried to Phi; of a measurement judged and H; of a feedback what was carried before it.
    """

    name: str
    at_us: int
    P: bytes
    x: bytes
    place: Place
    given: tuple[bytes, ...]


class Recorded(Live):
    """A loop that tells its record of what it does."""

    steps: "LiveSteps"

    def begin(self, *args: Any, **words: Any) -> None:
        super().begin(*args, **words)
        self.steps.begin()

    def restore(self, snapshot: bytes) -> None:
        super().restore(snapshot)
        self.steps.begin()

    def _taken(self, address: int, background: bool) -> int:
        status, did = self._sample(self._memory, ctypes.c_void_p(address)), self.steps.did
        while background and self._background(self._memory) == 0:
            did()
        return int(status)

    def background(self) -> bool:
        more = super().background()
        if more:
            self.steps.did()
        return more

    def __copy__(self) -> Live:
        made = super().__copy__()
        made.__class__ = Live
        del made.__dict__["steps"]
        return made


class LiveSteps:
    """What stands between a loop and its record.

    add: gets each Step, and None where a piece begins.  again: gets the Place of the last one when it is known better.
    """

    def __init__(self, loop: Live, add: Callable[[Step | None], None], again: Callable[[Place], None]):
        library, described = loop.library, loop.library.manifest["filter"]
        self.loop, self.library, self.add, self.again = loop, library, add, again
        self.carried, self.moved = described["carried"], described["strapdown"]["written"]
        self.kinds = {index: name for name, index in loop.kinds.items()}
        self.n, self.real = len(library.states), np.dtype(library.real)
        self.at = at = places(library, self.moved)
        word = {name: kind.from_buffer(loop._memory, at[name]) for name, kind in WATCHED.items()}
        self.since, self.now, self.stage, self.behind, self.passed, self.opening, self.count, self.overruns = (
            word.values()
        )
        self.judged = loop.layout.measured.from_buffer(loop._memory, at["judged"])
        self.memory = memoryview(loop._memory).cast("B")
        self.ring = (at["waiting"] - at["past"]) // at["one past"]
        size = self.real.itemsize
        self.P_bytes, self.none = self.n * (self.n + 1) // 2 * size, bytes(self.n * size)
        self.P = self.nav = self.H = b""
        self.loop.__class__, self.loop.steps = Recorded, self  # type: ignore[attr-defined]
        self.begin()

    def stop(self) -> None:
        self.loop.__class__ = Live
        del self.loop.__dict__["steps"]

    # ------------------------------------------------------------ while it flies

    def begin(self) -> None:
        """A piece begins, of a loop that has begun."""
        if any(self._bytes("flown", "x")):
            self.add(None)
            self._step("begin", self._flown())
        self._look()

    def _look(self) -> None:
        self.last = (
            self.since.value, self.stage.value, self.passed.value, self.opening.value, self.count.value,
            self.overruns.value,
        )  # fmt: skip

    def did(self) -> None:
        """The background was called, and did something: the step that it made, if any."""
        since, stage, passed, opening, count, overruns = self.last
        new = self.stage.value
        if self.overruns.value != overruns:  # how the errors moved meanwhile is not known
            self.begin()
        elif self.since.value != since:
            place = self._flown()
            self._step("predict", place, given=(self.P, place[0]))
        elif new == stage != IDLE:
            return  # pieces of one stage
        elif stage == IDLE != new:  # the filter has the navigation of the message's instant
            self.nav, self.H = self._bytes("filter", "filter.x"), self._bytes("measuring.H", "measuring.before")
            self.again((self.nav + self.none, b""))
        elif new == SETTLE or (new == IDLE and self.count.value != count):
            x = self._bytes("filter.x", "filter.P") if new else self.none  # no row was used
            given = (bytes(self.judged), self.H)
            self._step(self.kinds[self.judged.measurement], (self.nav + self.none, b""), x, given)
        elif new == POST:
            self._step("feedback", (self._bytes("filter", "filter.P"), b""), given=(self.nav,))
        elif opening and not self.opening.value:
            self._step("inflate", self._flown(), given=(self.P,))
        elif self.passed.value != passed:  # what was flown has been corrected since, and less of its error is known
            self.again(self._flown())
        self._look()

    def _bytes(self, name: str, end: str) -> bytes:
        return bytes(self.memory[self.at[name] : self.at[end]])

    def _flown(self) -> Place:
        """Of the newest sample that the covariance has come by."""
        entry = self.at["past"] + self.behind.value % self.ring * self.at["one past"]
        return self._bytes("flown", "Phi_dt"), bytes(self.memory[entry : entry + self.at["one past"]])

    def _step(self, name: str, place: Place, x: bytes | None = None, given: tuple[bytes, ...] = ()) -> None:
        first = self.at["filter.P"]
        self.P = bytes(self.memory[first : first + self.P_bytes])
        self.add(Step(name, self.now.value, self.P, self.none if x is None else x, place, given))

    # ------------------------------------------------------------ when it is read

    def arrays(self, steps: Sequence[Step]) -> tuple[Array, Array, dict[str, Array], list[dict[str, Array]]]:
        """x, the triangle of P, and nav by field after each of K steps, and what each was given, as `Record` has it."""
        P = self._covariances([s.P for s in steps])
        given: list[dict[str, Array]] = [{} for _ in steps]
        rows = {name: [k for k, s in enumerate(steps) if s.name == name] for name in ("predict", "inflate", "feedback")}
        if some := rows["predict"]:
            (moves, rest), after = self._moves, self.at["Phi"] - self.at["flown"]
            Phi = np.tensordot(self._numbers([steps[k].given[1][after:] for k in some]), moves, 1) + rest
            before = self._covariances([steps[k].given[0] for k in some])
            Q = P[some] - Phi @ before @ np.swapaxes(Phi, -1, -2)
            for i, k in enumerate(some):
                given[k] = {"Phi": Phi[i], "Q": (Q[i] + Q[i].T) / 2}
        for k in rows["inflate"]:
            (before,) = self._covariances([steps[k].given[0]])
            variance = np.diagonal(P[k] - before)
            given[k] = {"first": np.zeros(()), "count": np.ones(()), "variance": np.maximum(variance, 0.0)}
        for k in rows["feedback"]:
            given[k] = {f"nav {name}": value[0] for name, value in self._fields([steps[k].given[0]]).items()}
        for k, step in enumerate(steps):
            if step.name in self.loop.kinds:
                given[k] = self._innovation(*step.given)
        x, nav = self._numbers([s.x for s in steps]), self._navigations([s.place for s in steps])
        return x, P[(..., *packed(self.n)[0])], nav, given

    def _numbers(self, parts: Sequence[bytes]) -> Array:
        """(K, ...) of parts of one length."""
        return np.frombuffer(b"".join(parts), self.real).reshape(len(parts), -1).astype(float)

    def _covariances(self, parts: Sequence[bytes]) -> Array:
        """(K, n, n) of P in the form of the precision."""
        other, first = copy.copy(self.loop), self.at["filter.P"]
        room = memoryview(other._memory).cast("B")
        out = np.empty((len(parts), self.n, self.n))
        for k, part in enumerate(parts):
            room[first : first + self.P_bytes] = part
            out[k] = other.covariance()[0]
        return out

    def _fields(self, parts: Sequence[bytes]) -> dict[str, Array]:
        """All that is carried, by field, (K, size) or (K,)."""
        numbers, first, found = self._numbers(parts), 0, {}
        for struct in self.carried:
            for name, place in self.library.layout[struct].items():
                found[name] = numbers[:, first + place.start : first + place.stop]
            first += self.library.width[struct]
        return {name: value[:, 0] if self.library.field[name]["size"] == 1 else value for name, value in found.items()}

    def _navigations(self, places: Sequence[Place]) -> dict[str, Array]:
        """nav by field, with what is known of its error taken out."""
        ends = self.at["x"] - self.at["flown"], self.at["Phi"] - self.at["flown"]
        found = {name: value.copy() for name, value in self._fields([each[: ends[0]] for each, _ in places]).items()}
        rows = [k for k, (_, past) in enumerate(places) if past]
        for name in self.moved if rows else ():
            size, first = self.library.field[name]["size"], self.at[f"past.{name}"]
            last = first + size * self.real.itemsize
            values = self._numbers([places[k][1][first:last] for k in rows])
            found[name][rows] = values[:, 0] if size == 1 else values
        known = {**found, "x": self._numbers([each[slice(*ends)] for each, _ in places])}
        fed = self.library.feedback
        out = fed(**{name: known[name] for name in fed.fields})
        return found | (out if isinstance(out, dict) else {fed.described["results"][0]["name"]: out})

    def _innovation(self, judged: bytes, H: bytes) -> dict[str, Array]:
        one = self.loop.layout.measured.from_buffer_copy(judged)
        m = self.library.manifest["filter"]["measurements"][self.kinds[one.measurement]]["m"]
        bits = {"used": one.used, "inflated": one.inflated}
        return {
            "nu": np.array(one.nu[:m]), "S": np.array(one.S[:m]), "nis": np.array(one.nis),
            "H": self._numbers([H])[0, : m * self.n].reshape(m, self.n),
            **{name: np.array([word >> i & 1 for i in range(m)], float) for name, word in bits.items()},
        }  # fmt: skip

    @functools.cached_property
    def _moves(self) -> tuple[Array, Array]:
        """(M, n, n), which each of M numbers of Phi in the C stands for, and (n, n) what is always there."""
        prefix, dll = self.library.manifest["c_prefix"], self.library.dll
        function = getattr(dll, f"{prefix}_predict_state" + ("_f32" if self.library.precision == "float" else ""))
        count = (self.at["Phi_dt"] - self.at["Phi"]) // self.real.itemsize

        def carried(numbers: Array) -> Array:
            columns = np.eye(self.n, dtype=self.real)
            for column in columns:
                function(*(ctypes.c_void_p(array.ctypes.data) for array in (numbers, column)))
            return columns.T.astype(float)

        rest = carried(np.zeros(count, self.real))
        return np.array([carried(one) - rest for one in np.eye(count, dtype=self.real)]), rest


def places(library: Library, moved: Sequence[str]) -> dict[str, int]:
    """Where the parts of a model's loop lie in its memory, as the compiler of this machine has them."""
    prefix, header = library.manifest["c_prefix"], library.name.replace("-", "_")
    first = library.manifest["filter"]["carried"][0]
    whole = (*WATCHED, "at", "behind", "past", "waiting", "flown", "x", "Phi", "Phi_dt", "judged", "measuring.H",
             "measuring.before", "filter.x", "filter.P")  # fmt: skip
    found = {name: f"offsetof({prefix}_live, {name})" for name in whole}
    found |= {"filter": f"offsetof({prefix}_live, filter.{first})", "one past": f"sizeof({prefix}_past)"}
    found |= {f"past.{name}": f"offsetof({prefix}_past, {name})" for name in moved}
    text = (
        f'#include <stddef.h>\n#include "{header}_live.h"\n'
        "extern const size_t boresight_places[];\n"
        f"const size_t boresight_places[] = {{ {', '.join(found.values())} }};\n"
    )
    assert library.folder is not None
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder) / "places.c"
        source.write_text(text)
        contents = text + json.dumps(library.manifest["files"], sort_keys=True)
        made = shared_library(f"{header}-places", contents, {source: ()}, library.folder / "include",
                              PRECISIONS[library.precision])  # fmt: skip
    values = (ctypes.c_size_t * len(found)).in_dll(open_library(*made), "boresight_places")
    return dict(zip(found, values, strict=True))
