#!/usr/bin/python3
"""Holds the tables and pictures of pages to the checked-in results, the table of Debian packages to their list, and that of
joined steps to the digests of scenes:
readme_numbers.py --check | --write [CHECKOUT]"""
import argparse
import difflib
import hashlib
import importlib
import pathlib
import re
import sys
from dataclasses import dataclass

sys.dont_write_bytecode = True  # leaves no __pycache__ among the sources
import readme_tables  # noqa: E402
import rows  # noqa: E402
from truthcube import digest, records  # noqa: E402

HELP = """Compares pages with the checked-in results (--check), or writes the results into them (--write): tables with their
captions between <!-- figures: NAME, from FILE.json --> and <!-- end of figures -->, and pictures; and the table of packages with
tools/packages.txt. Figures of results stand in such tables, and not in sentences."""
RESULTS = "tools/report/results"
PAGES = ["README.md", "tools/README.md", "tools/report/results/README.md"]
PAGES += [f"tools/{folder}/README.md" for folder in ("fem", "physbench", "truthcube")]
PAGES += ["generator/scenes/README.md", "runtime/distributed.md"]
BEGIN = re.compile(r"<!-- figures: (?P<table>\w+), from (?P<file>[\w./]+) -->\n")
END = "<!-- end of figures -->\n"


class FiguresError(Exception):
    """A page is not as it must be, or a picture has no rows."""


# ---- Pictures --------------------------------------------------------------------------------------------------------
@dataclass(frozen=True)
class Picture:
    """A plot, made from some files of results."""

    path: str
    files: tuple
    draw: object  # paths of the files -> matplotlib's figure, or None where they have no rows for it


def _of_page(plot):
    """The first plot of a section of the report, plots/`plot`.py."""

    def draw(paths):
        section = importlib.import_module(f"plots.{plot}").section(rows.load(paths))  # only drawing needs matplotlib
        return next((block.plot for block in section.blocks if hasattr(block, "plot")), None)

    return draw


def _error_against_time(paths):
    return importlib.import_module("truthcube.error_against_time").draw(*paths)


PICTURES = [
    Picture("tools/report/results/h100_pareto.svg", ("h100.json", "h100_storage.json"), _of_page("pareto")),
    Picture("tools/report/results/h100_gathered.svg", ("h100_gathers.json",), _of_page("gathered")),
    Picture("tools/report/results/truthcube/error_against_time.svg", ("truthcube/errors.json",), _error_against_time),
]


# ---- Pages -----------------------------------------------------------------------------------------------------------
@dataclass(frozen=True)
class Table:
    """A table of a page, `text[begin:end]`."""

    begin: int
    end: int
    name: str
    file: str  # of results, or a list in the checkout
    line: int


def tables(page, text):
    """@throws FiguresError where a table has no end"""
    found = []
    for match in BEGIN.finditer(text):
        end, line = text.find(END, match.end()), text.count("\n", 0, match.start()) + 1
        if end < 0 or BEGIN.search(text, match.end(), end):
            raise FiguresError(f"{page}:{line}: no '{END.strip()}' behind the table '{match['table']}'")
        found.append(Table(match.end(), end, match["table"], match["file"], line))
    return found


class Checkout:
    def __init__(self, root):
        self.root = pathlib.Path(root)
        self._files = {}

    def text(self, name):
        return (self.root / name).read_bytes().decode()

    def file(self, name):
        """What a table is made of: a file of physbench with its rows, text, or a folder's digests of scenes by their names."""
        if (self.root / name).is_dir():
            return {file.stem: digest.read(file) for file in sorted((self.root / name).glob("*.digest"))}
        if "/" in name or not name.endswith(".json"):
            return self.text(name)
        if name not in self._files:
            self._files[name] = rows.NamedRows(self.root / RESULTS / name)
        return self._files[name]

    def wanted(self, page, table):
        """@throws FiguresError"""
        if table.name not in readme_tables.TABLES:
            there = ", ".join(readme_tables.TABLES)
            raise FiguresError(
                f"{page}:{table.line}: there is no table '{table.name}' in tools/report/readme_tables.py; it has {there}"
            )
        return readme_tables.TABLES[table.name](self.file(table.file))

    def differences(self):
        """Lines that say where pages and pictures disagree with results. @throws FiguresError, rows.ResultsError"""
        found = []
        for page in PAGES:
            text = self.text(page)
            for table in tables(page, text):
                present, wanted = text[table.begin : table.end], self.wanted(page, table)
                if present != wanted:
                    lines = difflib.ndiff(present.splitlines(), wanted.splitlines())
                    found.append(f"{page}:{table.line}: the table '{table.name}' is not what {table.file} says:")
                    found += [line for line in lines if line[0] in "+-"]
        return found + [
            f"{picture.path}: not drawn from the present {' and '.join(picture.files)}"
            for picture in PICTURES
            if not self._is_drawn(picture)
        ]

    def write(self):
        """@return names of the files that changed"""
        texts = {}
        for page in PAGES:
            text = self.text(page)
            for table in reversed(tables(page, text)):
                text = text[: table.begin] + self.wanted(page, table) + text[table.end :]
            texts[page] = text
        texts |= {picture.path: self._draw(picture) for picture in PICTURES if not self._is_drawn(picture)}
        changed = [name for name, text in texts.items() if not (self.root / name).exists() or text != self.text(name)]
        for name in changed:
            (self.root / name).write_bytes(texts[name].encode())
        return changed

    def _is_drawn(self, picture):
        return (self.root / picture.path).exists() and self._source(picture) in self.text(picture.path)

    def _source(self, picture):
        of = [(name, (self.root / RESULTS / name).read_bytes()) for name in picture.files]
        return "\n".join(f"<!-- of {name}, sha256 {hashlib.sha256(content).hexdigest()} -->" for name, content in of)

    def _draw(self, picture):
        import drawing  # here, since only writing needs matplotlib

        figure = picture.draw([str(self.root / RESULTS / name) for name in picture.files])
        if figure is None:
            raise FiguresError(f"{' and '.join(picture.files)} have no rows for {picture.path}")
        head, rest = drawing.svg(figure).split("\n", 1)
        return f"{head}\n{self._source(picture)}\n{rest}"


def main(arguments=None):
    parser = argparse.ArgumentParser(
        prog="readme_numbers.py",
        description=HELP,
        epilog="Exit status: 0 done, or all agrees; 1 something disagrees; 2 wrong use, page or results.",
    )
    action = parser.add_mutually_exclusive_group(required=True)
    action.add_argument("--check", action="store_true", help="say what disagrees")
    action.add_argument("--write", action="store_true", help="write tables and pictures as the results have them")
    parser.add_argument("checkout", nargs="?", default=pathlib.Path(__file__).resolve().parents[2], metavar="CHECKOUT")
    options = parser.parse_args(arguments)
    checkout = Checkout(options.checkout)
    try:
        if options.write:
            for name in checkout.write():
                print(name)
        differences = checkout.differences()
    except (FiguresError, rows.ResultsError, records.RunError) as error:
        return _fail(error)
    except ImportError as error:
        return _fail(f"{error}; on Debian: apt install python3-matplotlib")
    except OSError as error:
        return _fail(f"{error.filename}: {error.strerror or error}")
    for difference in differences:
        print(difference, file=sys.stderr)
    if differences and options.check:
        print("After results were measured again, packages listed, or scenes changed: tools/report/readme_numbers.py --write", file=sys.stderr)
    return 1 if differences else 0


def _fail(message):
    print(f"readme_numbers.py: {message}", file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main())
