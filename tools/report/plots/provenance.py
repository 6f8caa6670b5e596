"""Where the figures come from: machine, date, versions, and the command that makes each file again."""
import html
import shlex

from content import Section, Table, Text

FIELDS = {
    "date": "date",
    "gpu": "GPU",
    "cpu": "CPU",
    "threads": "threads",
    "compiler": "compiler",
    "physgen": "physgen",
}


def section(results):
    blocks = [
        Table(
            ["file", "rows", *FIELDS.values(), "kernels"],
            [[file.name, str(len(file.rows)), *_context(file), file.kernels] for file in results.files],
            "What measured each file, when, and whether its compiled kernels are those of a build of this checkout: where they are "
            "others or are not stated, the code may have changed since. Another compiler or processor has other kernels, too.",
        )
    ]
    commands = "\n".join(f"{_command(file)}" for file in results.files)
    blocks.append(Text(f"Commands that make these files again, on such a machine:<pre>{html.escape(commands)}</pre>"))
    if results.replaced:
        blocks.append(
            Text(f"{results.replaced} rows are in several files from the same machine; the last file counts.")
        )
    failures = [[file.name, name, message] for file in results.files for name, message in file.failures]
    if failures:
        blocks.append(Table(["file", "row", "what it said"], failures, "Rows that failed, and are in no plot."))
    return Section("Machines, versions, commands", blocks)


def _context(file):
    values = [str(file.context.get(field, "–")) for field in FIELDS]
    return [values[0].replace("T", " "), *values[1:]]


def _command(file):
    """physbench's own command line, through tools/dev and quoted for a shell."""
    words = str(file.context.get("command", "")).split()
    if not words:
        return f"# {file.name} does not say how it was made"
    on_gpu = any(row.space == "cuda" for row in file.rows)
    return " ".join(["tools/dev", "gpu" if on_gpu else "run", *(shlex.quote(word) for word in words[1:])])
