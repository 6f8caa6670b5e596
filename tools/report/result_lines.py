#!/usr/bin/env python3
"""The form of result files: JSON in which each row, an item of a list, is one line, so that a difference shows which rows
differ: result_lines.py FILE.json... brings files into this form, without changing a value."""
import json
import pathlib
import re
import sys


def text(content):
    """The file's text. Objects have a line for each key, lists of objects or of lists a line for each item."""
    return "".join(_lines(content, "")) + "\n"


def write(path, content):
    pathlib.Path(path).write_text(text(content), encoding="utf-8")


def is_formed(written):
    """Whether a text has this form, whoever wrote it and however it spells numbers."""
    written = re.sub(r"\[\s+\]", "[]", written)  # an empty list, for which some writers begin a line
    wanted, present = text(_read(written)).splitlines(), written.splitlines()
    return len(wanted) == len(present) and all(_tokens(a) == _tokens(b) for a, b in zip(wanted, present))


def _lines(value, indent):
    if isinstance(value, dict) and value:
        brackets, items = "{}", [(f"{json.dumps(key)}: ", item) for key, item in value.items()]
    elif isinstance(value, list) and any(isinstance(item, (dict, list)) for item in value):
        brackets, items = "[]", [("", item) for item in value]
    else:
        yield json.dumps(value)
        return
    yield brackets[0]
    for number, (key, item) in enumerate(items):
        yield f"{',' if number else ''}\n{indent} {key}"
        yield from _lines(item, indent + " ") if key or isinstance(item, list) else [json.dumps(item)]
    yield f"\n{indent}{brackets[1]}"


def _read(written):
    """JSON in which no key stands twice."""

    def once(pairs):
        if len({key for key, _ in pairs}) != len(pairs):
            raise ValueError(f"a key stands twice among {', '.join(key for key, _ in pairs)}")
        return dict(pairs)

    return json.loads(written, object_pairs_hook=once)


def _tokens(line):
    """A line without blanks, with its numbers as values."""
    line = line.strip().removesuffix(",")
    try:
        return json.loads(line)
    except ValueError:
        pass
    try:
        return json.loads("{" + line + "}")
    except ValueError:
        return "".join(line.split())  # where an object or a list begins or ends


def main(paths):
    if not paths:
        sys.exit("result_lines.py FILE.json...: files of results")
    for path in paths:
        try:
            before = pathlib.Path(path).read_text(encoding="utf-8")
            content = _read(before)
        except (OSError, ValueError) as error:
            sys.exit(f"{path}: {error}")
        after = text(content)
        if not _same(_read(after), content):
            sys.exit(f"{path}: its values would change; it stays as it is")
        if after != before:
            pathlib.Path(path).write_text(after, encoding="utf-8")
            print(f"{path}: {len(after.splitlines())} lines")


def _same(a, b):
    """Equal values of equal types, in the same order: 1 is not 1.0."""
    if type(a) is not type(b):
        return False
    if isinstance(a, dict):
        return list(a) == list(b) and all(_same(a[key], b[key]) for key in a)
    if isinstance(a, list):
        return len(a) == len(b) and all(map(_same, a, b))
    return a == b or (a != a and b != b)


if __name__ == "__main__":
    main(sys.argv[1:])
