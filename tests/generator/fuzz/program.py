"""A program that includes the generated headers of many schemas behind the headers that users include, and instantiates
what was generated for every object: array, view, get and put, in float and double."""
import json
import subprocess
from pathlib import Path

# So that it compiles in about half a minute:
LARGEST_PROGRAM = 3 << 20  # [bytes of generated headers]
MOST_OBJECTS = 100
HEAD = """#include <unistd.h>
#include <sys/stat.h>
#include <signal.h>
#include <strings.h>
#include <time.h>

#include <cassert>
#include <cerrno>
#include <cfloat>
#include <cinttypes>
#include <climits>
#include <cmath>
#include <complex>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <vector>

#include <Eigen/Dense>
%s
#include <physgen/arrays/array.h>

template <class Array>
void use() {
  Array array(3);
  const auto view = array.view();
  const auto value = view.get(1);
  view.put(0, value);
  const auto& constant = array;
  (void)constant.view().get(2);
}

void use_all();
void use_all() {
%s}
"""


class Accepted:
    """A schema that physgen accepted, with its generated headers."""

    def __init__(self, number, folder, headers, model):
        self.number, self.folder, self.headers = number, folder, headers
        names = [(o.get("scope", ""), o["name"]) for o in json.loads(model)["objects"]]
        self.objects = [f"{scope}::{name}" if scope else name for scope, name in names]
        self.namespaces = {scope.split("::")[0] for scope, _ in names}
        self.bytes = sum(header.stat().st_size for header in headers)


def choose(accepted, random, most=50):
    """Up to `most` schemas whose namespaces differ and that are not too large together; sometimes one that alone is."""
    fits = [schema for schema in accepted if schema.bytes <= LARGEST_PROGRAM and len(schema.objects) <= MOST_OBJECTS]
    large = [schema for schema in accepted if schema not in fits]
    if large and (not fits or random.random() < 0.1):
        return [random.choice(large)]
    chosen, namespaces, size, objects = [], set(), 0, 0
    for schema in random.sample(fits, len(fits)):
        if len(chosen) == most:
            break
        too_large = size + schema.bytes > LARGEST_PROGRAM or objects + len(schema.objects) > MOST_OBJECTS
        if schema.namespaces & namespaces or too_large:
            continue
        chosen.append(schema)
        namespaces |= schema.namespaces
        size += schema.bytes
        objects += len(schema.objects)
    return chosen


def compile_all(schemas, folder, compiler):
    """@return the compiler's messages; empty: the program compiles"""
    includes = "".join(f'#include "{header}"\n' for schema in schemas for header in schema.headers)
    calls = "".join(f"  use<::{name}Array<{real}>>();\n" for schema in schemas for name in schema.objects
                    for real in ("float", "double"))
    program = Path(folder) / "program.cpp"
    program.write_text(HEAD % (includes, calls))
    done = subprocess.run([*compiler, "-fsyntax-only", str(program)], capture_output=True, text=True, errors="replace", check=False)
    if done.returncode == 0:
        return ""
    return done.stdout + done.stderr or f"exit status {done.returncode}"


def culprits(schemas, folder, compiler):
    """The schemas that do not compile by themselves, with the messages, found by halving; all of them, if each does."""
    found = []

    def search(part):
        messages = compile_all(part, folder, compiler)
        if not messages:
            return
        if len(part) == 1:
            found.append((part[0], messages))
            return
        search(part[:len(part) // 2])
        search(part[len(part) // 2:])

    search(schemas)
    return found or [(schema, "only together with others: " + compile_all(schemas, folder, compiler)) for schema in schemas]
