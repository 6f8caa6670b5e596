"""A table whose cells are shaded by a fraction of the copy's rate: dark is as fast as the copy."""
import matplotlib

from drawing import INK, plot

_SHADES = matplotlib.colors.LinearSegmentedColormap.from_list("shades", ["#f3f6f9", "#8fb8d4", "#0b5a8f"])


def heat_table(title, lines, columns, cells, line_title, column_title, cell_width=1.25):
    """cells: {(line, column): (fraction of the copy, second line of text)}. @return a figure"""
    figure, axes = plot(0.95 + 0.42 * len(lines))
    axes = axes[0, 0]
    for (line, column), (fraction, text) in cells.items():
        x, y, shade = columns.index(column), lines.index(line), min(max(fraction, 0.0), 1.0)
        axes.add_patch(
            matplotlib.patches.Rectangle((x - 0.485, y - 0.47), 0.97, 0.94, color=_SHADES(shade), linewidth=0)
        )
        ink = "#fdfdfd" if shade > 0.6 else "#15171a"
        axes.text(x, y - 0.14, f"{fraction:.2f}", ha="center", va="center", fontsize=9.5, weight="bold", color=ink)
        axes.text(x, y + 0.24, text, ha="center", va="center", fontsize=7.2, color=ink)
    for x, y in ((x, y) for x, column in enumerate(columns) for y, line in enumerate(lines)):
        if (lines[y], columns[x]) not in cells:
            axes.text(x, y, "–", ha="center", va="center", color=INK)
    right = max(len(columns), 8.6 * 0.72 / cell_width)  # cells keep their width where there are few columns
    axes.set(xlim=(-0.5, right - 0.5), ylim=(len(lines) - 0.5, -0.5))
    axes.set_xticks(range(len(columns)), columns)
    axes.set_yticks(range(len(lines)), lines)
    axes.tick_params(top=True, bottom=False, labeltop=True, labelbottom=False, length=0)
    for spine in axes.spines.values():
        spine.set_visible(False)
    axes.annotate(
        column_title, (0, 1), xycoords="axes fraction", xytext=(0, 20), textcoords="offset points", fontsize=8.5
    )
    axes.set_ylabel(line_title)
    axes.set_title(title, pad=34)
    return figure
