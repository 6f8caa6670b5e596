#!/usr/bin/python3
"""Wraps what is over 140 characters in the prose of pages: wrap_pages.py [--check] PAGE.md...

Words that do not fit a line go to the next line of their paragraph, and no further line changes. Tables, headings and blocks
of code stay, and code in backticks stays in one line. --check names the places and changes nothing; then exit status 1."""
import pathlib
import re
import sys

WIDTH = 140
WORD = re.compile(r"(?:`[^`\n]*`|\S)+")  # code in backticks is one word
MARK = re.compile(r"(?:[-+*>#|=]|\d+[.)])(?= |$)|\||#")  # what would be another thing at the head of a line


def is_prose(line):
    return bool(line.strip()) and not re.match(r"#|\||!\[|<!--| {4}", line)


def begins_item(line):
    return re.match(r" *(?:[-*+]|\d+\.) ", line)


def split(line):
    """The part of a line that fits, and the words behind it."""
    fits = [match.end() for match in WORD.finditer(line) if match.end() <= WIDTH and match.end() > len(line) - len(line.lstrip())]
    while fits and MARK.match(line[fits[-1] :].lstrip()):
        fits.pop()
    return (line[: fits[-1]], line[fits[-1] :].strip()) if fits else (line, "")


def wrapped(text):
    """The text with all of its prose wrapped, and the numbers of the lines that were too long."""
    lines, done, places, in_code, number = text.split("\n"), [], [], False, 0
    while lines:
        line = lines.pop(0)
        number += 1
        in_code ^= line.lstrip().startswith("```")
        if len(line) > WIDTH and not in_code and is_prose(line):
            line, rest = split(line)
            if rest:
                places.append(number)
                number -= 1
                item = begins_item(line)
                indent = " " * (item.end() if item else len(line) - len(line.lstrip()))
                goes_on = lines and is_prose(lines[0]) and not begins_item(lines[0]) and "```" not in lines[0]
                lines.insert(0, indent + rest + (" " + lines.pop(0).strip() if goes_on else ""))
                number += not goes_on
        done.append(line)
    return "\n".join(done), places


def main(arguments):
    check, found = "--check" in arguments, 0
    for name in [argument for argument in arguments if argument != "--check"]:
        page = pathlib.Path(name)
        text = page.read_text(encoding="utf-8")
        new, places = wrapped(text)
        found += len(places)
        if check:
            for number in places:
                print(f"{name}:{number}: over {WIDTH} characters; tools/dev format wraps it", file=sys.stderr)
        elif new != text:
            page.write_text(new, encoding="utf-8")
    return 1 if check and found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
