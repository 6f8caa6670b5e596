"""The errors that a compiler reports, and the places that have led to each."""
import pathlib
import re
import subprocess

ERROR = re.compile(r"(?:: |\): )(?:fatal )?error: (.*)")
# g++ says before an error what has led there, from its last `In ...` on; the others say it behind the error.
HEAD = re.compile(r": In \w+ |: At ")
INCLUDED = re.compile("In file included from| +from ")
LEADS = {"gnu": re.compile(""), "clang": re.compile("note: (in |while )"), "nvcc": re.compile(r"at line \d+")}


class Error:
    """One error: its line of output, its message, and the lines that say what has led to it, the nearest first."""

    def __init__(self, compiler, line, context):
        self.line, self.context = line, context
        self.message = ERROR.search(line)[1]
        self.leads = [text for text in context if LEADS[compiler].search(text)]
        self.at_once = self.message if compiler == "clang" else self.message[:200]  # clang says types first
        # clang says in a note which function is deleted, and shows it, and its parameter's type says why.
        self.words = "\n".join([self.message, *context]) if compiler == "clang" else self.message

    def lines_of(self, source):
        """The lines of a source that the error and what has led to it are at, the nearest first."""
        place = re.compile(rf"{re.escape(source)}[:(](\d+)|at line (\d+) of \"?{re.escape(source)}")
        found = [place.search(text) for text in [self.line, *self.leads]]
        return [int(match[1] or match[2]) for match in found if match]


def errors(compiler, output):
    """@param output lines of it. @return the errors, in order"""
    at = [number for number, text in enumerate(output) if ERROR.search(text)]
    found = []
    for before, number, after in zip([-1, *at], at, [*at[1:], len(output)]):
        if compiler == "gnu":
            around = output[before + 1 : number]
            heads = [k for k, text in enumerate(around) if HEAD.search(text)]
            context = (around[heads[-1] :] if heads else [text for text in around if INCLUDED.match(text)])[::-1]
        else:
            context = output[number + 1 : after]
        found.append(Error(compiler, output[number], context))
    return found


def compile_source(compiler, command, source, hits=None):
    """Compiles a source that must be refused. @return the errors. @param hits file for the places of the static_asserts
    among them, a line `FILE:LINE` each, which static_asserts_test.py reads"""
    more = ["-ferror-limit=0", "-ftemplate-backtrace-limit=0"] if compiler == "clang" else []
    done = subprocess.run([*command, *more, source], capture_output=True, text=True, check=False)
    found = errors(compiler, (done.stdout + done.stderr).splitlines())
    if hits:
        failed = [error.line for error in found if re.search("static.assert", error.message)]
        places = {re.match(r"(.*?)[:(](\d+)[:)]", line).groups() for line in failed}
        pathlib.Path(hits).parent.mkdir(parents=True, exist_ok=True)
        pathlib.Path(hits).write_text("".join(sorted(f"{pathlib.Path(file).resolve()}:{line}\n" for file, line in places)))
    return found
