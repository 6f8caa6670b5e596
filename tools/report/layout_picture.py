#!/usr/bin/python3
"""Draws where the elements of arrays lie, from what `physgen layout --json` writes; see --help."""
import argparse
import json
import os
import sys

sys.dont_write_bytecode = True  # leaves no __pycache__ among the sources

HELP = """Draws the arrays of a file that `physgen layout SCHEMA --json` wrote: memory in rows of 128 bytes with a gap
between sectors of 32, coloured by field; the first request of a warp, and the sectors that it touches; and the
sectors that requests of each field take. The same file gives the same bytes."""
FORMAT = 1  # of the JSON
ROW, SECTOR, WARP = 128, 32, 32  # bytes of a row and of a sector, objects of a warp
MOST_ROWS = 12
# Everything below is in hundredths of an inch.
PAGE, MARGIN, LEFT, BYTE, GAP = 1184, 24, 112, 8, 8
LABEL, CELL, ROW_HEIGHT = 15, 21, 50
BAR_LEFT, BAR = 772, 8  # of the costs; width of one sector there
BLACK, DARK, GREY, LIGHT = "#000000", "#333333", "#666666", "#cccccc"
# Colours of Okabe and Ito, which colour-blind people tell apart.
PALETTE = ("#56B4E9", "#E69F00", "#009E73", "#F0E442", "#CC79A7", "#0072B2", "#D55E00", "#BBBBBB")
COLUMNS = (("field", LEFT + 22, "left"), ("elements", 400, "right"), ("format", 424, "left"), ("offset", 590, "right"),
           ("bytes", 650, "right"), ("sectors/request", BAR_LEFT - 12, "right"), ("of ideal", 1080, "right"),
           ("used of 32 B", PAGE - MARGIN, "right"))  # fmt: skip


class LayoutError(Exception):
    """A file that cannot be drawn; its text names the file and what to do."""


def main(arguments=None):
    parser = argparse.ArgumentParser(
        prog="layout_picture.py", description=HELP,
        epilog="Exit status: 0 done; 2 wrong use, or a file that physgen did not write: then nothing is written.",
    )  # fmt: skip
    parser.add_argument("layout", metavar="LAYOUT.json", help="file of physgen layout --json; - is standard input")
    parser.add_argument("-o", "--output", required=True, metavar="FILE", help="picture to write, .svg or .png")
    options = parser.parse_args(arguments)
    if os.path.splitext(options.output)[1] not in (".svg", ".png"):
        parser.error(f"the picture '{options.output}' ends neither with .svg nor with .png")
    try:
        picture = draw(options.layout, read(options.layout), options.output.endswith(".png"))
        with open(options.output, "wb") as stream:
            stream.write(picture)
    except LayoutError as error:
        return _fail(error)
    except ImportError as error:
        return _fail(f"{error}; on Debian: apt install python3-matplotlib")
    except OSError as error:
        return _fail(f"cannot open {error.filename or options.output}: {error.strerror or error}")
    return 0


def _fail(message):
    print(f"layout_picture.py: {message}", file=sys.stderr)
    return 2


def _refuse(path, why):
    return LayoutError(f"{path} {why}; give a file that 'physgen layout SCHEMA --json -o x.json' wrote")


def read(path):
    """The arrays of a file. @throws LayoutError"""
    try:
        with sys.stdin if path == "-" else open(path, encoding="utf-8") as stream:
            content = json.load(stream)
    except ValueError as error:
        raise _refuse(path, f"is not JSON ({error})") from None
    if not isinstance(content, dict) or content.get("physgen_layout") != FORMAT:
        raise _refuse(path, f"is not a file of layouts of format {FORMAT}")
    return content.get("arrays")


def draw(path, arrays, as_png=False):
    """The picture as bytes. @throws LayoutError"""
    import drawing  # here, so that without matplotlib there is a remedy
    import matplotlib

    with matplotlib.rc_context({"svg.fonttype": "none"}):
        try:
            page = Page(drawing.Plot())
            y = _legend(page, 32)
            for array in arrays:
                y = _array(page, array, y)
        except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as error:
            raise _refuse(path, f"is damaged ({type(error).__name__}: {error})") from None
        figure = page.finish(y)
        height = int(figure.get_size_inches()[1] * drawing.PNG_DPI)
        if as_png and height > drawing.PNG_MOST:
            raise LayoutError(f"{path}: a picture of its {len(arrays)} arrays is {height} pixels high, and a PNG has at most "
                              f"{drawing.PNG_MOST}; write a .svg, or fewer arrays: physgen layout --object NAME --space SPACE")  # fmt: skip
        return drawing.png(figure) if as_png else drawing.svg(figure).encode()


class Page:
    """A page that grows downwards: y counts from its top."""

    def __init__(self, figure):
        self.figure, self.patches = figure, 0
        self.axes = figure.add_axes((0, 0, 1, 1))
        self.axes.set_axis_off()

    def box(self, x, y, width, height, fill, name=None, **style):
        from matplotlib.patches import Rectangle

        style = {"linewidth": 0, **style}
        patch = self.axes.add_patch(Rectangle((x, y), width, height, facecolor=fill, **style))
        self.patches += 1
        patch.set_gid(f"{name or 'box'}-{self.patches}")

    def padding(self, x, y, width, height, name=None):
        self.box(x, y, width, height, "#f2f2f2", name, hatch="//////", edgecolor="#999999")

    def line(self, x1, x2, y, colour):
        self.axes.plot((x1, x2), (y, y), color=colour, linewidth=0.7)

    def text(self, x, y, text, size=8.6, colour=DARK, align="left", **style):
        self.axes.text(x, y, text, fontsize=size, color=colour, ha=align, va="baseline", parse_math=False, **style)

    def finish(self, height):
        self.figure.set_size_inches(PAGE / 100, height / 100)
        self.axes.set(xlim=(0, PAGE), ylim=(height, 0))
        return self.figure


def _fitting(texts, width, size):
    """The first of the texts that fits; else the beginning of the last one, or nothing."""
    most = int(width / (0.85 * size))
    for text in texts:
        if len(text) <= most:
            return text
    return texts[-1][: most - 2] + ".." if most > 4 else ""


# ---- Memory ----------------------------------------------------------------------------------------------------------
def _cells(array, first, last):
    """The parts of the boxes between two bytes: (begin, end, row's name, box, number of the cell in its box)."""
    for row in array["rows"]:
        for box in row["boxes"]:
            count = box.get("elements", 1) * box.get("objects", 1)
            size = (box["end"] - box["begin"]) // count
            for cell in range(max(0, first - box["begin"]) // size, count):
                begin = box["begin"] + cell * size
                if begin >= last:
                    break
                for sector in range(begin // SECTOR, (begin + size - 1) // SECTOR + 1):
                    part = max(begin, sector * SECTOR), min(begin + size, (sector + 1) * SECTOR)
                    if first <= part[0] < last:
                        yield *part, row["name"], box, cell


def _shown_rows(array):
    """Numbers of the rows of 128 bytes that hold boxes: the first ones and the last ones."""
    numbers = set()
    for row in array["rows"]:
        for box in row["boxes"]:
            first, last = box["begin"] // ROW, (box["end"] - 1) // ROW
            numbers.update(range(first, min(last, first + MOST_ROWS) + 1))
    numbers = sorted(numbers)
    return numbers if len(numbers) <= MOST_ROWS else numbers[: MOST_ROWS - 3] + numbers[-3:]


def _in_request(first, box, cell):
    """Whether it is the element with which the box `first` begins, of an object of the first warp."""
    if box.get("field") != first["field"] or box["object"] + (cell if box["objects"] > 1 else 0) >= WARP:
        return False
    return box["element"] + (cell if box["elements"] > 1 else 0) == first["element"]


def _names(array, name, box, cell):
    """The texts above a cell and in it, from the longest to the shortest."""
    of_records = array["pitch"] == 1
    if "field" not in box:
        return (["object " + name, name] if of_records else ["padding", ""]), [""]
    if not of_records:
        return [name, array["fields"][box["field"]]["name"]], [str(box["object"] + cell), ""]
    field = array["fields"][box["field"]]["name"].rsplit(".", 1)[-1]
    index = box["indices"][cell] if "indices" in box else ""
    return ["object " + name, name], [field + index, index or field, index.split("]")[-1], ""]


def _memory_row(page, array, number, y):
    request = array["rows"][0]["boxes"][0]
    start = number * ROW
    page.text(LEFT - 12, y + LABEL + 15, str(start), align="right")
    groups, touched = [], set()

    def x_of(byte):
        return LEFT + (byte - start) * BYTE + (byte - start) // SECTOR * GAP

    cells = sorted(_cells(array, start, start + ROW), key=lambda cell: cell[0])
    for begin, end, name, box, cell in cells:
        x, width = x_of(begin), (end - begin) * BYTE
        above, inside = _names(array, name, box, cell)
        if "field" in box:
            colour = PALETTE[box["field"] % len(PALETTE)]
            page.box(x, y + LABEL, width, CELL, colour, "cell", edgecolor="white", linewidth=0.7)
            ink = "white" if colour == "#0072B2" else BLACK
            page.text(x + width / 2, y + LABEL + 14.5, _fitting(inside, width - 3, 6.8), 6.8, ink, "center")
        else:
            page.padding(x, y + LABEL, width, CELL, "padding")
        if groups and groups[-1][0] == name and groups[-1][3] == begin:
            groups[-1][2:4] = [x + width - 2, end]
        else:
            groups.append([name, x + 2, x + width - 2, end, above])
        if _in_request(request, box, cell):
            touched.add(begin // SECTOR)
            page.box(x + 1, y + LABEL + 1, width - 2, CELL - 2, "none", "request", edgecolor=BLACK, linewidth=1.4,
                     zorder=3)  # fmt: skip
    for _, left, right, _, above in groups:
        page.line(left, right, y + LABEL - 2, GREY)
        page.text((left + right) / 2, y + LABEL - 5, _fitting(above, right - left, 7.2), 7.2, align="center")
    for sector in sorted(touched):
        page.box(x_of(sector * SECTOR), y + LABEL + CELL + 3, SECTOR * BYTE, 4, BLACK, "sector")


def _memory(page, array, y):
    page.text(LEFT - 12, y, "byte", 8, GREY, "right")
    for byte in range(0, ROW, SECTOR):
        page.text(LEFT + byte * BYTE + byte // SECTOR * GAP, y, f"+{byte}", 8, GREY)
    y += 8
    following = 0
    for number in _shown_rows(array):
        if number > following:
            page.text(LEFT, y + 11, f"... {(number - following) * ROW} bytes ...", 8, GREY)
            y += 20
        _memory_row(page, array, number, y)
        y += ROW_HEIGHT
        following = number + 1
    page.text(LEFT, y + 9, "...", 8, GREY)
    name, first = array["rows"][0]["name"], array["rows"][0]["boxes"][0]
    if array["pitch"] == 1:
        name = first["text"].split(" ", 1)[1].split("..")[0]  # "+0 F(0,0)..(2,2)"
    page.text(LEFT, y + 30, f"Outlined: {name} of objects 0 to 31, one request of a warp. Each sector that it touches has "
                            "a bar below.")  # fmt: skip
    return y + 42


# ---- Costs -----------------------------------------------------------------------------------------------------------
def _costs(page, array, y):
    y += 14
    for title, x, align in COLUMNS:
        page.text(x, y, title, 8, GREY, align)
    page.line(LEFT, PAGE - MARGIN, y + 5, LIGHT)
    for number, field in enumerate(array["fields"]):
        y += 20
        page.box(LEFT, y - 10, 14, 12, PALETTE[number % len(PALETTE)])
        fewest, most = field["sectors_per_request"]
        over = field["sectors"] / field["ideal_sectors"]
        values = (_fitting([field["name"]], 230, 8.6), field["elements"], field["format"], field["offset"],
                  field["bytes"], str(fewest) if fewest == most else f"{fewest}-{most}", f"{over:.2f}x",
                  f"{SECTOR / over:.1f}")  # fmt: skip
        for (_, x, align), value in zip(COLUMNS, values):
            page.text(x, y, str(value), align=align, colour=BLACK)
        page.box(BAR_LEFT, y - 10, field["sectors"] / field["elements"] * BAR - 1, 12, LIGHT)
        page.box(BAR_LEFT, y - 10, field["ideal_sectors"] / field["elements"] * BAR - 1, 12, DARK)
    page.text(LEFT, y + 22, array["warp"][0].upper() + array["warp"][1:] + ".")
    return y + 22


def _array(page, array, y):
    page.line(MARGIN, PAGE - MARGIN, y, GREY)
    title = f"{array['layout']} on {' and '.join(array['spaces'])}, Real = {array['real']}"
    page.text(MARGIN, y + 30, array["object"], 13, BLACK, weight="bold")
    page.text(PAGE - MARGIN, y + 30, title, 11.5, BLACK, "right", weight="bold")
    page.text(MARGIN, y + 50, array["record"], 9.4, GREY)
    return _costs(page, array, _memory(page, array, y + 76)) + 28


def _legend(page, y):
    page.text(MARGIN, y, "Rows of 128 bytes in four sectors of 32, coloured by field.")
    page.padding(442, y - 12, 30, 15)
    page.text(480, y, "padding")
    page.box(550, y - 12, 30, 15, "none", edgecolor=BLACK, linewidth=1.4)
    page.text(588, y, "in the request")
    page.box(700, y - 6, 30, 4, BLACK)
    page.text(738, y, "sector touched")
    page.box(866, y - 11, 4 * BAR - 1, 12, DARK)
    page.box(866 + 4 * BAR, y - 11, 4 * BAR - 1, 12, LIGHT)
    page.text(866 + 8 * BAR + 8, y, "sectors: ideal, and too many")
    return y + 20


if __name__ == "__main__":
    sys.exit(main())
