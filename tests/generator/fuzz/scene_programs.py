"""Scenes whose programs are made of blocks, each with arrays of its own; and what physgen joins of them, run.

A block is C++ between whose steps anything may stand. In its text IN is the input, MID, MORE and ACC are arrays of the block, OUT
and ACC are outputs, N is the number of objects. All blocks stand in one program, of which physgen says which blocks it joins.
These stand in another, which is compiled once as it is written over arrays with every field, and once as physgen has joined it,
and both are run: in float and in double, twice each."""
import json
import re
import subprocess
from dataclasses import dataclass

SCHEMA = """#include <physgen/schema.h>
namespace m {
using namespace physgen::schema;
struct PHYSGEN_OBJECT() Point { Scalar a; };
}
"""

KERNELS = """#pragma once
#include <points.physgen.h>
#include <physgen/fuse.h>
#include <physgen/kernel.h>
#include <physgen/kernels/lanes.h>
using namespace physgen;  // as tools/examples/kernels.md has it, and scenes use physgen::scene

/// to = 2 from + by
template <class From, class To>
struct Shift {
  using Scalar = typename To::Precision;
  From from;
  To to;
  float by;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    to[i].a() = S(from[i].a()) * S(Scalar(2)) + S(Scalar(by));
  }
};
template <class From, class To>
Shift(From, To, float) -> Shift<From, To>;

/// acc = 3 from, to = from + 1
template <class From, class Acc, class To>
struct Both {
  using Scalar = typename To::Precision;
  From from;
  Acc acc;
  To to;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    const S a = from[i].a();
    acc[i].a() = a * S(Scalar(3));
    to[i].a() = a + S(Scalar(1));
  }
};
template <class... V>
Both(V...) -> Both<V...>;

/// to = x + 5 y
template <class X, class Y, class To>
struct Combine {
  using Scalar = typename To::Precision;
  X x;
  Y y;
  To to;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    to[i].a() = S(x[i].a()) + S(y[i].a()) * S(Scalar(5));
  }
};
template <class... V>
Combine(V...) -> Combine<V...>;

/// Choices of a program's run.
struct Choice {
  float pick = 0, by = 0.125F;
};
"""

MAIN = """#include <physgen/executor.h>

#include <cstdio>
#include <cstring>

#include "out/blocks.everything.h"
#include "out/blocks.program.h"

template <class Body, class Program>
void run(const char* precision) {
  Body body;
  body.allocate({.point = %(count)d, .few = 7});
  for (physgen::index_t i = 0; i < %(count)d; ++i) body.in.contents().view()[i].a() = 0.25F * float(i %% 37) - 4;
  physgen::HostExecutor on;
  for (const float pick : {2.0F, 1.0F}) {
    Program::program(on, body, Choice{pick, 0.125F}, pick);
    const auto print = [&](const char* name, auto& array) {
      unsigned long long sum = 14695981039346656037ULL;
      for (physgen::index_t i = 0; i < array.size(); ++i) {
        const double a = array.view()[i].a();
        unsigned long long bits;
        std::memcpy(&bits, &a, sizeof bits);
        sum = (sum ^ bits) * 1099511628211ULL;
      }
      std::printf("%%s %%s %%g %%llx\\n", name, precision, double(pick), sum);
    };
%(prints)s
  }
}

int main(int, char** arguments) {
  using physgen::Host;
  if (std::strcmp(arguments[1], "joined") == 0) {
    run<blocks_scene::Body<Host, float>, blocks_scene::fused>("float");
    run<blocks_scene::Body<Host, double>, blocks_scene::fused>("double");
  } else {
    run<blocks_everything::Body<Host, float>, blocks>("float");
    run<blocks_everything::Body<Host, double>, blocks>("double");
  }
}
"""


@dataclass
class Block:
    name: str
    text: str
    before: str = ""  # at namespace scope
    joined: bool = False  # whether its steps are to be one


class Defect(Exception):
    """A fault of physgen, or of the blocks."""


def arrays(block):
    """Names and options of a block's arrays."""
    used = set(re.findall(r"\b(MID|MORE|OUT|ACC)\b", block.text))
    return [(word, f"{word.lower()}_{block.name}", ", output()" if word in ("OUT", "ACC") else "") for word in sorted(used)]


def scene(blocks, before):
    declared, program = "", ""
    for block in blocks:
        text = re.sub(r"\bIN\b", "body.in", re.sub(r"\bN\b", "n", block.text))
        for word, name, option in arrays(block):
            declared += f'    PHYSGEN_ARRAY(per("point"){option}) Array<m::PointObject, Real> {name};\n'
            text = re.sub(rf"\b{word}\b", f"body.{name}", text)
        program += "    {\n" + "".join(f"      {line}\n" for line in text.strip().splitlines()) + "    }\n"
    return f"""#pragma once
#include <physgen/scene.h>
#include <physgen/mine.h>
#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cfenv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <memory>
#include <new>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>
#include "kernels.h"
{before}{"".join(block.before + chr(10) for block in blocks if block.before)}
using namespace physgen::scene;
struct PHYSGEN_SCENE() blocks {{
  using Real = float;
  struct Body {{
    PHYSGEN_ARRAY(per("point"), input()) Array<m::PointObject, Real> in;
    PHYSGEN_ARRAY(per("few"), input()) Array<m::PointObject, Real> few;
{declared}  }};
  template <class On, class Body>
  static void program(On& on, Body& body, const Choice& choice, float pick) {{
    const auto n = body.in.size();
    (void)choice;
    (void)pick;
{program}  }}
}};
"""


class Harness:
    """@param before what stands before all blocks at namespace scope
    @param runtime the libraries that programs are linked to
    @param compiler with the flags of generated headers, which physgen is given, too"""

    def __init__(self, physgen, folder, before, runtime, compiler, count=533):
        self.before, self.physgen, self.folder, self.runtime, self.count = before, physgen, folder, runtime, count
        self.compiler = [*compiler, "-I.", "-Igenerated", "-Iinc"]
        flags = iter(self.compiler[1:])
        self.flags = []
        for flag in flags:
            if flag in ("-isystem", "-I"):
                self.flags += [flag, next(flags)]
            elif flag.startswith(("-I", "-isystem", "-march=")):
                self.flags.append(flag)

    def call(self, *command):
        try:
            done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, check=False, timeout=900)
        except subprocess.TimeoutExpired as error:
            raise Defect(f"{' '.join(command)} did not end in 15 minutes: a program that loops forever, or physgen hangs") from error
        if done.returncode != 0:
            raise Defect(f"{' '.join(command)} gave {done.returncode}\n{done.stdout[-4000:]}{done.stderr[-8000:]}")
        return done.stdout

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def write_all(self, blocks, mine):
        self.write("points.h", SCHEMA)
        self.write("kernels.h", KERNELS)
        self.write("inc/physgen/mine.h", mine)
        self.write("scenes/blocks.h", scene(blocks, self.before))
        self.call(self.physgen, "generate", "points.h", "-o", "generated")

    def joined(self, blocks, mine="#pragma once\n", *options):
        """@return names of the blocks of which steps are joined: what physgen writes of the others is their own text"""
        self.write_all(blocks, mine)
        if not (self.folder / "headers.pch").exists():  # the runtime's headers are read once
            self.call(self.physgen, "precompile", "-o", "headers.pch", "--", *self.flags)
        self.call(self.physgen, "scene", "scenes/blocks.h", "-o", "out", "--precompiled", "headers.pch", *options, "--", *self.flags)
        text = json.dumps(json.loads((self.folder / "out/blocks.need.json").read_text())["groups"])
        return {block.name for block in blocks if any(f'body.{name}"' in text for _, name, _ in arrays(block))}

    def differ(self, blocks, mine="#pragma once\n"):
        """@return names of the blocks whose numbers are others where their steps are joined"""
        joined = self.joined(blocks, mine, "--everything")
        if joined != {block.name for block in blocks}:
            raise Defect(f"{len(joined)} of {len(blocks)} blocks are joined in a scene of their own, which all were in another")
        prints = "".join(f'    print("{block.name}", body.{name});\n' for block in blocks for _, name, option in arrays(block) if option)
        self.write("main.cpp", MAIN % {"count": self.count, "prints": prints})
        self.call(*self.compiler, "-O0", "-w", "main.cpp", *self.runtime, "-o", "main")
        # By one thread: kernels with effects stay apart, and on several threads their numbers differ from run to run.
        separate, fused = (self.call("env", "OMP_NUM_THREADS=1", "./main", way).splitlines() for way in ("separate", "joined"))
        return {a.split()[0] for a, b in zip(separate, fused, strict=True) if a != b}
