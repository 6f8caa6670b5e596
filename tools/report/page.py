"""Writes the sections as one HTML page that needs no other file, and their plots as files beside it."""
import html
import re

import drawing
import names
from content import Figure, Table, Text

_STYLE = """
:root { color-scheme: light dark; --ink: #24262b; --muted: #6f7279; --rule: #d8dade; --paper: #ffffff; --shade: #f5f6f8;
  --link: #0b5a8f; }
@media (prefers-color-scheme: dark) { :root { --ink: #e4e6ea; --muted: #9a9ea7; --rule: #3a3d44; --paper: #17191d;
  --shade: #202329; --link: #7cb8e0; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2.5rem 1.25rem 4rem; max-width: 60rem; background: var(--paper); color: var(--ink);
  font: 16px/1.55 system-ui, -apple-system, "Segoe UI", "Helvetica Neue", "DejaVu Sans", Arial, sans-serif; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .5rem; }
h2 { font-size: 1.3rem; margin: 3.2rem 0 .8rem; padding-top: .9rem; border-top: 1px solid var(--rule); }
p { max-width: 46rem; margin: .7rem 0; }
a { color: var(--link); }
nav ol { columns: 2 20rem; padding-left: 1.4rem; margin: 1.2rem 0 0; font-size: .94rem; }
nav .empty a { color: var(--muted); }
figure { margin: 1.6rem 0 .8rem; overflow-x: auto; }
figure svg { display: block; width: 100%; min-width: 34rem; height: auto; }
figcaption, caption { color: var(--muted); font-size: .84rem; line-height: 1.45; text-align: left; }
figcaption { margin-top: .4rem; max-width: 46rem; }
caption { padding-bottom: .4rem; }
.table { overflow-x: auto; margin: 1.2rem 0; }
table { border-collapse: collapse; font-size: .84rem; line-height: 1.35; font-variant-numeric: tabular-nums; }
th { font-weight: 600; vertical-align: bottom; border-bottom: 1.5px solid var(--muted); }
th, td { padding: .28rem .7rem .28rem 0; text-align: right; }
th.word, td.word { text-align: left; }
td.word { min-width: 6.2rem; }
td:first-child { white-space: nowrap; }
td { border-bottom: 1px solid var(--rule); vertical-align: top; }
details { margin: .6rem 0 1.4rem; font-size: .94rem; }
summary { cursor: pointer; color: var(--link); font-size: .84rem; }
code, pre { font: .84rem/1.5 ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; }
pre { background: var(--shade); padding: .7rem .9rem; border-radius: 4px; overflow-x: auto; }
.older { border-left: 3px solid #d55e00; padding-left: .8rem; font-size: .94rem; }
.missing { color: var(--muted); break-after: avoid; }
@media print {
  :root { color-scheme: light; --ink: #000; --muted: #555; --rule: #ccc; --paper: #fff; --shade: #f5f6f8;
    --link: #000; }
  body { max-width: none; padding: 0; font-size: 10.5pt; }
  nav, details { display: none; }
  pre { white-space: pre-wrap; }
  figure, tr, pre { break-inside: avoid; }
  h2 { break-after: avoid; }
  figure, .table { overflow: visible; }
  table { font-size: 8pt; }
}
"""


def build(sections, files):
    """@return {file name: bytes}: the page, and each plot as SVG and PNG; the page is last"""
    outputs, parts, used = {}, [], set()
    for section in sections:
        parts.append(f'<section id="{names.slug(section.title)}">\n<h2>{html.escape(section.title)}</h2>')
        parts += _older(section)
        parts += [_block(block, outputs, used) for block in section.blocks] or [_missing(section)]
        parts.append("</section>")
    page = f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>physgen: measured</title>
<style>{_STYLE}</style>
</head>
<body>
<h1>physgen: measured</h1>
<p>Layouts and storage formats of physics objects: speed beside error. {_summary(files)}</p>
<nav><ol>
{_contents(sections)}
</ol></nav>
{chr(10).join(parts)}
</body>
</html>
"""
    outputs["index.html"] = page.encode()
    return outputs


def _summary(files):
    machines = sorted({row.machine for file in files for row in file.rows})
    rows = sum(len(file.rows) for file in files)
    older = sum(file.kernels != "as here" for file in files)
    listed = html.escape("; ".join(machines)) or "none"
    return (
        f"{rows} rows of {len(files)} file{'s' * (len(files) != 1)}. Machines: {listed}. "
        "Times are medians; a copy is one of the same bytes in the same run."
        + (f" {older} of the files may be older than the code; their sections say so." if older else "")
    )


def _contents(sections):
    return "\n".join(
        f'<li{"" if section.blocks else " class=empty"}><a href="#{names.slug(section.title)}">'
        f'{html.escape(section.title)}</a>{"" if section.blocks else " (no rows)"}</li>'
        for section in sections
    )


def _older(section):
    """The text above figures that the present code may not give."""
    reasons = {}
    for why, file in sorted({row.older for row in section.used if row.older}):
        reasons.setdefault(why, []).append(file)
    if not reasons:
        return []
    listed = html.escape("; ".join(f"{why}: {', '.join(same)}" for why, same in reasons.items()))
    return [
        '<p class="older"><strong>May be older than the code:</strong> these figures are of '
        f"{listed}. The present code may be faster or slower, and its errors may differ. "
        'To measure again, see <a href="#machines-versions-commands">the commands</a>.</p>'
    ]


def _missing(section):
    return (
        f'<p class="missing">These results have no rows for this section. It needs {html.escape(section.rows)}:</p>\n'
        f"<pre>{html.escape(section.command)}</pre>"
    )


def _block(block, outputs, used):
    if isinstance(block, Text):
        return f"<div>{block.html}</div>" if "<pre>" in block.html else f"<p>{block.html}</p>"
    if isinstance(block, Table):
        return _table(block)
    return _figure(block, outputs, used)


def _figure(block: Figure, outputs, used):
    name, number = block.name, 1
    while name in used:  # two names can have one slug
        number += 1
        name = f"{block.name}-{number}"
    used.add(name)
    text = drawing.svg(block.plot)
    outputs[name + ".svg"], outputs[name + ".png"] = text.encode(), drawing.png(block.plot)
    caption = html.escape(block.caption, quote=True)
    return f"<figure>\n{drawing.inline(text, name, caption)}<figcaption>{caption}</figcaption>\n</figure>"


_NUMBER = re.compile(r"[<–]?[\d.,]*(e-?\d+)?×?( → [\d.,]+)?")


def _is_word(cells):
    """Whether a column is of words rather than numbers, and so stands to the left."""
    return not all(_NUMBER.fullmatch(cell) for cell in cells)


def _table(block):
    words = [k == 0 or _is_word(row[k] for row in block.rows) for k in range(len(block.header))]

    def line(tag, cells):
        return (
            "<tr>"
            + "".join(
                f"<{tag}{' class=word' if word else ''}>{html.escape(cell)}</{tag}>" for word, cell in zip(words, cells)
            )
            + "</tr>"
        )

    caption = "" if block.folded else f"<caption>{html.escape(block.caption)}</caption>\n"
    table = (
        f'<div class="table"><table>\n{caption}<thead>{line("th", block.header)}</thead>\n<tbody>\n'
        + "\n".join(line("td", row) for row in block.rows)
        + "\n</tbody></table></div>"
    )
    if block.folded:
        return f"<details><summary>{html.escape(block.caption)}</summary>\n{table}</details>"
    return table
