#!/usr/bin/env python3
"""Random schemas through physgen, each in a process of its own with limits, and what it accepts through a compiler.

    fuzz.py --physgen PHYSGEN --folder FOLDER [--seed SEED] [--minutes N] [--first NUMBER] -- COMPILER FLAGS...

Checked: physgen ends by itself, with a documented exit status; refuses with a place and leaves nothing behind, or accepts and
leaves the headers and nothing else; says the same twice; and every accepted header compiles with all of its classes used. A
schema that fails is kept in FOLDER/failures, and its path printed. The same seed gives the same schemas. Exit status 1 if any
fails."""
import argparse
import json
import os
import random
import re
import resource
import shutil
import subprocess
import sys
import time
from pathlib import Path
from xml.parsers.expat import ExpatError

from grammar import Grammar
from mutate import mutated
from program import Accepted, choose, compile_all, culprits

SCHEMAS = 120  # before each compilation, the same on every machine
PLACE = re.compile(r"^.+:\d+:\d+: (fatal )?error: ", re.MULTILINE)


class Defect(Exception):
    """A fault of physgen with one schema."""


class Fuzzer:
    def __init__(self, arguments):
        self.physgen = str(Path(arguments.physgen).resolve())
        self.folder = Path(arguments.folder).resolve()
        self.compiler, self.seed, self.number = arguments.compiler, arguments.seed, arguments.first
        self.limited = not arguments.no_memory_limit
        self.failures = self.accepted = self.refused = self.compiled = 0
        self.slowest = (0.0, None)

    def limits(self):
        resource.setrlimit(resource.RLIMIT_CPU, (10, 10))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if self.limited:
            resource.setrlimit(resource.RLIMIT_AS, (2 << 30, 2 << 30))

    def run(self, folder, *arguments):
        """@return the finished process, which ended by itself with a documented status"""
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        try:
            done = subprocess.run([self.physgen, *arguments], cwd=folder, preexec_fn=self.limits, capture_output=True,
                                  timeout=300, check=False)
        except subprocess.TimeoutExpired as error:
            raise Defect(f"physgen {' '.join(arguments)} hangs") from error
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        self.slowest = max(self.slowest, (seconds, self.number))
        messages = done.stderr.decode(errors="replace")
        if done.returncode < 0:
            raise Defect(f"physgen {' '.join(arguments)} was ended by signal {-done.returncode} (24: 10 s of processor time)\n{messages}")
        if done.returncode not in (0, 1) or "internal error" in messages:
            raise Defect(f"physgen {' '.join(arguments)} gave exit status {done.returncode}\n{messages}")
        if done.returncode == 1 and not PLACE.search(messages):
            raise Defect(f"an error without a place\n{messages}")
        return done

    def schema(self, folder):
        """Writes the next schema. @return the names of its files"""
        source = random.Random(f"{self.seed}/{self.number}")
        files = Grammar(source, self.number).files()
        if source.random() < 0.25:
            name = source.choice(sorted(files))
            files[name] = mutated(files[name], source)
        for name, text in files.items():
            (folder / name).write_bytes(text.encode("utf-8", "surrogateescape"))
        return list(files)

    def check(self, folder):
        """Generates one schema. @return it if it was accepted"""
        names = self.schema(folder)
        extras = ["--stamp", "stamp", "--depfile", "depfile"] if self.number % 5 == 0 else []
        done = self.run(folder, "generate", *names, "-o", "out", *extras)
        there = {str(path.relative_to(folder)) for path in folder.rglob("*") if not path.is_dir()}
        headers = [f"out/{Path(name).stem}.physgen.h" for name in names]
        expected = set(names) if done.returncode == 1 else {*names, *headers, *extras[1::2]}
        if there != expected:
            raise Defect(f"exit status {done.returncode}, and these files are too many or missing: {sorted(there ^ expected)}")
        if done.returncode == 1:
            if self.number % 20 == 0 and self.run(folder, "check", *names).returncode != 1:
                raise Defect("generate refuses what check accepts")
            return None
        model = self.run(folder, "model", names[0]).stdout.decode()
        if self.number % 10 == 0:
            self.look_twice(folder, names, headers)
        return Accepted(self.number, folder, [folder / header for header in headers], model)

    def look_twice(self, folder, names, headers):
        """The same headers again, and a drawing that is JSON."""
        before = [(folder / header).read_bytes() for header in headers]
        self.run(folder, "generate", *names, "-o", "again")
        if before != [(folder / "again" / Path(header).name).read_bytes() for header in headers]:
            raise Defect("a second run writes something else")
        shutil.rmtree(folder / "again")
        if len(before[0]) < 200_000:
            drawing = self.run(folder, "layout", names[0], "--json")
            if drawing.returncode == 0:
                json.loads(drawing.stdout)
            self.run(folder, "layout", names[0])

    def keep(self, number, folder, what):
        kept = self.folder / "failures" / f"seed{self.seed}-{number}"
        shutil.rmtree(kept, ignore_errors=True)
        shutil.copytree(folder, kept)
        (kept / "reason.txt").write_text(what, errors="replace")
        self.failures += 1
        print(f"FAILED: seed {self.seed}, schema {number}: {what[:2000]}\nkept in {kept}", flush=True)

    def generate(self):
        accepted = []
        for _ in range(SCHEMAS):
            folder = self.folder / "work" / str(self.number)
            folder.mkdir(parents=True)
            schema = None
            try:
                schema = self.check(folder)
            except (Defect, json.JSONDecodeError, UnicodeDecodeError, ExpatError) as defect:
                self.keep(self.number, folder, f"{type(defect).__name__}: {defect}")
            else:
                self.accepted += schema is not None
                self.refused += schema is None
            if schema is None:
                shutil.rmtree(folder)
            else:
                accepted.append(schema)
            self.number += 1
        return accepted

    def round(self):
        first = self.number
        shutil.rmtree(self.folder / "work", ignore_errors=True)
        accepted = self.generate()
        if not accepted:
            print(f"FAILED: no schema from {first} to {self.number} was accepted: the fuzzer says nothing any more")
            self.failures += 1
            return
        chosen = choose(accepted, random.Random(f"{self.seed}/{first}/choice"))
        if compile_all(chosen, self.folder, self.compiler):
            for schema, messages in culprits(chosen, self.folder, self.compiler):
                self.keep(schema.number, schema.folder, "accepted, but the header does not compile\n" + messages)
        self.compiled += len(chosen)
        print(f"seed {self.seed}, schemas up to {self.number}: {self.accepted} accepted, {self.refused} refused, {self.compiled} "
              f"compiled, {self.failures} failed; slowest {self.slowest[0]:.2f} s of processor time (schema {self.slowest[1]})", flush=True)


def main():
    parser = argparse.ArgumentParser(description="Random schemas through physgen and a compiler.")
    parser.add_argument("--physgen", required=True, help="the command to test")
    parser.add_argument("--folder", required=True, help="where to work and to keep schemas that fail")
    parser.add_argument("--seed", type=int, default=int.from_bytes(os.urandom(4), "big"), help="without: a new one, printed")
    parser.add_argument("--first", type=int, default=0, help="number of the first schema, to repeat one that failed")
    parser.add_argument("--minutes", type=float, default=0, help="how long to go on; without: one round")
    parser.add_argument("--no-memory-limit", action="store_true", help="for a physgen with an address sanitizer")
    parser.add_argument("compiler", nargs="+", help="the compiler with the flags for generated headers, after --")
    arguments = parser.parse_args()
    fuzzer = Fuzzer(arguments)
    print(f"fuzz: seed {arguments.seed}", flush=True)
    end = time.monotonic() + 60 * arguments.minutes
    fuzzer.round()
    while time.monotonic() < end:
        fuzzer.round()
    shutil.rmtree(fuzzer.folder / "work", ignore_errors=True)
    return 1 if fuzzer.failures else 0


if __name__ == "__main__":
    sys.exit(main())
