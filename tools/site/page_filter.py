"""Gives a page of the tree as Doxygen reads it. Headings get names, and links lead to these names, to pages of
headers, or, where the site has neither, only their text stays."""
import os
import re

FENCED = re.compile(r"(?ms)^ *```.*?^ *```[^\n]*$")
# A link, whose text may hold code; or code, in which brackets are C++.
LINK_OR_CODE = re.compile(r"(?P<picture>!?)\[(?P<text>(?:[^\[\]`]|`[^`\n]*`)*)\]\((?P<target>[^)\s]+)\)|`(?:[^`\n]|\n(?!\n))*`")


def page_name(path):
    """Of a page, by its path from the root."""
    return re.sub(r"\W", "_", path.removesuffix(".md")).lower()


def heading_name(path, heading):
    """Of a heading, by the anchor that forges make of it."""
    text = re.sub(r"`|\[([^]]*)\]\([^)]*\)", r"\1", heading)
    return page_name(path) + "_" + re.sub(r"\W", "_", re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-"))


def link(path, pages, found):
    """What Doxygen gets for one link, or piece of code, of a page."""
    target = found["target"]
    if not target or "://" in target or target.startswith("mailto:"):
        return found.group()
    text = found["text"].replace("\n", " ")  # Doxygen ends a link at the end of its line
    if found["picture"]:
        return f"![{text}]({os.path.basename(target)})"
    file, _, anchor = target.partition("#")
    to = os.path.normpath(os.path.join(os.path.dirname(path), file)) if file else path
    if to in pages:
        return f"[{text}](@ref {heading_name(to, anchor) if anchor else page_name(to)})"
    return text


def filtered(path, text, pages):
    """The text of the page `path`; `pages` are the paths of all that the site has."""
    parts, end = [], 0
    for block in [*FENCED.finditer(text), None]:
        prose = text[end : block.start() if block else len(text)]
        prose = LINK_OR_CODE.sub(lambda found: link(path, pages, found), prose)
        first = not parts
        prose = re.sub(r"(?m)^(#+) (.*)$", lambda found: f"{found[1]} {found[2]} {{#{heading_name(path, found[2])}}}", prose)
        if first:  # the title names the page
            prose = re.sub(r"\{#\w+\}", f"{{#{page_name(path)}}}", prose, count=1)
        parts.append(prose + (block.group() if block else ""))
        end = block.end() if block else end
    return "".join(parts)
