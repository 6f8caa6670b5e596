#!/usr/bin/env python3
"""Programs of scenes, known ones and random ones: what physgen joins of their steps has the bits of the steps one by one.

    programs.py --physgen PHYSGEN --folder FOLDER --runtime LIBRARY... [--seed SEED] [--minutes N] [--first NUMBER] [--known] -- COMPILER FLAGS...

A random block has steps, and between them statements of 40 kinds, most of which do something; some of its kernels are made of the
parts of kernel_programs.py. With --known, all known programs come first. A block whose numbers differ is printed. Exit status 1 if any does."""
import argparse
import os
import random
import shutil
import sys
import time
from pathlib import Path

from attack_programs import MINE, REVIEWED
from held_programs import HELD
from kernel_programs import EFFECTS, HARMLESS, KERNELS, kernel
from own_programs import OF_LINES, OWN
from scene_programs import Block, Defect, Harness

BLOCKS = 60  # of a round

BEFORE = """struct Held { float* p; float get() const { *p += 2; return 1; } operator float() const { return get(); } };
struct AtEnd { float* p; float v; ~AtEnd() { *p = 7; } };
struct Pair { float x, y; };
inline float changed(float& x) { x += 1.5F; return x; }
inline float asked(float x) { return x + 1; }
constexpr float doubled(float x) { return x * 2; }
constexpr float stored(Held h) { *h.p = 3; return 1; }
""" + "\n".join(head for _, head, _ in EFFECTS + HARMLESS) + "\n"

# Names that a block may use, and how they are declared in it: s and t are numbers that may change.
DECLARED = {
    "advance": "const auto advance = [&] { s += 0.5F; return s; };",
    "r": "float& r = s;",
    "p": "float* const p = &t;",
    "h": "const Held h{&s};",
    "v": "std::vector<float> v{1, 2, 3};",
    "word": "const std::function<float()> word = [&] { t = 7; return s; };",
}

# Statements of 40 kinds; NEW is a name that they declare, and that may be given to steps behind them.
STATEMENTS = [
    "const float NEW = 2.5F;", "const float NEW = c * 2 + s;", "const auto NEW = s + t;", "const auto NEW = -t;", "float NEW = s;",
    "const float NEW = s > t ? s : c;", "const float NEW = pick;", "const float NEW = choice.by;", "constexpr float NEW = 3;",
    "const Pair NEWpair{s, t};\nconst float NEW = NEWpair.x;", "const float NEW = float(IN.size());", "const float NEW = advance();",
    "advance();", "s += 0.25F;", "++t;", "s = t;", "const float NEW = s++;", "const float NEW = (t = 4);", "r = 2;", "*p = 5;",
    "const float NEW = *p = 6;", "std::swap(s, t);", "const float NEW = std::exchange(s, 3.0F);", "const float NEW = changed(s);",
    "const float NEW = asked(s);", "const float NEW = doubled(s);", "const float NEW = stored(h);", "const float NEW = h.get();", "const float NEW = h;",
    "const float NEW = AtEnd{&s, 2}.v;", "const float NEW = std::invoke(advance);", "const float NEW = word();",
    "const auto NEWkept = [q = word()] { return q; };\nconst float NEW = 1;", "const float NEW = std::accumulate(v.begin(), v.end(), 0.0F, [&](float a, float b) { s += b; return a; });",
    "if (s > 1) t = 3;", "for (int k = 0; k < 2; ++k) s += 1;", "{ const float q = 2; t = q; }", "ACC.view()[index_t{3}].a() = s;",
    "const float NEW = ACC.view()[index_t{5}].a();", "const auto NEWcopy = ACC;\non.run(N, Combine{NEWcopy.view(), IN.const_view(), MID.view()});",
    "static float NEWkept = 1;\nNEWkept += 1;\nconst float NEW = NEWkept;", "const auto [NEW, NEWother] = std::pair(advance(), 2.0F);",
    "try { t += 1; } catch (...) {}", "using NEWtype = Pair;\nconst float NEW = NEWtype{1, 2}.y;", "const volatile float NEW = s;",
    "const auto NEWview = MID.view();", "const auto NEWcount = IN.size();",
]
ARGUMENTS = ["1", "c", "s", "t", "s + c", "-t * 2", "pick", "choice.by", "float(2)", "s > t ? s : t", "s++", "advance()", "asked(t)", "h", "(t += 1)", "*p"]
COUNTS = ["N"] * 12 + ["IN.size()", "MID.size()", "few", "half", "short_count"]


class Maker:
    """Makes the block of a seed and a number."""

    def __init__(self, seed, number):
        self.choose, self.number, self.names, self.kernels = random.Random(f"{seed}/{number}"), number, [], []

    def argument(self):
        named = self.names and self.choose.random() < 0.4
        return self.choose.choice(self.names if named else ARGUMENTS[:10] if self.choose.random() < 0.8 else ARGUMENTS)

    def step(self, source, target):
        kind, count = self.choose.random(), self.choose.choice(COUNTS)
        if kind < 0.25:
            return f"on.run({count}, Both{{{source}, ACC.view(), {target}}});"
        if kind < 0.4:
            return f"on.run({count}, Combine{{{source}, ACC.view(), {target}}});"
        if kind < 0.7:
            return f"on.run({count}, {self.made()}{{{source}, {target}}});"
        return f"on.run({count}, Shift{{{source}, {target}, {self.argument()}}});"

    def made(self):
        """The name of a kernel, one of four of which does something on the side."""
        parts = self.choose.sample(HARMLESS, self.choose.choice([1, 1, 2, 3])) + (self.choose.sample(EFFECTS, 1) if self.choose.random() < 0.25 else [])
        self.choose.shuffle(parts)
        name = f"Made{self.number}x{len(self.kernels)}"
        self.kernels.append(kernel(name, "\n".join(f"{{\n{text}\n}}" for _, _, text in parts))[0])
        return name

    def statement(self):
        text, name = self.choose.choice(STATEMENTS), f"z{len(self.names)}"
        if self.choose.random() < 0.3:  # harmless more often than by chance, so that steps are joined
            text = self.choose.choice(STATEMENTS[:11])
        if "float NEW " in text or "auto NEW " in text or "[NEW," in text:
            self.names.append(name)
        return text.replace("NEW", name)

    def block(self):
        way = ["IN.const_view()", "MID.view()", *(["MORE.view()"] if self.choose.random() < 0.4 else []), "OUT.view()"]
        lines = ["on.run(N, Shift{IN.const_view(), ACC.view(), 3});"] if self.choose.random() < 0.8 else []
        for source, target in zip(way, way[1:]):
            if source != way[0]:
                lines += [self.statement() for _ in range(self.choose.choice([0, 0, 1, 1, 2]))]
            lines.append(self.step(source, target))
        text = "\n".join(lines)
        if "ACC" in text and "Both" not in text and "ACC.view(), 3" not in text:
            text = "on.run(N, Shift{IN.const_view(), ACC.view(), 3});\n" + text
        used = [line for name, line in DECLARED.items() if name in text]
        if self.choose.random() < 0.2:
            text = f"for (int loop = 0; loop < 2; ++loop) {{\n{text}\n}}"
        counts = "const std::uint8_t few = N;\nconst index_t half = N / 2;\nconst short short_count = short(IN.size());\n"
        text = counts + "float s = 1.5F, t = 2;\nconst float c = 0.25F;\n" + "\n".join(used) + "\n" + text
        return Block(f"r{self.number}", text, "\n".join(self.kernels))


class Fuzzer:
    def __init__(self, arguments):
        self.folder = Path(arguments.folder).resolve()
        self.seed, self.number, self.failures, self.joined = arguments.seed, arguments.first, 0, 0
        self.harness = Harness(str(Path(arguments.physgen).resolve()), self.folder / "work", BEFORE,
                               [str(Path(library).resolve()) for library in arguments.runtime], arguments.compiler)

    def round(self, known=()):
        """@param known blocks beside the random ones, of which it is known whether they are joined"""
        blocks = [Maker(self.seed, self.number + k).block() for k in range(BLOCKS)] + list(known)
        self.number += BLOCKS
        names = self.harness.joined(blocks, MINE)
        joined = [block for block in blocks if block.name in names]
        differ = self.harness.differ(joined, MINE) if joined else set()
        for block in blocks:
            if block in known and block.joined != (block.name in names):
                self.fail(f"{block.name} is {'' if block.name in names else 'not '}joined")
            if block.name in differ:
                self.fail(f"seed {self.seed}, block {block.name} has other numbers:\n{block.before}{block.text}")
        random_ones = len(joined) - sum(block in known for block in joined)
        self.joined += random_ones
        print(f"seed {self.seed}, blocks up to {self.number}: steps of {self.joined} joined, {self.failures} failed", flush=True)
        if random_ones == 0:
            self.fail(f"no steps of blocks up to {self.number} are joined: the fuzzer says nothing any more")

    def known(self):
        known = REVIEWED + HELD + OWN + KERNELS
        self.round(known)
        print(f"{len(known) + len(OF_LINES)} known programs, {sum(block.joined for block in known)} of them to be joined", flush=True)
        for name in self.harness.joined(OF_LINES):
            self.fail(f"{name} is joined")

    def fail(self, what):
        self.failures += 1
        print("FAILED: " + what, flush=True)


def main():
    parser = argparse.ArgumentParser(description="Programs of scenes through physgen, joined and not.")
    parser.add_argument("--physgen", required=True, help="the command to test")
    parser.add_argument("--folder", required=True, help="where to work")
    parser.add_argument("--runtime", action="append", required=True, help="library that programs are linked to; repeated")
    parser.add_argument("--seed", type=int, default=int.from_bytes(os.urandom(4), "big"), help="without: a new one, printed")
    parser.add_argument("--first", type=int, default=0, help="number of the first block, to repeat one that failed")
    parser.add_argument("--minutes", type=float, default=0, help="how long to go on; without: one round")
    parser.add_argument("--known", action="store_true", help="run the known programs, too")
    parser.add_argument("compiler", nargs="+", help="the compiler with the flags for generated headers, after --")
    arguments = parser.parse_args()
    fuzzer = Fuzzer(arguments)
    print(f"programs: seed {arguments.seed}", flush=True)
    end = time.monotonic() + 60 * arguments.minutes
    shutil.rmtree(fuzzer.folder / "work", ignore_errors=True)
    try:
        fuzzer.known() if arguments.known else fuzzer.round()
        while time.monotonic() < end:
            fuzzer.round()
    except Defect as defect:
        fuzzer.fail(str(defect))
    if fuzzer.failures == 0:
        shutil.rmtree(fuzzer.folder / "work", ignore_errors=True)
    return 1 if fuzzer.failures else 0


if __name__ == "__main__":
    sys.exit(main())
