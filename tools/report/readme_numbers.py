#!/usr/bin/python3
"""Holds the figures of READMEs to the checked-in results, and the table of Debian packages to their list:
readme_numbers.py --check | --write [CHECKOUT]"""
import argparse
import difflib
import fnmatch
import hashlib
import pathlib
import re
import sys
from dataclasses import dataclass

sys.dont_write_bytecode = True  # leaves no __pycache__ among the sources
import readme_figures  # noqa: E402
import readme_sentences  # noqa: E402
import readme_tables  # noqa: E402
import rows  # noqa: E402
from truthcube import records  # noqa: E402

HELP = """Compares the figures of READMEs with the checked-in results (--check), or replaces them (--write): tables
between <!-- figures: NAME, from FILE.json --> and <!-- end of figures -->, figures in sentences, and pictures; and the
table of packages with tools/packages.txt. tools/report/readme_figures.py lists the READMEs and says where figures are described."""
LIST = "tools/report/readme_figures.py"
SENTENCES = "tools/report/readme_sentences.py"
TABLES = "tools/report/readme_tables.py"
RESULTS = "tools/report/results"
BEGIN = re.compile(r"<!-- figures: (?P<table>\w+), from (?P<file>[\w./]+) -->\n")
END = "<!-- end of figures -->\n"
NUMBER = r"(\d+(?:,\d{3})*(?:\.\d+)?(?:e[-+]?\d+)?)"
# Numbers that look measured: decimals, large counts, and numbers before a unit.
LOOKS_MEASURED = re.compile(r"\d+\.\d+(?:e[-+]?\d+)?|\d{1,3}(?:,\d{3})+|\d+(?= (?:ms|µs|eps|million)\b)")


class FiguresError(Exception):
    """A README or the list of figures is not as it must be."""


class File:
    """A result file, and ways to find its rows by name."""

    def __init__(self, path):
        read = rows.load([str(path)]).files[0]
        self.name, self.rows, self.context = path.name, read.rows, read.context
        self._found = {}  # of patterns that were asked for

    def all(self, *patterns):
        """Rows whose names fit one of the patterns, `kernel/layout/storage/space/objects[/set]`; `*` stands for
        anything within a part. @throws FiguresError where none fits"""
        if patterns not in self._found:
            self._found[patterns] = [row for row in self.rows if any(_fits(row.name, pattern) for pattern in patterns)]
        found = list(self._found[patterns])
        if not found:
            raise FiguresError(
                f"{RESULTS}/{self.name} has no row {' or '.join(patterns)}; measure it, or mend the name in {SENTENCES} or {TABLES}"
            )
        return found

    def one(self, pattern):
        """The only row of that name. @throws FiguresError where there is none, or more than one"""
        found = self.all(pattern)
        if len(found) > 1:
            raise FiguresError(f"{RESULTS}/{self.name} has {len(found)} rows {pattern}; say more in {SENTENCES} or {TABLES}")
        return found[0]


def _fits(name, pattern):
    name, pattern = name.split("/"), pattern.split("/")
    return len(name) == len(pattern) and all(map(fnmatch.fnmatchcase, name, pattern))


@dataclass(frozen=True)
class Edit:
    """Text of a README that comes from results: `text[begin:end]` must be `wanted`."""

    begin: int
    end: int
    wanted: str
    file: str  # of results, or a list in the checkout


class Checkout:
    def __init__(self, root):
        self.root = pathlib.Path(root)
        self._files = {}

    def file(self, name):
        if name not in self._files:
            self._files[name] = File(self.root / RESULTS / name)
        return self._files[name]

    def text(self, name):
        return (self.root / name).read_bytes().decode()

    def edits(self, readme, text):
        """All of a README's figures that results hold, in order. @throws FiguresError"""
        found = []
        for begin, end, table, file in tables(readme, text):
            found += self._table(begin, end, table, file, f"{readme}:{line(text, begin) - 1}", text)
        for sentence in readme_sentences.SENTENCES:
            if sentence.readme == readme:
                found += self._sentence(sentence, text)
        return sorted(found, key=lambda edit: edit.begin)

    def _table(self, begin, end, table, file, place, text):
        if table not in readme_tables.TABLES:
            there = ", ".join(readme_tables.TABLES)
            raise FiguresError(f"{place}: there is no table '{table}' in {TABLES}; it has {there}")
        source = self.file(file) if file.endswith(".json") and "/" not in file else self.text(file)
        wanted = readme_tables.TABLES[table](source).splitlines(keepends=True)
        present = text[begin:end].splitlines(keepends=True)
        if len(wanted) != len(present):
            return [Edit(begin, end, "".join(wanted), file)]
        edits = []
        for old, new in zip(present, wanted):
            edits.append(Edit(begin, begin + len(old), new, file))
            begin += len(old)
        return edits

    def _sentence(self, sentence, text):
        found = [match for match in _pattern(sentence.words).finditer(text)]
        if len(found) != 1:
            raise FiguresError(
                f"{sentence.readme} has {len(found) or 'no'} sentences \"{sentence.words}\" for {sentence.file}; "
                f"where the sentence was changed, change it in {SENTENCES}, too"
            )
        figures = sentence.figures(self.file(sentence.file))
        if len(figures) != found[0].re.groups:
            raise FiguresError(f"{SENTENCES}: {len(figures)} figures do not fit into \"{sentence.words}\"")
        return [Edit(*found[0].span(k + 1), figure, sentence.file) for k, figure in enumerate(figures)]

    def unaccounted(self, readme, text, edits):
        """Places of what looks measured, but is neither held by results nor listed as from elsewhere."""
        if readme not in readme_figures.COMPLETE:
            return []
        first, last = readme_figures.COMPLETE[readme]
        begin = text.find(first)
        end = text.find(last, begin + len(first)) if last else len(text)
        if begin < 0 or end < 0:
            raise FiguresError(f"{readme} has no part from '{first}' to '{last}'; change {LIST}, too")
        known = [(edit.begin, edit.end) for edit in edits]
        for words, _ in readme_figures.ELSEWHERE[readme]:
            found = list(_pattern(words).finditer(text))
            if len(found) != 1:
                raise FiguresError(f"{readme} has {len(found)} times \"{words}\", which {LIST} says it has once")
            known.append(found[0].span())
        return [
            match
            for match in LOOKS_MEASURED.finditer(text, begin, end)
            if not any(first <= match.start() and match.end() <= last for first, last in known)
        ]

    def differences_in(self, readme):
        """Lines of text that say where a README disagrees with results. @throws FiguresError, rows.ResultsError"""
        found, text = [], self.text(readme)
        edits = self.edits(readme, text)
        for edit in edits:
            present = text[edit.begin : edit.end]
            if present != edit.wanted:
                difference = _difference(present, edit.wanted)
                found.append(f"{readme}:{line(text, edit.begin)}: {difference} in {edit.file}")
        for match in self.unaccounted(readme, text, edits):
            found.append(
                f"{readme}:{line(text, match.start())}: '{match[0]}' is held by no results; list its sentence in "
                f"{SENTENCES} or, with where it is from, in {LIST} under ELSEWHERE"
            )
        return found

    def differences(self):
        """Lines of text that say where READMEs and pictures disagree with results. @throws FiguresError, rows.ResultsError"""
        found = [difference for readme in readme_figures.READMES for difference in self.differences_in(readme)]
        for picture in readme_figures.PICTURES:
            if not self._is_drawn(picture):
                found.append(f"{picture.path}: not drawn from the present {' and '.join(picture.files)}")
        return found

    def write(self):
        """@return names of the files that changed"""
        texts = {}
        for readme in readme_figures.READMES:
            text = self.text(readme)
            for edit in reversed(self.edits(readme, text)):
                text = text[: edit.begin] + edit.wanted + text[edit.end :]
            texts[readme] = text
        for picture in readme_figures.PICTURES:
            if not self._is_drawn(picture):
                texts[picture.path] = self._draw(picture)
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


def _difference(present, wanted):
    if "\n" not in present.strip() and "\n" not in wanted.strip():
        return f"'{present.strip()}' is '{wanted.strip()}'"
    lines = difflib.ndiff(present.splitlines(), wanted.splitlines())
    return "\n".join(["a table that has other lines", *(line for line in lines if line[0] in "+-"), "as"])


def tables(readme, text):
    """(begin, end, name, file) of each table in a README. @throws FiguresError where a table has no end"""
    found = []
    for match in BEGIN.finditer(text):
        end = text.find(END, match.end())
        if end < 0 or BEGIN.search(text, match.end(), end):
            raise FiguresError(
                f"{readme}:{line(text, match.start())}: no '{END.strip()}' behind the table '{match['table']}'"
            )
        found.append((match.end(), end, match["table"], match["file"]))
    return found


def line(text, place):
    return text.count("\n", 0, place) + 1


def _pattern(words):
    """A sentence as a regular expression: `{}` stands for a figure, a space for any white space."""
    parts = [r"\s+".join(map(re.escape, re.split(r"\s+", part))) for part in words.split("{}")]
    return re.compile(NUMBER.join(parts))


def main(arguments=None):
    parser = argparse.ArgumentParser(
        prog="readme_numbers.py",
        description=HELP,
        epilog="Exit status: 0 done, or all agrees; 1 something disagrees; 2 wrong use, README or results.",
    )
    action = parser.add_mutually_exclusive_group(required=True)
    action.add_argument("--check", action="store_true", help="say what disagrees")
    action.add_argument("--write", action="store_true", help="write figures and pictures as the results have them")
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
        print("After results were measured again, or packages listed: tools/report/readme_numbers.py --write", file=sys.stderr)
    return 1 if differences else 0


def _fail(message):
    print(f"readme_numbers.py: {message}", file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main())
