"""The look of all plots, their conversion to SVG and PNG, and the parts that several of them share."""
import io
import re

import matplotlib
import matplotlib.ticker

matplotlib.use("Agg")
from matplotlib import offsetbox  # noqa: E402
from matplotlib.figure import Figure as Plot  # noqa: E402

INK, MUTED, RULE, PAPER = "#24262b", "#6f7279", "#d8dade", "#ffffff"
PNG_DPI = 160  # pixels per inch
PNG_MOST = 2**16 - 1  # pixels of a side that matplotlib draws
WIDTH = 8.6  # of the page's column [inch]
_PAGE_COLOURS = {INK: "var(--ink)", MUTED: "var(--muted)", RULE: "var(--rule)", PAPER: "var(--paper)"}

matplotlib.rcParams.update(
    {
        "svg.hashsalt": "physgen",
        "svg.fonttype": "path",
        "font.family": "DejaVu Sans",
        "font.size": 9,
        "text.color": INK,
        "axes.labelcolor": INK,
        "axes.edgecolor": RULE,
        "axes.titlesize": 9.5,
        "axes.titlelocation": "left",
        "axes.titleweight": "bold",
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.labelsize": 8.5,
        "xtick.color": RULE,
        "ytick.color": RULE,
        "xtick.labelcolor": INK,
        "ytick.labelcolor": INK,
        "xtick.labelsize": 8.5,
        "ytick.labelsize": 8.5,
        "axes.grid": False,
        "grid.color": RULE,
        "grid.linewidth": 0.6,
        "axes.axisbelow": True,
        "figure.facecolor": PAPER,
        "axes.facecolor": "none",
        "savefig.facecolor": PAPER,
        "xtick.minor.size": 0,
        "ytick.minor.size": 0,
        "axes.formatter.use_mathtext": True,
        "figure.dpi": 100,
    }
)


def plot(height, columns=1, rows=1, **options):
    """A figure of the page's width and `height` [inch]. @return figure, 2-D array of axes"""
    figure = Plot(figsize=(WIDTH, height), layout="constrained")
    return figure, figure.subplots(rows, columns, squeeze=False, **options)


def svg(figure):
    """The figure as an SVG file; the same bytes for the same figure."""
    stream = io.StringIO()
    figure.savefig(stream, format="svg", metadata={"Date": None, "Creator": None})
    return stream.getvalue()


def png(figure, description=None, dpi=PNG_DPI):
    """The figure as a PNG file, `dpi` pixels per inch; the description stands in the file."""
    stream = io.BytesIO()
    metadata = {"Software": None, "Description": description}
    figure.savefig(stream, format="png", dpi=dpi, metadata=metadata)
    return stream.getvalue()


def inline(text, name, description):
    """An SVG file as an element of the page: ids of its own, and ink that follows the page's light or dark theme."""
    text = re.sub(r"<metadata>.*?</metadata>\s*", "", text[text.index("<svg") :], flags=re.S)
    text = re.sub(r'(\bid="|href="#|url\(#)', rf"\g<1>{name}-", text)
    for colour, variable in _PAGE_COLOURS.items():
        text = text.replace(colour, variable)
    return text.replace("<svg ", f'<svg role="img" aria-label="{description}" ', 1)


# ---- Shared parts ----------------------------------------------------------------------------------------------------
def log_ticks(axis, low, high, text, steps=(1, 2, 5)):
    """Labelled ticks at 1, 2 and 5 times powers of ten between low and high."""
    ticks = [step * 10.0**power for power in range(-18, 13) for step in steps]
    ticks = [tick for tick in ticks if low * 0.999 <= tick <= high * 1.001]
    axis.set_major_locator(matplotlib.ticker.FixedLocator(ticks))
    axis.set_major_formatter(matplotlib.ticker.FixedFormatter([text(tick) for tick in ticks]))
    axis.set_minor_locator(matplotlib.ticker.NullLocator())


def spread(wanted, gap):
    """Positions next to the wanted ones, in the same order, and at least `gap` apart."""
    order = sorted(range(len(wanted)), key=lambda i: wanted[i])
    blocks = []  # (sum of wanted less offsets, members): each block is placed at its mean
    for i in order:
        blocks.append([wanted[i], [i]])
        while len(blocks) > 1 and _start(blocks[-1], gap) < _start(blocks[-2], gap) + gap * len(blocks[-2][1]):
            total, members = blocks.pop()
            blocks[-1][0] += total - gap * len(blocks[-1][1]) * len(members)
            blocks[-1][1] += members
    places = [0.0] * len(wanted)
    for block in blocks:
        for k, i in enumerate(block[1]):
            places[i] = _start(block, gap) + k * gap
    return places


def _start(block, gap):
    return block[0] / len(block[1])


def margin_labels(axes, points, line_height=11.5):
    """Labels right of the axes, each with a thin line to its point: points are (x, y, text, colour), in data units.

    Call it when the limits are final; `line_height` is in points of the type."""
    axes.figure.draw_without_rendering()
    scale = axes.figure.dpi / 72
    pixels = [axes.transData.transform((x, y))[1] for x, y, _, _ in points]
    gap = line_height * scale
    places = spread(pixels, gap)
    to_axes = axes.transAxes.inverted().transform
    for (x, y, text, colour), pixel, place in zip(points, pixels, places):
        side, height = to_axes((0, pixel))[1], to_axes((0, place))[1]
        start = to_axes(axes.transData.transform((x, y)))[0]
        axes.plot(
            [start, 1.0, 1.025],
            [side, side, height],
            color=colour,
            linewidth=0.7,
            transform=axes.transAxes,
            clip_on=False,
            zorder=1,
        )
        axes.text(1.032, height, text, transform=axes.transAxes, va="center", ha="left", fontsize=8)


def grouped_bars(axes, groups, start=0.0, bar=1.0, gap=1.1):
    """Horizontal bars in named groups, each with its label at its end. groups: (title, [(value, label, colour)])."""
    y, ticks = 0.0, []
    for title, bars in groups:
        for k, (value, label, colour) in enumerate(bars):
            axes.barh(y + k * bar, value - start, left=start, height=bar * 0.82, color=colour, linewidth=0)
            axes.annotate(
                label,
                (max(value, start), y + k * bar),
                xytext=(4, 0),
                textcoords="offset points",
                va="center",
                fontsize=7.8,
            )
        ticks.append(y + (len(bars) - 1) * bar / 2)
        y += len(bars) * bar + gap
    axes.set_yticks(ticks, [title for title, _ in groups])
    axes.set_ylim(y - gap - bar * 0.4, -bar * 0.6)
    axes.tick_params(axis="y", length=0)
    axes.spines["left"].set_visible(False)
    axes.grid(axis="x")


def bars_height(groups, bar=0.165, gap=1.1):
    """Height of a figure of grouped_bars [inch]."""
    return 0.75 + bar * (sum(len(bars) for _, bars in groups) + gap * len(groups))


def key(axes, names, in_layout=True):
    """Names with a dot of their colour, in one line above the axes: [(name, colour)]. `in_layout`: room is made for it
    where it is wider than the axes."""
    parts = [
        offsetbox.HPacker(
            pad=0,
            sep=3,
            children=[
                offsetbox.TextArea("●", textprops={"color": colour, "size": 8}),
                offsetbox.TextArea(name, textprops={"size": 8}),
            ],
        )
        for name, colour in names
    ]
    box = offsetbox.AnchoredOffsetbox(
        "lower left",
        child=offsetbox.HPacker(pad=0, sep=14, children=parts),
        frameon=False,
        bbox_to_anchor=(0, 1),
        bbox_transform=axes.transAxes,
        borderpad=0.3,
        pad=0,
    )
    box.set_in_layout(in_layout)
    axes.add_artist(box)
