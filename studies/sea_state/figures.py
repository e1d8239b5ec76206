"""Figures of the study sea-state, in the place of Kang's Figures 2, 3, 4, 6, 7 and 8, with bands over the runs."""

from typing import Any

import numpy as np

from boresight.analysis.figures import BLUE, GREY, ORANGE, Sheets
from boresight.runtime.units import DEG, MIL
from boresight.studies.sea_state.delay import VARIED, closed_form

# From calm to rough: by lightness, and by line where two lie near one another.
LOOK = (("#b9b9b9", "-"), ("#8a8a8a", (0, (4, 2))), ("#7cc47f", "-"), ("#3a7fb8", (0, (5, 2))), ("#a3469b", "-"),
        ("#1d1147", (0, (1, 1.2))))  # fmt: skip
LIMIT = {"color": "0.3", "linewidth": 0.7, "linestyle": (0, (4, 3))}


def banded(
    ax: Any, time: Any, runs: Any, color: str, label: str, parts: tuple[int, int] = (10, 90), **look: Any
) -> None:
    """The mean of the runs (T, runs), and the band that holds this part of them."""
    low, high = np.percentile(runs, parts, axis=1)
    ax.fill_between(time, low, high, color=color, alpha=0.15, linewidth=0)
    ax.plot(time, runs.mean(axis=1), color=color, label=label, **look)


def heading(result: dict[str, Any], kind: str, which: int, sheets: Sheets) -> None:
    """Figure 2 (without compensation) or 3 (with): each state's mean heading error, and the band of its runs."""
    time, every = result["history"]["time_s"], result["history"][kind]["heading_mil"][:, which]
    name, stem = (("with", "figure_3_with"), ("without", "figure_2_without"))[which]
    with sheets(f"sea_{kind}_{stem}", 9.0, 3.6, ncols=2) as (drawing, (whole, near)):
        for g, (color, line) in enumerate(LOOK):
            for ax in (whole, near) if g >= 2 else (whole,):
                banded(ax, time, every[:, g], color, f"sea state {g + 1}", linestyle=line)
        for ax in (whole, near):
            for sign in (1, -1):
                ax.axhline(sign * result["limit_mil"], **LIMIT, label="2 mil" if sign == 1 else "")
            ax.set(xlim=(0, time[-1]), xlabel="time [s]")
        whole.set(ylabel="heading error [mil]", ylim=(-62, 32), title="all states, mean and four fifths of the runs")
        near.set(ylim=(-8, 8), title="states 3 to 6 near zero")
        if (np.abs(every[-1, 2:]) > 8).all():
            near.text(0.5, 0.7, "no run comes near", transform=near.transAxes, ha="center", color="0.3")
        drawing.suptitle(f"{name} compensation of the delay: {result['motions'][kind]['says']}", fontsize=9)
        drawing.legend(*whole.get_legend_handles_labels(), loc="outside lower center", ncols=7)


def compensation(result: dict[str, Any], kind: str, sheets: Sheets) -> None:
    """Figure 4: with and without, in states 3 to 6; the band holds four fifths of the runs, the dots are sigmas."""
    time, history = result["history"]["time_s"], result["history"][kind]
    stem = f"sea_{kind}_figure_4_compensation"
    with sheets(stem, 9.0, 5.2, nrows=2, ncols=2, sharex=True, sharey=True) as (drawing, axes):
        for ax, g in zip(axes.flat, range(2, 6), strict=True):
            for i, (color, label) in enumerate(((BLUE, "with compensation"), (ORANGE, "without"))):
                banded(ax, time, history["heading_mil"][:, i, g], color, label)
                for sign in (1, -1):
                    ax.plot(time, sign * history["sigma_mil"][:, i, g], color=color, linewidth=0.8,
                            linestyle=(0, (1, 2)), label="sigma of the filter" if sign == 1 else "")  # fmt: skip
            steady = result["motions"][kind]["predicted_mil"][g]
            ax.axhline(steady, color="0.2", linewidth=0.8, linestyle=(0, (5, 3)), label="closed form without")
            ax.set(ylim=(-8, 8), xlim=(0, time[-1]), title=f"sea state {g + 1}")
        for ax in axes[:, 0]:
            ax.set_ylabel("heading error [mil]")
        for ax in axes[1]:
            ax.set_xlabel("time [s]")
        drawing.suptitle(result["motions"][kind]["says"], fontsize=9)
        drawing.legend(*axes[0, 0].get_legend_handles_labels(), loc="outside lower center", ncols=5)


def bench(result: dict[str, Any], sheets: Sheets) -> None:
    """Figures 6 and 8: heading on the bench, at rest and rolling by three amplitudes; and 7, the roll assumed."""
    history, amplitudes = result["history"]["bench"], result["bench"]["amplitude_deg"]
    time = history["time_s"]
    with sheets("sea_bench_figures_6_8", 9.0, 3.4, ncols=2) as (drawing, (rest, rolling)):
        for i, (color, amplitude) in enumerate(
            zip((ORANGE, *(LOOK[g][0] for g in (2, 3, 4))), amplitudes, strict=True)
        ):
            label = f"roll {amplitude:g} deg" if amplitude else "at rest"
            for ax in (rest, rolling) if amplitude else (rest,):
                banded(ax, time, history["heading_deg"][:, i], color, label, (0, 100))
        sigma = -history["sigma_deg"][:, 0]
        low = 1.05 * history["heading_deg"][len(time) // 20 :, 0].min()  # all of the band at rest, but for the start
        rest.plot(time, sigma, color=ORANGE, linewidth=0.9, linestyle=(0, (1, 2)), label="at rest, - sigma")
        rest.set(title="at rest and rolling: mean and all runs", ylabel="heading error [deg]", ylim=(low, 1))
        for sign in (1, -1):
            rolling.axhline(sign * 0.15, **LIMIT)
        rolling.set(title="rolling; dashed: the paper's 0.15 deg", ylim=(-0.5, 0.5))
        for ax in (rest, rolling):
            ax.set(xlim=(0, time[-1]), xlabel="time [s]")
        drawing.legend(*rest.get_legend_handles_labels(), loc="outside lower center", ncols=5)
    with sheets("sea_bench_figure_7_roll", 9.0, 2.4, ncols=3, sharey=True) as (_, axes):
        for i, ax in enumerate(axes, 1):
            ax.plot(time, history["roll_deg"][:, i], color=BLUE)
            ax.set(title=f"{result['bench']['cases'][i]}: {amplitudes[i]:g} deg", xlabel="time [s]", xlim=(0, 30))
        axes[0].set_ylabel("roll [deg]")


def unknown_delay(result: dict[str, Any], sheets: Sheets) -> None:
    """The closed form as lines, the flown filter as dots, variable by variable."""
    rows = result["closed_form"]["cases"]
    names = {"delay_ms": "delay [ms]", "ratio": "pitch / roll", "phase_deg": "pitch ahead of roll [deg]",
             "frequency_hz": "frequency [Hz]", "heading_deg": "heading [deg]", "grade": "sea state"}  # fmt: skip
    with sheets("sea_unknown_delay", 9.0, 4.6, nrows=2, ncols=3) as (drawing, axes):
        for ax, (name, values) in zip(axes.flat, VARIED.items(), strict=True):
            chosen = [row for row in rows if all(row[other] == VARIED[other][0] for other in VARIED if other != name)]
            ax.plot([row[name] for row in chosen], [row["flown_mil"] for row in chosen], "o", color=BLUE, markersize=4,
                    label="flown")  # fmt: skip
            fine = np.linspace(min(values), max(values), 200)
            at = {other: np.full(200, VARIED[other][0]) for other in VARIED} | {name: fine}
            form = closed_form(at["delay_ms"] * 1e-3, at["ratio"], at["phase_deg"] * DEG, at["frequency_hz"]) / MIL
            ax.plot(fine, form, color=GREY, zorder=0, label="closed form")
            ax.set_xlabel(names[name])
            if name in ("heading_deg", "grade"):
                ax.set_ylim(0, 5)
        for ax in axes[:, 0]:
            ax.set_ylabel("heading error [mil]")
        drawing.legend(*axes[0, 0].get_legend_handles_labels(), loc="outside lower center", ncols=2)


def draw(result: dict[str, Any], sheets: Sheets) -> None:
    for kind in result["motions"]:
        for which in (1, 0):
            heading(result, kind, which, sheets)
        compensation(result, kind, sheets)
    unknown_delay(result, sheets)
    if result["bench"]:
        bench(result, sheets)
