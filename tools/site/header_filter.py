"""Gives a header as Doxygen reads it. The lines at its top, which say what it is for, become its description;
ranges as in `0 .. n-1` do not end a sentence."""
import re


def described(top):
    """The lines of a file's top as its description: indented ones are code."""
    lines, code = ["/// @file"], False
    for line in top.splitlines():
        line = line.removeprefix("//")
        if line.startswith("   "):
            lines += [] if code else ["///"]
            lines.append(f"///     {line}")
        else:
            lines.append("///" + re.sub(r"[#@\\]", r"\\\g<0>", line.replace("<", "&lt;")))
        code = line.startswith("   ")
    return "\n".join(lines) + "\n\n"


def filtered(text):
    text = re.sub(r"(?m)^( *///.*)$", lambda line: line[0].replace(" .. ", " &hellip; "), text)
    top = re.match(r"(?://(?!/)[^\n]*\n)+", text)
    return described(top.group()) + text[top.end() :] if top else text
