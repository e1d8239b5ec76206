"""One look for every figure of the studies, and the figures of the Euler-angle table.

Colours are told apart by readers who see two primaries only, and every line has its label beside it or in a legend.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from boresight import need

STYLE: Any = {
    "font.family": "sans-serif",
    "font.size": 9,
    "axes.titlesize": 9,
    "axes.labelsize": 9,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.linewidth": 0.7,
    "axes.grid": True,
    "grid.color": "0.9",
    "grid.linewidth": 0.6,
    "lines.linewidth": 1.1,
    "xtick.major.width": 0.7,
    "ytick.major.width": 0.7,
    "legend.frameon": False,
    "legend.fontsize": 8,
    "figure.constrained_layout.use": True,
    "savefig.dpi": 150,
}
BLUE, ORANGE, GREY = "#0b5fa5", "#d1600a", "0.55"  # estimated; not estimated; what is neither


@contextmanager
def figure(path: Path, width_in: float, height_in: float, **subplots: Any) -> Iterator[tuple[Any, Any]]:
    """A figure in the common style, written to `path` when the block ends.  No display, no global state."""
    need("replay")
    import matplotlib

    with matplotlib.rc_context(STYLE):
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure

        drawing = Figure(figsize=(width_in, height_in))
        FigureCanvasAgg(drawing)
        axes = drawing.subplots(**subplots)
        yield drawing, axes
        path.parent.mkdir(parents=True, exist_ok=True)
        # No software name or date inside: the file is the same from one run to the next.
        drawing.savefig(path, metadata={"Software": None} if path.suffix == ".png" else None)


def euler_table(result: dict[str, Any], path: Path) -> None:
    """Table 1 as a picture: the paper's, by linear covariance, by Monte Carlo; three squares a case."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import LinearSegmentedColormap, TwoSlopeNorm
    from matplotlib.lines import Line2D
    from matplotlib.patches import Rectangle

    paper, threshold = np.array(result["paper"]), result["threshold"]
    # The hue changes at the threshold and nowhere else; the depth says how far away the cell is.
    hue = LinearSegmentedColormap.from_list(
        "ratio", [(0, "#08457a"), (0.5, "#bfd9ef"), (0.5, "#fbdcc2"), (1, "#b34700")], N=512
    )
    scale = ScalarMappable(TwoSlopeNorm(np.log10(threshold), np.log10(0.02), 0.0), hue)
    panels = (
        ("Song and Lee, Table 1", np.where(paper, 0.02, 1.0)),
        (f"(a) linear covariance: {result['linear']['agree']} of {paper.size}", np.array(result["linear"]["ratio"])),
        (
            f"(b) Monte Carlo: {result['monte_carlo']['agree']} of {paper.size}",
            np.array(result["monte_carlo"]["ratio"]),
        ),
    )
    short = [", ".join(part[0] for part in name.split(", ")) for name in result["motions"]]
    with figure(path, 9.6, 4.3, ncols=3, sharey=True) as (drawing, axes):
        for ax, (title, ratio) in zip(axes, panels, strict=True):
            for (i, j, k), value in np.ndenumerate(ratio):
                x, y = j + 0.09 + 0.28 * k, i + 0.2
                tint = scale.to_rgba(np.log10(np.clip(value, 0.02, 1.0)))
                ax.add_patch(Rectangle((x, y), 0.26, 0.6, facecolor=tint, edgecolor="none"))
                if (value < threshold) != paper[i, j, k]:
                    ax.add_line(Line2D([x, x + 0.26], [y, y + 0.6], color="black", linewidth=1.2))
            ax.set(xlim=(0, 7), ylim=(7, 0), aspect="equal", title=title, xlabel="motion")
            ax.set_xticks(np.arange(7) + 0.5, short)
            ax.set_yticks(np.arange(7) + 0.5, result["matchings"])
            ax.set_xticks(np.arange(8), minor=True)
            ax.set_yticks(np.arange(8), minor=True)
            ax.grid(False)
            ax.grid(True, which="minor")
            ax.tick_params(which="both", length=0)
            ax.spines[:].set_visible(False)
        axes[0].set_ylabel("matched angles")
        ticks = (0.02, 0.05, 0.1, 0.2, threshold, 0.5, 1.0)
        bar = drawing.colorbar(scale, ax=axes, location="bottom", ticks=np.log10(ticks), aspect=60, fraction=0.04)
        bar.ax.set_xticklabels([f"{tick:.2g}" for tick in ticks])
        bar.ax.minorticks_off()
        bar.outline.set_visible(False)
        bar.set_label(
            r"$\varepsilon_n$, $\varepsilon_e$, $\varepsilon_d$ (left to right in each case): error after "
            f"{result['seconds']:g} s, as a part of the error at the start\n"
            "blue: estimated; orange: not estimated; struck through: other than in the paper"
        )


def euler_history(result: dict[str, Any], match: int, motion: int, path: Path) -> None:
    """One of the paper's Figures 2 to 10: the three errors in time, three runs, within the filter's 1-sigma band."""
    history = result["histories"]
    time = np.array(history["time_s"])
    parts = ("error_deg", "rms_deg", "sigma_deg", "linear_sigma_deg")
    error, rms, sigma, linear = (np.array(history[part])[match][motion] for part in parts)
    with figure(path, 5.6, 5.0, nrows=3, sharex=True, sharey=True) as (drawing, axes):
        for k, ax in enumerate(axes):
            tint = BLUE if result["paper"][match][motion][k] else ORANGE
            ax.fill_between(
                time, -sigma[:, k], sigma[:, k], color=tint, alpha=0.18, linewidth=0, label="1 sigma of the filter"
            )
            for run, one in enumerate(error):
                ax.plot(time, one[:, k], color=tint, linewidth=0.9, label="" if run else f"error, {len(error)} runs")
            for sign in (1, -1):
                first = sign == 1
                label = f"rms of {result['runs']} runs" if first else ""
                ax.plot(time, sign * rms[:, k], color="0.2", linestyle=(0, (5, 3)), linewidth=0.9, label=label)
                label = "1 sigma, H along the true motion" if first else ""
                ax.plot(time, sign * linear[:, k], color="0.5", linestyle=(0, (1, 1.5)), label=label)
            says = "estimated" if result["paper"][match][motion][k] else "not estimated"
            ax.set_ylabel(rf"$\varepsilon_{'ned'[k]}$ [deg]")
            ax.set_title(f"paper: {says}", loc="right", fontsize=8, color=tint, pad=2)
        axes[0].set_title(f"{result['matchings'][match]} match, {result['motions'][motion]} motion", loc="left")
        axes[0].set(xlim=(0, time[-1]))
        axes[-1].set_xlabel("time [s]")
        drawing.legend(*axes[0].get_legend_handles_labels(), loc="outside lower center", ncols=2)


def euler_figures(result: dict[str, Any], folder: Path) -> list[Path]:
    """The table and, if the result has histories, Figures 2 to 10.  Returns the files written."""
    folder = Path(folder)
    written = [folder / "euler_table.png"]
    euler_table(result, written[0])
    if "histories" in result:
        for match in range(3):
            for motion in range(3):
                names = (result["matchings"][match], result["motions"][motion])
                written.append(folder / f"figure_{2 + 3 * match + motion:02d}_{names[0]}_match_{names[1]}_motion.png")
                euler_history(result, match, motion, written[-1])
    return written


def euler_durations(result: dict[str, Any], path: Path) -> None:
    """How long Table 1 stays the paper's: the lowest sigma of its not estimated cells, with each cause switched off."""
    with figure(path, 5.6, 3.4) as (_, ax):
        for row in result["durations"]:
            if not row["process_noise"] and not row["second_order"]:
                continue  # lies on the line above it, or at 1
            causes = [
                word for key, word in (("earth_rate", "Earth rate"), ("second_order", "second order")) if row[key]
            ]
            label = f"{'Q of 1 deg/h' if row['process_noise'] else 'Q = 0'}; {' and '.join(causes) or 'neither'}"
            ax.plot(
                row["time_s"],
                row["smallest"],
                color=BLUE if row["process_noise"] else ORANGE,
                linestyle={2: "-", 0: (0, (1, 1.5))}.get(len(causes), (0, (5, 2)) if row["earth_rate"] else "-."),
                label=label,
            )
        ax.axhline(1 / 3, color="0.3", linewidth=0.8)
        ax.text(1.1, 0.345, "threshold", fontsize=8, color="0.3")
        ax.set(xscale="log", yscale="log", xlim=(1, 3600), ylim=(0.02, 1.3), xlabel="time [s]")
        ax.set_ylabel("sigma, part of the start")
        ax.set_yticks([0.02, 0.05, 0.1, 0.2, 0.5, 1.0], ["0.02", "0.05", "0.1", "0.2", "0.5", "1"])
        ax.set_xticks([1, 10, 30, 120, 300, 1000, 3600], ["1", "10", "30", "120", "300", "1000", "3600"])
        ax.minorticks_off()
        ax.legend(loc="lower left")
        ax.set_title("the best known of the errors that the paper calls not estimable", loc="left")


def euler_consistency(result: dict[str, Any], path: Path) -> None:
    """NEES against the misalignment: the paper's filter with and without a bias, and the exact one."""
    kinds = (
        (False, False, "no bias, Q = 0", ORANGE, "o"),
        (True, False, "1 deg/h and its Q", BLUE, "s"),
        (False, True, "exact residual, P turned; no bias", "0.25", "D"),
    )
    with figure(path, 5.6, 3.4) as (_, ax):
        low, high = result["consistency"][0]["nees"]["band"]
        ax.axhspan(low, high, color="0.85", linewidth=0, label="95 % band, 50 runs")
        for bias, exact, label, color, marker in kinds:
            rows = [
                row
                for row in result["consistency"]
                if row["bias"] == bias and row["exact"] == exact and row["turn_covariance"] == exact
                if row["iterations"] == (3 if exact else 1) and row["told_arcmin"] == [1.0, 1.0]
            ]
            size = np.array([row["misalignment_deg"] for row in rows])
            mean, small, large = (np.array([row["nees"][k] for row in rows]) for k in ("mean", "smallest", "largest"))
            shift = {"o": 0.97, "s": 1.0, "D": 1.03}[marker]
            ax.errorbar(
                size * shift, mean, (mean - small, large - mean), color=color, marker=marker, markersize=4, label=label
            )
        ax.set(xscale="log", yscale="log", xlabel="misalignment, 1 sigma an axis [deg]", ylabel="NEES of 6 states")
        ax.set_xticks([0.1, 0.2, 0.3, 0.5, 1, 2, 3], ["0.1", "0.2", "0.3", "0.5", "1", "2", "3"])
        ax.minorticks_off()
        ax.legend(loc="upper left")
        ax.set_title("mean of the 49 cases, bars to the smallest and the largest", loc="left")


def euler_exploration(result: dict[str, Any], folder: Path) -> list[Path]:
    """The figures of a finished exploration.  Returns the files written."""
    written = [Path(folder) / "euler_durations.png", Path(folder) / "euler_consistency.png"]
    euler_durations(result, written[0])
    euler_consistency(result, written[1])
    return written
