"""Figures of the study sea-state, in the place of Kang's Figures 2, 3, 4, 6, 7 and 8, with bands over the runs."""

from pathlib import Path
from typing import Any

import numpy as np

from boresight.runtime.units import DEG, MIL
from boresight.studies.figures import BLUE, GREY, ORANGE, figure
from boresight.studies.sea_state.delay import VARIED, closed_form

# From calm to rough, and told apart without colour by their order in the legend and in the figure.
SHADES = ("#b9b9b9", "#93b5d6", "#5f97c6", "#2f74ad", "#0b4f8a", "#06264a")


def heading(result: dict[str, Any], kind: str, which: int, path: Path) -> None:
    """Figure 2 (without compensation) or 3 (with): each state's mean heading error, and the band of its runs."""
    history = result["motions"][kind]["history"]
    time, every = np.array(history["time_s"]), np.array(history["heading_mil"])[which]
    with figure(path, 9.0, 3.4, ncols=2) as (drawing, (whole, near)):
        for grade, runs, shade in zip(result["grades"], every, SHADES, strict=True):
            for ax in (whole, near) if grade >= 3 else (whole,):
                low, high = np.percentile(runs, [10, 90], axis=0)
                ax.fill_between(time, low, high, color=shade, alpha=0.2, linewidth=0)
                ax.plot(time, runs.mean(axis=0), color=shade, label=f"sea state {grade}" if ax is whole else "")
        limit = result["limit_mil"]
        for ax in (whole, near):
            ax.axhline(limit, color="0.3", linewidth=0.7, linestyle=(0, (4, 3)))
            ax.axhline(-limit, color="0.3", linewidth=0.7, linestyle=(0, (4, 3)))
            ax.set(xlim=(0, time[-1]), xlabel="time [s]")
        whole.set(ylabel="heading error [mil]", ylim=(-62, 32), title="all")
        near.set(ylim=(-8, 8), title="states 3 to 6 near zero; dashed: 2 mil")
        if (np.abs(every[2:, :, -1]) > 8).all():
            near.text(0.5, 0.7, "no run comes near", transform=near.transAxes, ha="center", color="0.3")
        name = ("with", "without")[which]
        drawing.suptitle(f"{name} compensation of the delay: {result['motions'][kind]['says']}", fontsize=9)
        drawing.legend(*whole.get_legend_handles_labels(), loc="outside lower center", ncols=6)


def compensation(result: dict[str, Any], kind: str, path: Path) -> None:
    """Figure 4: with and without, in states 3 to 6; the band holds four fifths of the runs, the dots are sigmas."""
    history = result["motions"][kind]["history"]
    time, every, sigma = (np.array(history[name]) for name in ("time_s", "heading_mil", "sigma_mil"))
    with figure(path, 9.0, 5.2, nrows=2, ncols=2, sharex=True, sharey=True) as (drawing, axes):
        for ax, g in zip(axes.flat, range(2, 6), strict=True):
            for i, (colour, label) in enumerate(((BLUE, "with compensation"), (ORANGE, "without"))):
                low, high = np.percentile(every[i, g], [10, 90], axis=0)
                ax.fill_between(time, low, high, color=colour, alpha=0.2, linewidth=0)
                ax.plot(time, every[i, g].mean(axis=0), color=colour, label=label)
                for sign in (1, -1):
                    ax.plot(time, sign * sigma[i, g], color=colour, linewidth=0.8, linestyle=(0, (1, 2)),
                            label="sigma of the filter" if sign == 1 else "")  # fmt: skip
            steady = result["motions"][kind]["predicted_mil"][g]
            ax.axhline(steady, color="0.2", linewidth=0.8, linestyle=(0, (5, 3)), label="closed form without")
            ax.set(ylim=(-8, 8), xlim=(0, time[-1]), title=f"sea state {g + 1}")
        for ax in axes[:, 0]:
            ax.set_ylabel("heading error [mil]")
        for ax in axes[1]:
            ax.set_xlabel("time [s]")
        drawing.suptitle(result["motions"][kind]["says"], fontsize=9)
        handles, labels = axes[0, 0].get_legend_handles_labels()
        drawing.legend(handles, labels, loc="outside lower center", ncols=5)


def bench_heading(result: dict[str, Any], path: Path) -> None:
    """Figures 6 and 8: heading on the bench, at rest and rolling by three amplitudes."""
    bench = result["bench"]
    history = bench["history"]
    time, every, sigma = (np.array(history[name]) for name in ("time_s", "heading_deg", "sigma_deg"))
    shades = (ORANGE, *SHADES[2:5])
    with figure(path, 9.0, 3.4, ncols=2) as (drawing, (rest, rolling)):
        for i, (shade, amplitude) in enumerate(zip(shades, bench["amplitude_deg"], strict=True)):
            label = f"roll {amplitude:g} deg" if amplitude else "at rest"
            for ax in (rest, rolling):
                if ax is rolling and not amplitude:
                    continue
                low, high = every[i].min(axis=0), every[i].max(axis=0)
                ax.fill_between(time, low, high, color=shade, alpha=0.2, linewidth=0)
                ax.plot(time, every[i].mean(axis=0), color=shade, label=label if ax is rest else "")
        rest.plot(time, -sigma[0], color=ORANGE, linewidth=0.9, linestyle=(0, (1, 2)), label="at rest, - sigma")
        rest.set(title="at rest and rolling: mean and all runs", ylabel="heading error [deg]", ylim=(-3.2, 1))
        for sign in (1, -1):
            rolling.axhline(sign * 0.15, color="0.3", linewidth=0.7, linestyle=(0, (4, 3)))
        rolling.set(title="rolling; dashed: the paper's 0.15 deg", ylim=(-0.5, 0.5))
        for ax in (rest, rolling):
            ax.set(xlim=(0, time[-1]), xlabel="time [s]")
        drawing.legend(*rest.get_legend_handles_labels(), loc="outside lower center", ncols=5)


def bench_roll(result: dict[str, Any], path: Path) -> None:
    """Figure 7: the roll that is assumed in the three cases."""
    bench = result["bench"]
    time, roll = (np.array(bench["history"][name]) for name in ("time_s", "roll_deg"))
    with figure(path, 9.0, 2.4, ncols=3, sharey=True) as (_, axes):
        for ax, one, name, amplitude in zip(axes, roll, bench["cases"][1:], bench["amplitude_deg"][1:], strict=True):
            ax.plot(time, one, color=BLUE)
            ax.set(title=f"{name}: {amplitude:g} deg", xlabel="time [s]", xlim=(0, 30))
        axes[0].set_ylabel("roll [deg]")


def unknown_delay(result: dict[str, Any], path: Path) -> None:
    """The closed form as lines, the flown filter as dots, variable by variable."""
    rows = result["closed_form"]["cases"]
    names = {"delay_ms": "delay [ms]", "ratio": "pitch / roll", "phase_deg": "pitch ahead of roll [deg]",
             "frequency_hz": "frequency [Hz]", "heading_deg": "heading [deg]", "grade": "sea state"}  # fmt: skip
    with figure(path, 9.0, 4.6, nrows=2, ncols=3) as (drawing, axes):
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


def sea_figures(result: dict[str, Any], folder: Path) -> list[Path]:
    """All of them, of a result with histories.  Returns the files written."""
    folder = Path(folder)
    written = []
    for kind in result["motions"]:
        for which, name in ((1, "figure_2_without"), (0, "figure_3_with")):
            written.append(folder / f"sea_{kind}_{name}.png")
            heading(result, kind, which, written[-1])
        written.append(folder / f"sea_{kind}_figure_4_compensation.png")
        compensation(result, kind, written[-1])
    written.append(folder / "sea_unknown_delay.png")
    unknown_delay(result, written[-1])
    if result["bench"]:
        for draw, name in ((bench_heading, "figures_6_8"), (bench_roll, "figure_7_roll")):
            written.append(folder / f"sea_bench_{name}.png")
            draw(result, written[-1])
    return written
