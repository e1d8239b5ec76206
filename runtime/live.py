"""The live loop of the generated C, called from Python: what flies here is what flies on the target."""

import copy
import ctypes
from collections.abc import Mapping
from enum import IntEnum
from typing import Any

import numpy as np

from boresight import BoresightError
from boresight.runtime.array import Array
from boresight.runtime.library import Library, load
from boresight.runtime.status import Status

VERSION = 1  # BS_LIVE_VERSION of boresight_live.h
ALL_ROWS = 0xFFFFFFFF


class Fate(IntEnum):
    """bs_msg_fate of boresight_live.h: what became of a message."""

    WAITING = 0
    TAKEN = 1
    IN_PART = 2
    GATED = 3
    OLD = 4
    LATE = 5
    TWICE = 6
    AHEAD = 7
    REFUSED = 8
    FULL = 9
    NOT_READY = 10


class Event(IntEnum):
    """bs_event_code of boresight_live.h: what has happened."""

    BEGUN = 1
    MESSAGE = 2
    GAP = 3
    CLOCK = 4
    REPEATED = 5
    BAD_SAMPLE = 6
    HELD = 7
    SATURATED = 8
    LOST = 9
    ASTRAY = 10
    CORRECTION_LATE = 11
    CORRECTION_REFUSED = 12
    OVERRUN = 13
    STAMPS = 14
    SILENT = 15
    LARGE = 16
    SMALL = 17
    FOLLOWING = 18
    OFF = 19


WORDS = {
    Event.BEGUN: "the loop has begun",
    Event.GAP: "{value} us of samples were missing and are bridged",
    Event.CLOCK: "the sensors' clock stepped by {value} us; the loop goes on in its own",
    Event.REPEATED: "a sample came twice and was left out",
    Event.BAD_SAMPLE: "a sample was left out: {status}",
    Event.HELD: "the strapdown refused a sample ({status}), and the one before was used again",
    Event.SATURATED: "component {which} of the sensors stood at its full scale",
    Event.LOST: "the loop is lost ({value}); begin again",
    Event.ASTRAY: "{value} messages of {measurement} in a row did not fit; the next ones are taken with a larger R",
    Event.CORRECTION_LATE: "a correction came {value} samples too late; raise latency",
    Event.CORRECTION_REFUSED: "a correction would have led out of the model's boxes and was dropped",
    Event.OVERRUN: "the background did not come for too long; {value} samples were not read",
    Event.STAMPS: "the messages' clock has stepped by {value} us and is followed; the delay is doubted",
    Event.SILENT: "no message of {measurement} that could be waited for was measured for {value} us",
    Event.LARGE: "row {row} of {measurement} fits worse than its variance says over {messages} messages",
    Event.SMALL: "row {row} of {measurement} fits better than its variance says over {messages} messages",
    Event.FOLLOWING: "innovations of row {row} of {measurement} follow each other over {messages} messages: an error "
    "that is not white",
    Event.OFF: "innovations of row {row} of {measurement} have a mean over {messages} messages: an error that stays",
}
MESSAGES = {
    Fate.IN_PART: "some rows lay beyond the gate",
    Fate.GATED: "all rows lay beyond the gate",
    Fate.OLD: "it is older than oldest_us",
    Fate.LATE: "one that was measured later had been taken before; raise hold_us",
    Fate.TWICE: "one of the same instant has come before",
    Fate.AHEAD: "its instant lies more than ahead_us ahead of the samples: compare the clocks",
    Fate.REFUSED: "a number is none, or lies outside its box",
    Fate.FULL: "as many messages wait as there is room for",
    Fate.NOT_READY: "the loop is lost, or has not begun",
}


class Layout:
    """The structs of one model's loop, as its header lays them out."""

    def __init__(self, library: Library):
        described = (library.manifest.get("filter") or {}).get("live")
        if described is None:
            raise BoresightError(
                f"{library.name} has no live loop: it is printed for an error state with a strapdown and a feedback"
            )
        self.library, self.described = library, described
        self.real = real = ctypes.c_float if library.precision == "float" else ctypes.c_double
        fields, n = library.field, len(library.states)
        numbers = sum(fields[name]["size"] for name in described["sensed"])

        def struct(name: str, parts: list[tuple[str, Any]]) -> Any:
            return type(name, (ctypes.Structure,), {"_fields_": parts})

        def vector(name: str) -> tuple[str, Any]:
            size = fields[name]["size"]
            return name, real * size if size > 1 else real

        def own(names: list[str]) -> list[tuple[str, Any]]:
            return [(name, struct(name, [vector(field) for field in library.layout[name]])) for name in names]

        carried = library.manifest["filter"]["carried"]
        self.carried = struct("carried", own(carried))
        self.sample = struct("sample", [
            ("at", ctypes.c_int64), ("serial", ctypes.c_uint32), ("dt", real), *map(vector, described["sensed"])
        ])  # fmt: skip
        gates = struct("gates", [("rows", ctypes.c_uint), ("gate", real), ("joint", real),
                                 ("iterations", ctypes.c_int), ("options", ctypes.c_uint)])  # fmt: skip
        us = ("jitter_us", "bridge_us", "oldest_us", "hold_us", "ahead_us", "half_us", "silent_us")
        self.rules = struct("rules", [
            *((name, ctypes.c_int32) for name in us),
            *((name, ctypes.c_uint16) for name in ("every", "latency", "astray")),
            ("gates", gates), ("open", real * n), ("full_scale", real * numbers), *own(described["rules"]),
        ])  # fmt: skip
        self.message = struct("message", [
            *((name, ctypes.c_uint16) for name in ("version", "size", "measurement")), ("rows", ctypes.c_uint32),
            ("at", ctypes.c_int64), ("variance", real * described["variances"]),
            *([("z", real * described["z"])] if described["z"] else []), *own(described["message"]),
        ])  # fmt: skip
        self.output = struct(
            "output",
            [("at", ctypes.c_int64), ("state", ctypes.c_int), ("carried", self.carried), ("shift", ctypes.c_int64)],
        )
        self.event = struct("event", [("code", ctypes.c_ubyte), ("which", ctypes.c_ubyte), ("sample", ctypes.c_uint32),
                                      ("value", ctypes.c_int32)])  # fmt: skip
        m = max(one["m"] for one in library.manifest["filter"]["measurements"].values())
        self.measured = struct("measured", [
            ("count", ctypes.c_uint32), ("order", ctypes.c_uint32), ("measurement", ctypes.c_uint16),
            ("fate", ctypes.c_int), ("at", ctypes.c_int64),
            ("nu", real * m), ("S", real * m), ("nis", real), ("used", ctypes.c_uint), ("inflated", ctypes.c_uint),
        ])  # fmt: skip
        names = ("samples", "missing", "held", "bad", "repeated", "clock_steps", "saturated", "silences", "unlikely")
        after = ("corrections", "corrections_late", "corrections_refused", "overruns", "events_lost")
        self.counts = struct("counts", [*((name, ctypes.c_uint32) for name in names),
                                        ("fate", ctypes.c_uint32 * len(Fate)),
                                        *((name, ctypes.c_uint32) for name in after)])  # fmt: skip

    def owner(self, of: Any, name: str) -> str:
        """The struct of a struct of structs that has a field of this name; "" where none has it."""
        return next((s for s, _ in of._fields_ if name in self.library.layout.get(s, ())), "")

    def place(self, into: Any, name: str, value: Any, function: str) -> None:
        """Write a field by its name into a struct of structs.  Raises BoresightError on a shape that does not fit."""
        size = self.library.field[name]["size"]
        array = np.asarray(value, dtype=float)
        if array.shape != (() if size == 1 else (size,)) and array.shape != (size,):
            raise BoresightError(f"{function}: {name} has shape {array.shape}; give ({size},)")
        owner = getattr(into, self.owner(into, name))
        setattr(owner, name, float(array.item()) if size == 1 else (self.real * size)(*array))

    def values(self, struct: Any) -> dict[str, Array]:
        """Every field of a struct of structs, by name."""
        found = {}
        for owner, _ in struct._fields_:
            for name in self.library.layout[owner]:
                value = getattr(getattr(struct, owner), name)
                found[name] = np.array(value, dtype=float)
        return found


def shaped(what: str, value: Any, shape: tuple[int, ...]) -> Array:
    """An array of this shape.  Raises BoresightError."""
    array = np.asarray(value, dtype=float)
    if array.shape != shape:
        raise BoresightError(f"{what} has shape {array.shape}; give {shape}")
    return array


class Live:
    """The live loop of a model: samples and late messages in, navigation out; by the exported C.

    One run.  Instants are integers of microseconds of the sensors' clock; all else is SI and rad.

    Parameters
    ----------
    model : Library or str
        Of `load`, or its name; in double or float.
    rules : mapping of str to value, optional
        Of PREFIX_live_rules, such as `hold_us` or `every`; `gate` and `joint` stand for those of
        `gates`.
    **constants : array
        What the model's functions read beside the sensors and the messages, such as the root
        densities of the noises; what is not given is zero.  One that the model carries is where
        `begin` puts it.

    Raises
    ------
    BoresightError
        A model without a loop, a rule or a constant that it does not have.

    Notes
    -----
    When not to use it: for many runs side by side; `CompiledFilter` and `Epoch` take these.

    Examples
    --------
    >>> import numpy as np
    >>> from boresight import Live
    >>> loop = Live("velocity-attitude", gyro_noise=np.full(3, 6e-5), accel_noise=np.full(3, 1e-3))
    >>> loop.begin(0, {"lat_lon_height": [0.6, 0.1, 0], "v_n": np.zeros(3), "q_b2n_wxyz": [1, 0, 0, 0],
    ...                "q_b2m_wxyz": [1, 0, 0, 0]}, phi=0.02, dv_n=1.0, d_tau=0.05)
    >>> for k in range(1, 101):
    ...     status = loop.sample(10_000 * k, 0.01, dtheta_ib_b=np.zeros(3), dv_b=[0, 0, -0.0979])
    ...     if k % 20 == 0:
    ...         fate = loop.message("velocity", 10_000 * k, np.full(3, 4e-4), v_m_n=np.zeros(3))
    >>> loop.counts()["TAKEN"]
    4
    """

    def __init__(self, model: Any, rules: Mapping[str, Any] | None = None, **constants: Any):
        self.library: Library = load(model) if not isinstance(model, Library) else model
        self.layout = Layout(self.library)
        self.kinds = {name: m["index"] for name, m in self.library.manifest["filter"]["measurements"].items()}
        self.rules = self.layout.rules()
        self._function("defaults")(ctypes.byref(self.rules))
        self._memory = ctypes.create_string_buffer(self._function("size", size=True)())
        self._sample, self._background = self._function("sample"), self._function("background")
        for name, value in (rules or {}).items():
            self._rule(name, value)
        known = {name for s in self.layout.described["rules"] for name in self.library.layout[s]}
        self._carried: dict[str, Any] = {}
        for name, value in constants.items():
            if self.layout.owner(self.layout.carried, name):
                self._carried[name] = value
                continue
            if name not in known:
                raise BoresightError(
                    f"live: {self.library.name} has no constant {name!r}; it has {', '.join(sorted(known))}"
                )
            self.layout.place(self.rules, name, value, "live")

    def _rule(self, name: str, value: Any) -> None:
        owner = self.rules.gates if name in ("gate", "joint") else self.rules
        if not hasattr(owner, name) or name in self.library.layout:
            names = [n for n, _ in self.layout.rules._fields_ if n not in ("gates", *self.library.layout)]
            raise BoresightError(f"live: there is no rule {name!r}; there are gate, joint, {', '.join(names)}")
        size = getattr(getattr(owner, name), "_length_", 0)
        setattr(owner, name, (self.layout.real * size)(*np.broadcast_to(value, size)) if size else value)

    def _function(self, name: str, size: bool = False) -> Any:
        suffixes = ("_f32", "_f32_joseph") if self.library.precision == "float" else ("",)
        base = f"{self.library.manifest['c_prefix']}_live_{name}"
        found = next(getattr(self.library.dll, base + s) for s in suffixes if hasattr(self.library.dll, base + s))
        found.restype = ctypes.c_size_t if size else ctypes.c_int
        return found

    def _call(self, name: str, *arguments: Any) -> int:
        passed = [
            a if isinstance(a, (ctypes.Array, ctypes.c_int64, ctypes._Pointer)) or a is None else ctypes.byref(a)
            for a in arguments
        ]
        return int(self._function(name)(self._memory, *passed))

    def begin(
        self, at_us: int, nav: Mapping[str, Any], sigma: Any = None, *, P: Any = None, considered: Any = None,
        **sigmas: Any,
    ) -> None:  # fmt: skip
        """Begin with what is known at an instant.

        Parameters
        ----------
        at_us : int
            us; the next sample's interval begins here.
        nav : mapping of str to array
            The carried fields; one that is not given is zero.
        sigma : (n,) array, optional
            Of each state; or by block:
        P : (n, n) array, optional
            The covariance as a whole, in place of sigmas.
        considered : (n,) array of bool, optional
            States that no measurement corrects (Schmidt).
        **sigmas : float or (size,) array
            By block of states, as `phi=0.02`; a block that is not given has zero.

        Raises
        ------
        BoresightError
            A field or a block that the model does not have, and what the C refuses.
        """
        carried = self.layout.carried()
        for name, value in {**self._carried, **nav}.items():
            if not self.layout.owner(carried, name):
                raise BoresightError(f"begin: {self.library.name} does not carry {name!r}")
            self.layout.place(carried, name, value, "begin")
        spread = np.zeros(len(self.library.states)) if sigma is None else np.array(sigma, dtype=float)
        start = 0
        for block in self.library.manifest["blocks"]:
            end = start + block["size"]
            spread[start:end] = sigmas.pop(block["name"], spread[start:end])
            start = end
        if sigmas:
            names = ", ".join(block["name"] for block in self.library.manifest["blocks"])
            raise BoresightError(f"begin: there is no block {next(iter(sigmas))!r} of states; there are {names}")
        n = len(spread)
        calls: list[tuple[str, list[Any], str]] = [
            ("begin", [self.rules, ctypes.c_int64(int(at_us)), carried, (self.layout.real * n)(*spread)],
             "a rule, nav or a sigma lies outside its range"),
        ]  # fmt: skip
        if P is not None:
            dense = (self.layout.real * n**2)(*shaped("begin: P", P, (n, n)).ravel())
            calls.append(("set_covariance", [dense], "P is no covariance of this model"))
        if considered is not None:
            flags = (ctypes.c_ubyte * n)(*shaped("begin: considered", considered, (n,)).astype(bool).tolist())
            calls.append(("consider", [flags], "P is no covariance of this model"))
        for name, arguments, why in calls:
            if status := self._call(name, *arguments):
                ctypes.memset(self._memory, 0, len(self._memory))  # no half of a beginning
                raise BoresightError(f"begin: {Status(status).name.lower()}: {why}")

    def sample(self, at_us: Any, dt: Any, *, serial: Any = 0, background: bool = True, **sensed: Any) -> Array:
        """One sample of the sensors, or several one after the other, each with all that is to be done behind it.

        Parameters
        ----------
        at_us : int or (K,) array of int
            us, when the interval ends, by the sensors' clock.
        dt : float or (K,) array
            s, the length of the interval.
        serial : int or (K,) array of int, optional
            Counts samples; 0 where there is no counter.
        background : bool, optional
            Whether all is done that is to be done behind each sample; else call `background`.
        **sensed : (size,) or (K, size) array
            What the sensors deliver, such as `dtheta_ib_b` and `dv_b`.

        Returns
        -------
        (...,) array of int
            Status of the C; 0 where it was taken.

        Raises
        ------
        BoresightError
            A name or a shape that does not fit; what a number is, the C judges.
        """
        given = self._samples(at_us, dt, serial, sensed)
        status = [self._taken(given.ctypes.data + k * given.itemsize, background) for k in range(given.size)]
        return np.array(status).reshape(given.shape)

    def _samples(self, at_us: Any, dt: Any, serial: Any, sensed: dict[str, Any]) -> Array:
        """Samples as the C reads them."""
        if set(sensed) != set(self.layout.described["sensed"]):
            names = ", ".join(self.layout.described["sensed"])
            raise BoresightError(
                f"sample: {self.library.name} reads {names}; it was given {', '.join(sensed) or 'nothing'}"
            )
        given = np.zeros(np.shape(at_us), self.layout.sample)
        try:
            given["at"], given["dt"], given["serial"] = at_us, dt, serial
            for name, value in sensed.items():
                given[name] = value
        except (TypeError, ValueError) as error:
            raise BoresightError(f"sample: {error}") from None
        return given

    def _taken(self, address: int, background: bool) -> int:
        status = self._sample(self._memory, ctypes.c_void_p(address))
        while background and self._background(self._memory) == 0:
            pass
        return int(status)

    def background(self) -> bool:
        """Do one thing that is to be done.

        Returns
        -------
        bool
            False where there was nothing.
        """
        return self._background(self._memory) == Status.OK

    def message(self, measurement: str, at_us: int, variance: Any, *, rows: int = ALL_ROWS, **fields: Any) -> Fate:
        """One measurement; what becomes of it is counted when its turn comes.

        Parameters
        ----------
        measurement : str
            Its name in the model.
        at_us : int
            us, when it was measured, by the sensors' clock as far as the message knows.
        variance : (m,) array
            R, the squares of its sigmas; (m, m) of one with correlated rows.
        rows : int, optional
            Bit i: row i is there.
        **fields : array
            What its functions read beside the navigation and the sensors.

        Returns
        -------
        Fate
            WAITING, or why it was refused at once.
        """
        if measurement not in self.kinds:
            raise BoresightError(
                f"message: {self.library.name} has no measurement {measurement!r}; it has {', '.join(self.kinds)}"
            )
        given = self.layout.message(
            VERSION, ctypes.sizeof(self.layout.message), self.kinds[measurement], rows, int(at_us)
        )
        variances = np.asarray(variance, dtype=float).ravel()
        given.variance[: len(variances)] = list(variances)
        for name, value in fields.items():
            if name == "z":
                given.z[: np.size(value)] = list(np.ravel(value))
            elif not self.layout.owner(given, name):
                raise BoresightError(f"message: {measurement} reads no {name!r} of a message")
            else:
                self.layout.place(given, name, value, measurement)
        fate = ctypes.c_int()
        self._call("message", given, fate)
        return Fate(fate.value)

    def output(self, at_us: int) -> dict[str, Array]:
        """The navigation at an instant not before the newest sample; {} where there is none.

        Parameters
        ----------
        at_us : int
            us, by the sensors' clock.

        Returns
        -------
        dict of str to array
            The carried fields; `sigma` (n,) of the states as the covariance has it; `shift`, s, that is
            added to the stamps of messages whose delay is a state, since their clock has stepped.
        """
        out = self.layout.output()
        sigma = (self.layout.real * len(self.library.states))()
        if self._call("output", ctypes.c_int64(int(at_us)), out):
            return {}
        self._call("sigmas", sigma, None)
        shift = np.array(1e-6 * out.shift)
        return {**self.layout.values(out.carried), "sigma": np.array(sigma, dtype=float), "shift": shift}

    def covariance(self) -> tuple[Array, int]:
        """The covariance of the state.

        Returns
        -------
        P : (n, n) array
            In the units of the states.
        at_us : int
            us, the instant that it has reached, by the sensors' clock.
        """
        n, at = len(self.library.states), ctypes.c_int64()
        P = (self.layout.real * n**2)()
        self._call("covariance", P, ctypes.pointer(at))
        return np.array(P, dtype=float).reshape(n, n), at.value

    def counts(self) -> dict[str, int]:
        """What has been counted since the loop began.

        Returns
        -------
        dict of str to int
            Fates of messages by their names, and what became of samples and corrections.
        """
        counted = self.layout.counts()
        self._call("counted", counted)
        fates = {fate.name: int(counted.fate[fate]) for fate in Fate if fate}
        return fates | {name: getattr(counted, name) for name, _ in self.layout.counts._fields_ if name != "fate"}

    def measured(self) -> dict[str, Any]:
        """The last measurement that the filter has judged; {} before the first.

        Returns
        -------
        dict of str to value
            `count` of those until then, `order` of the message among those that were put to wait,
            from 0; `measurement`, `fate`, `at_us` its instant; of its rows
            `nu` (m,) the innovation given the rows before, `S` (m,) the variance of that, `used`
            (m,) bool; `nis` of those used.  Several may be judged in one call of `sample`: read
            it between two of `background`.
        """
        found = self.layout.measured()
        if self._call("measured", found):
            return {}
        name = next(name for name, index in self.kinds.items() if index == found.measurement)
        m = self.library.manifest["filter"]["measurements"][name]["m"]
        return {
            "count": found.count, "order": found.order, "measurement": name, "fate": Fate(found.fate),
            "at_us": found.at, "nis": found.nis, "nu": np.array(found.nu[:m]), "S": np.array(found.S[:m]),
            "used": np.array([bool(found.used >> i & 1) for i in range(m)]),
        }  # fmt: skip

    def events(self) -> list[str]:
        """What has happened since the last call.

        Returns
        -------
        list of str
            One line for each event; of the last sixteen of each context, see `events_lost`.
        """
        lines, event = [], self.layout.event()
        while self._call("next_event", event) == Status.OK:
            kind = next((name for name, index in self.kinds.items() if index == event.which), "?")
            if event.code == Event.MESSAGE:
                taken = "in part" if event.value == Fate.IN_PART else "not"
                text = f"a message of {kind} was {taken} taken: {MESSAGES[Fate(event.value)]}"
            else:
                status = Status(event.value).name if 0 <= event.value < len(Status) else str(event.value)
                text = WORDS[Event(event.code)].format(
                    value=event.value,
                    which=event.which,
                    measurement=kind,
                    status=status,
                    row=event.value % 32,
                    messages=event.value // 32,
                )
            lines.append(f"sample {event.sample}: {text}")
        return lines

    def snapshot(self) -> bytes:
        """All of the loop, for `restore`.

        Returns
        -------
        bytes
            Of this model, precision and version alone.

        Raises
        ------
        BoresightError
            The loop is being written.
        """
        room = ctypes.create_string_buffer(self._function("snapshot_size", size=True)())
        if self._call("snapshot", room):
            raise BoresightError("snapshot: the loop was being written")
        return room.raw

    def restore(self, snapshot: bytes) -> None:
        """Go on from a snapshot.

        Parameters
        ----------
        snapshot : bytes
            Of `snapshot`.

        Raises
        ------
        BoresightError
            It is of another loop, or has changed.
        """
        size = self._function("snapshot_size", size=True)()
        if len(snapshot) != size or self._call("restore", (ctypes.c_char * size).from_buffer_copy(snapshot)):
            raise BoresightError("restore: this is no snapshot of this loop, or it has changed")

    def digest(self) -> str:
        """Of what the loop knows: equal on two machines that have flown the same.

        Returns
        -------
        str
            SHA-256, hexadecimal.
        """
        digest = (ctypes.c_ubyte * 32)()
        self._call("digest", digest)
        return bytes(digest).hex()

    def __copy__(self) -> "Live":
        made = object.__new__(type(self))
        made.__dict__ |= self.__dict__
        made._memory = ctypes.create_string_buffer(self._memory.raw, len(self._memory))
        made.rules = copy.copy(self.rules)
        return made

    def __deepcopy__(self, memo: Any) -> "Live":
        return self.__copy__()
