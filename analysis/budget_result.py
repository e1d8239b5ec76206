"""What an error budget found: as text of 80 columns, CSV, JSON and a figure; and which source must get better."""

import csv
import io
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from textwrap import wrap
from typing import Any

import numpy as np

from boresight.analysis.figures import BLUE, GREEN, GREY, ORANGE, Sheets
from boresight.errors import BoresightError, did_you_mean
from boresight.runtime.array import Array
from boresight.runtime.units import UNITS

ADDED = "added on purpose"
SHOWN = {"rad": ("mrad", "rad"), "rad/s": ("deg/h", "deg/s"), "m/s^2": ("mg", "m/s^2"), "s": ("ms", "s"),
         "1": ("ppm", "1")}  # fmt: skip
LARGEST = 1e3  # beyond it the next unit is taken
ROUNDING = 1e-14  # share of a variance
ACROSS = 3  # states beside each other
COLOURS = (BLUE, ORANGE, GREEN, "#8fbfe0", "#f2bd8c", "#a9cfae")
TIMES = 61  # in a file, at most
GRID = np.array([0.0, 0.05, 0.1, 0.2, 0.35, 0.5, 0.7, 0.85])  # of a source, tried by itself


@dataclass(frozen=True)
class Budget:
    """What `budget` found.  T times, S sources, n states; SI and rad, as the model.

    blocks: variable of the model -> its places among the states.
    variances: (T, S, n) of the true error by source.  whole: (T, n) of all together, propagated by itself.
    known, offsets: the known constants that the filter ignores, and what each makes, (T, O, n).  offset: (T, n), the
    mean of the error, of these and of inputs that are believed wrongly; estimated - true of a total state, and of an
    error state what is left in it.
    design: (T, S, n) of the filter's own P by what it believes; P_variances: (T, n), the diagonal of its P.
    P, C: (n, n) at the end, the filter's and the true one; by_source: (S, n, n), of C.
    scaled: of factors by source, (B,) each, the true mean squares (B, n) at the end where the filter knows of them.
    """

    model: str
    states: tuple[str, ...]
    units: tuple[str, ...]
    blocks: Mapping[str, Sequence[int]]
    sources: tuple[str, ...]
    times: Array
    variances: Array
    whole: Array
    known: tuple[str, ...]
    offsets: Array
    offset: Array
    design: Array
    P_variances: Array
    P: Array
    C: Array
    by_source: Array
    scaled: Callable[[Mapping[str, Array]], Array] = field(repr=False)

    @cached_property
    def sigma(self) -> Array:
        """(T, n) one sigma of the true error about its mean."""
        return np.sqrt(self.whole)

    @cached_property
    def rms(self) -> Array:
        """(T, n) of the true error, mean and spread."""
        return np.sqrt(self.whole + self.offset**2)

    # ---- which part is asked for

    def places(self, name: str) -> list[int]:
        """Of a state, by its name or as the model's page writes its letter, or of all states of a block.

        "heading" is the attitude's third.  Raises BoresightError with the list.
        """
        folded = [state.lower() for state in self.states]
        if name.lower() in folded:  # phi_N is the letter of phi_n
            return [folded.index(name.lower())]
        if name in self.blocks:
            return list(self.blocks[name])
        downs = [i for i, state in enumerate(self.states) if state in ("phi_d", "phi_u", "eps_d", "psi_u", "psi_d")]
        if name == "heading" and downs:
            return downs[:1]
        listed = [
            *self.states,
            *(block for block in self.blocks if block not in self.states),
            *["heading"][: len(downs)],
        ]
        raise BoresightError(f"{self.model} has no state {name!r}{did_you_mean(name, listed)}; it has "
                             f"{', '.join(listed)}")  # fmt: skip

    def state(self, name: str) -> int:
        """The one place of a name.  Raises BoresightError with the list."""
        places = self.places(name)
        if len(places) > 1:
            raise BoresightError(f"{name} is {len(places)} states: name one of "
                                 f"{', '.join(self.states[i] for i in places)}")  # fmt: skip
        return places[0]

    def at(self, time: float) -> int:
        """The last kept time that is not after this one."""
        if not self.times[0] <= time <= self.times[-1] + 1e-9:
            raise BoresightError(f"there is no time {time:g} s; the motion lasts from {self.times[0]:g} to "
                                 f"{self.times[-1]:g} s")  # fmt: skip
        return int(np.searchsorted(self.times, time + 1e-9, "right")) - 1

    def unit(self, i: int) -> tuple[str, float]:
        """In which unit a state is shown, and its factor to SI."""
        si = self.units[i]
        kind = next((units for units in UNITS.values() if units.get(si) == 1.0), {si: 1.0})
        names = SHOWN.get(si, (si,))
        largest = max(self.rms[-1, i], np.sqrt(self.P_variances[-1, i]))
        return next(((one, kind[one]) for one in names if one in kind and largest / kind[one] < LARGEST),
                    (si, 1.0))  # fmt: skip

    # ---- as text, CSV and JSON

    def report(self, times: Sequence[float] = (), states: Sequence[str] = (), title: str = "") -> str:
        """Tables of sources and states at these times, s, the end if none: one sigma, and its share of the variance.

        A dash stands for nothing, or for what rounding leaves of it.
        """
        places = [i for name in states for i in self.places(name)] or list(range(len(self.states)))
        lines = [title or self.model, "One sigma of the true error by source, and its share of the variance."]
        for k in [self.at(time) for time in times] or [len(self.times) - 1]:
            for first in range(0, len(places), ACROSS):
                lines += ["", *self.table(k, places[first : first + ACROSS])]
        return "\n".join(lines) + "\n"

    def table(self, k: int, places: Sequence[int]) -> list[str]:
        scale = np.array([self.unit(i)[1] for i in places])
        label = max(len(one) for one in (*self.sources, *self.known, "filter's own sigma")) + 1

        def row(name: str, cells: Sequence[str]) -> str:
            return (f"{name:<{label}}" + "".join(f"{cell:>14}" for cell in cells)).rstrip()

        def numbers(name: str, values: Array, share: Array | None = None) -> str:
            cells = []
            for i, value in enumerate(values / scale):
                part = "     " if share is None else f" {100 * share[i]:3.0f}%"
                cells.append("-" + " " * 5 if share is not None and share[i] < ROUNDING else f"{value:.3g}" + part)
            return row(name, cells)

        with np.errstate(invalid="ignore", divide="ignore"):
            share = np.nan_to_num(self.variances[k] / self.whole[k])
        lines = [row(f"at {self.times[k]:g} s", [self.states[i] + "     " for i in places]),
                 row("", [self.unit(i)[0] + "     " for i in places])]  # fmt: skip
        lines += [numbers(name, np.sqrt(np.maximum(self.variances[k, s, places], 0.0)), share[s, places])
                  for s, name in enumerate(self.sources) if self.variances[:, s].any()]  # fmt: skip
        lines.append(numbers("root sum square", self.sigma[k, places]))
        lines += [numbers(f"offset {name}", self.offsets[k, o, places]) for o, name in enumerate(self.known)]
        if self.offset.any():
            lines += [numbers("mean", self.offset[k, places]), numbers("mean and sigma", self.rms[k, places])]
        lines.append(numbers("filter's own sigma", np.sqrt(self.P_variances[k, places])))
        return lines

    def kept(self, times: Sequence[float]) -> list[int]:
        """The places of these times, or of TIMES of all."""
        every = np.linspace(0, len(self.times) - 1, min(TIMES, len(self.times)))
        return [self.at(time) for time in times] or [round(float(k)) for k in every]

    def csv(self, times: Sequence[float] = ()) -> str:
        """A row for each time, source and state: sigma in SI and rad, and its share; also those of all together."""
        out = io.StringIO()
        write = csv.writer(out, lineterminator="\n")
        write.writerow(("time_s", "source", "state", "unit", "sigma", "share"))
        for k in self.kept(times):
            rows = [(name, np.sqrt(np.maximum(self.variances[k, s], 0.0)), self.variances[k, s])
                    for s, name in enumerate(self.sources)]  # fmt: skip
            rows += [("root sum square", self.sigma[k], self.whole[k]),
                     ("filter's own sigma", np.sqrt(self.P_variances[k]), None),
                     ("mean", self.offset[k], None)]  # fmt: skip
            for name, sigma, variance in rows:
                for i, state in enumerate(self.states):
                    share = "" if variance is None or not self.whole[k, i] > 0 else variance[i] / self.whole[k, i]
                    write.writerow((f"{self.times[k]:.9g}", name, state, self.units[i], sigma[i], share))
        return out.getvalue()

    def document(self, times: Sequence[float] = ()) -> dict[str, Any]:
        """For JSON: sigmas in SI and rad, (times, sources, states)."""
        at = self.kept(times)
        return {
            "model": self.model,
            "states": list(self.states),
            "units": list(self.units),
            "sources": list(self.sources),
            "times_s": self.times[at].tolist(),
            "sigma": np.sqrt(np.maximum(self.variances[at], 0.0)).tolist(),
            "whole_sigma": self.sigma[at].tolist(),
            "filter_sigma": np.sqrt(self.P_variances[at]).tolist(),
            "mean": self.offset[at].tolist(),
        }

    # ---- a requirement

    def need(self, state: str, limit: float) -> dict[str, Any]:
        """Which source must get better, and how much, so that a state's error at the end is within a limit.

        limit: of the rms, in the unit of the state.  Of each source the factor of its size, 1 as it is, at which the
        limit is met: as it flies, with the gains as they are; and retuned, where the filter knows of it and has new
        gains.  None: not by this source alone, however good; `least` is what is left of the error without it.
        together: the factor of all sources.  None where the mean alone exceeds the limit.
        """
        i = self.state(state)
        if not (np.isfinite(limit) and limit > 0):
            raise BoresightError(f"a need of {limit:g} is not possible; give a size above zero")
        mean = self.offset[-1, i] ** 2
        room, whole = limit**2 - mean, self.whole[-1, i]
        out: dict[str, Any] = {"state": self.states[i], "limit": float(limit), "unit": self.units[i],
                               "rms": float(self.rms[-1, i]), "met": bool(whole <= room),
                               "together": float(np.sqrt(room / whole)) if whole > 0 and room > 0 else None,
                               "sources": []}  # fmt: skip
        names = [name for s, name in enumerate(self.sources) if self.variances[:, s].any() and name != ADDED]
        if out["met"] or room <= 0 or not names:
            return out
        retuned, least = self.retuned(names, i, limit**2)
        for name in names:
            own = self.variances[-1, self.sources.index(name), i]
            left = whole - own
            flies = np.sqrt((room - left) / own) if room > left and own > 0 else None
            out["sources"].append({
                "source": name, "share": float(own / whole),
                "as_it_flies": None if flies is None else float(flies), "retuned": retuned[name],
                "least_as_it_flies": float(np.sqrt(max(left, 0.0) + mean)),
                "least_retuned": float(np.sqrt(max(least[name], 0.0))),
            })  # fmt: skip
        return out

    def retuned(self, names: Sequence[str], i: int, room: float) -> tuple[dict[str, float | None], dict[str, float]]:
        """By source the largest factor at which state i has a mean square within room, or None; and that at zero."""

        def tried(factors: Mapping[str, Array]) -> dict[str, Array]:
            """Mean squares (G,) of each source with its own factors (G,), the others as they are."""
            sizes = [len(one) for one in factors.values()]
            ends = np.cumsum([0, *sizes])
            asked = {}
            for k, (name, own) in enumerate(factors.items()):
                asked[name] = np.ones(ends[-1])
                asked[name][ends[k] : ends[k + 1]] = own
            found = self.scaled(asked)[:, i]
            return {name: found[ends[k] : ends[k + 1]] for k, name in enumerate(factors)}

        out: dict[str, float | None] = dict.fromkeys(names)
        coarse = tried(dict.fromkeys(names, GRID))
        between = {}
        for name, found in coarse.items():
            within = np.flatnonzero(found <= room)
            if len(within):
                k = within[-1]
                between[name] = np.linspace(GRID[k], GRID[k + 1] if k + 1 < len(GRID) else 1.0, 9)
        for name, found in (tried(between) if between else {}).items():
            fine = between[name]
            k = int(np.flatnonzero(found <= room)[-1])
            if k + 1 == len(fine):
                out[name] = float(fine[k])
                continue
            part = (room - found[k]) / (found[k + 1] - found[k])  # it is nearly a square of the factor
            out[name] = float(np.sqrt(fine[k] ** 2 + part * (fine[k + 1] ** 2 - fine[k] ** 2)))
        return out, {name: float(found[0]) for name, found in coarse.items()}

    def need_report(self, needed: Mapping[str, Any]) -> str:
        """Lines of what `need` found."""
        i = self.state(needed["state"])
        unit, scale = self.unit(i)
        limit, rms = needed["limit"] / scale, needed["rms"] / scale
        head = f"{needed['state']} within {limit:.3g} {unit} at {self.times[-1]:g} s: "
        if needed["met"]:
            return f"{head}met, with {rms:.3g} {unit}.\n"
        lines = [f"{head}not met; it is {rms:.3g} {unit}.  To meet it"]
        if needed["together"] is None:
            return f"{head}not met; it is {rms:.3g} {unit}.  No source meets it: the mean alone is beyond it.\n"
        label = max(len(one["source"]) for one in needed["sources"]) + 2
        lines += [f"{'make this source alone':<{label}}{'as it flies':>16}{'retuned':>16}"]

        def cell(factor: float | None, least: float) -> str:
            return f"not: {least / scale:.3g} left" if factor is None else f"x {factor:.3f}"

        for one in sorted(needed["sources"], key=lambda one: -one["share"]):
            flies, retuned = (cell(one[how], one[f"least_{how}"]) for how in ("as_it_flies", "retuned"))
            lines.append(f"{one['source']:<{label}}{flies:>16}{retuned:>16}")
        can = [one["source"] for one in needed["sources"] if one["retuned"] is not None]
        verdict = f"One source can meet it: {', '.join(can)}." if can else "No source meets it alone."
        lines += [f"{'or all of them':<{label}}{'x ' + format(needed['together'], '.3f'):>16}",
                  "x .5 is half the size.  As it flies: the gains stay.  Retuned: the filter knows.",
                  *wrap(verdict, 79)]  # fmt: skip
        return "\n".join(lines) + "\n"

    def beside(self, other: Mapping[str, Any], name: str, state: str | None = None) -> str:
        """This design beside another one's `document`, at the end of each: all states, and one state by source."""
        lines = [f"against {name}, at {self.times[-1]:g} and {other['times_s'][-1]:g} s",
                 f"{'':<24}{'':>8}{'this':>12}{'other':>12}{'this/other':>12}"]  # fmt: skip

        def row(label: str, unit: str, one: float | None, two: float | None) -> str:
            cells = ["-" if value is None else f"{value:.3g}" for value in (one, two)]
            ratio = "-" if one is None or two is None or not two > 0 else f"{one / two:.3f}"
            return f"{label:<24}{unit:>8}{cells[0]:>12}{cells[1]:>12}{ratio:>12}"

        for i, one in enumerate(self.states):
            if one in other["states"]:
                unit, scale = self.unit(i)
                j = other["states"].index(one)
                there = float(np.hypot(other["whole_sigma"][-1][j], other["mean"][-1][j]))
                lines.append(row(one, unit, self.rms[-1, i] / scale, there / scale))
        if state is not None:
            i = self.state(state)
            if self.states[i] not in other["states"]:
                raise BoresightError(f"{name} has no state {self.states[i]!r}; it has {', '.join(other['states'])}")
            unit, scale = self.unit(i)
            j = other["states"].index(self.states[i])
            mine = {s: float(np.sqrt(max(v, 0.0))) for s, v in zip(self.sources, self.variances[-1, :, i], strict=True)}
            its = {s: row[j] for s, row in zip(other["sources"], other["sigma"][-1], strict=True)}
            lines += ["", f"{self.states[i]} by source"]
            for source in dict.fromkeys([*mine, *its]):
                pair = [None if source not in of else of[source] / scale for of in (mine, its)]
                lines.append(row(source, unit, *pair))
        return "\n".join(lines) + "\n"

    # ---- as a figure

    def draw(self, folder: Sheets | str | Path, states: Sequence[str] = (), limit: float | None = None) -> None:
        """Sources stacked over time, a panel for each state: the height is the sigma, a source's its share of it.

        folder: where budget.png is written, or `figures.Sheets`.  states: the first three if none.  limit: of the first
        state, in its unit, as a line.
        """
        sheets = folder if isinstance(folder, Sheets) else Sheets(Path(folder))
        places = [i for name in states for i in self.places(name)] or list(range(min(3, len(self.states))))
        with np.errstate(invalid="ignore", divide="ignore"):
            share = np.nan_to_num(self.variances[:, :, places] / self.whole[:, None, places]).mean((0, 2))
        order = np.argsort(-share, kind="stable")[: len(COLOURS)]
        rest = [s for s in range(len(self.sources)) if s not in order and share[s] != 0]
        size = 6.4, 1.2 + 1.5 * len(places)
        with sheets("budget", *size, nrows=len(places), sharex=True, squeeze=False) as (drawing, axes):
            for row, i in enumerate(places):
                ax, (unit, scale), total = axes[row, 0], self.unit(i), self.whole[:, i]
                height = self.sigma[:, i] / scale / np.where(total > 0, total, 1.0)
                parts = [self.variances[:, s, i] * height for s in order]
                parts += [self.variances[:, rest, i].sum(1) * height] if rest else []
                names = [self.sources[s] for s in order] + ["all others"] * bool(rest)
                ax.stackplot(self.times, parts, colors=(*COLOURS[: len(order)], GREY), labels=names, linewidth=0)
                ax.plot(self.times, np.sqrt(self.P_variances[:, i]) / scale, "k-", label="filter's own sigma")
                if self.offset.any():
                    ax.plot(self.times, self.rms[:, i] / scale, "k:", label="mean and sigma")
                top = 1.6 * self.rms[len(self.times) // 4 :, i].max() / scale  # what is open at the start is cut
                if limit is not None and row == 0:
                    ax.axhline(limit / scale, color="black", linestyle="--", label="needed")
                    top = max(top, 1.3 * limit / scale)
                ax.set(ylim=(0, top or 1.0), ylabel=f"{self.states[i]} [{unit}]")
            axes[-1, 0].set(xlabel="time [s]", xlim=(self.times[0], self.times[-1]))
            drawing.legend(*axes[0, 0].get_legend_handles_labels(), loc="outside lower center", ncols=3)
