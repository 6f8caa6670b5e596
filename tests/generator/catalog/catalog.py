#!/usr/bin/env python3
"""Everything in the catalogue, from the schema's words to values in memory.

  catalog.py as_it_is   a program with everything in the catalogue compiles, and its values come back (everything.cpp)
  catalog.py extended   so they do in a copy of the tree to which a layout, a format and a shape are added, each by a
                        change of at most four files. All of the generator is compiled there but what includes Clang
                        or the JSON library, which takes seconds: that is linked as it is, since it takes what it knows
                        of the catalogue from functions.
"""
import argparse
import re
import shutil
import subprocess
import sys
from pathlib import Path

LARGEST_ADDITION = 4  # files
CATALOG = "generator/model/catalog.h"
SCHEMA = "runtime/include/physgen/schema.h"


class Tree:
    """A copy of the sources that remembers which files were changed."""

    def __init__(self, folder):
        self.folder = folder
        self.touched = set()

    def create(self, path, text):
        assert not (self.folder / path).exists(), path
        (self.folder / path).write_text(text)
        self.touched.add(path)

    def insert(self, path, pattern, text):
        """Puts the text behind the first match of the pattern."""
        old = (self.folder / path).read_text()
        match = re.search(pattern, old, re.DOTALL)
        assert match, f"{path} has no {pattern}"
        (self.folder / path).write_text(old[: match.end()] + text + old[match.end():])
        self.touched.add(path)

    def add_enumerator(self, path, enumeration, name):
        self.insert(path, r"enum class %s \{[^}]*\w(?= ?\})" % enumeration, ", " + name)

    def add_row(self, table, row):
        self.insert(CATALOG, r" %s\[\] = \{\n.*?\},\n(?=\};)" % table, "    " + row + "\n")


def add_layout(tree):
    """Struct of arrays whose channels begin at odd multiples of 128 bytes or more, so that they spread over all sets of
    a cache."""
    tree.create("runtime/include/physgen/layout/soa_odd.h", """// Struct of arrays with an odd number of lines per channel.
#pragma once

#include <physgen/layout/soa.h>

namespace physgen {

struct SoaOdd : Soa {
  static constexpr const char* name = "soa_odd";
  [[nodiscard]] static constexpr index_t padded(index_t objects) {
    const index_t whole = align_up(objects, padding_objects);
    return whole / padding_objects % 2 == 0 ? whole + padding_objects : whole;
  }
  [[nodiscard]] static constexpr index_t pitch(index_t objects) { return padded(objects); }
};

}  // namespace physgen
""")
    tree.insert("runtime/include/physgen/layout.h", r"#include <physgen/layout/soa.h>\n",
                "#include <physgen/layout/soa_odd.h>\n")
    tree.add_enumerator(SCHEMA, "Arrangement", "soa_odd")
    tree.insert(SCHEMA, r"Pattern soa\{[^;]*;\n",
                "inline constexpr detail::Pattern soa_odd{detail::Arrangement::soa_odd, 0};\n")
    tree.add_enumerator(CATALOG, "LayoutKind", "soa_odd")
    tree.insert(CATALOG, r"(?=constexpr int packed_record)",
                """constexpr long long pitch_of_odd_lines(long long objects, int /*tile*/) {
  const long long whole = align_up(objects, 32LL);
  return whole / 32 % 2 == 0 ? whole + 32 : whole;
}
""")
    tree.add_row("layout_rows", '{LayoutKind::soa_odd, "soa_odd", "SoaOdd", false, detail::pitch_of_odd_lines, '
                                "detail::packed_record},")


def add_format(tree):
    """Halves of the distance from the middle of a range: temperatures around 300 K, in 16 bits."""
    tree.create("runtime/include/physgen/format/centred_half.h", """// Halves around the middle of a stated range.
#pragma once

#include <physgen/format/half.h>
#include <physgen/format/scaled.h>
#include <physgen/format/snorm16.h>

namespace physgen::format {

/// Absolute error <= (high - low) / 8192, and less near the middle.
template <Interval kRange>
struct CentredHalf : Scaled<Half<>, Affine{.scale = kRange.high / 2 - kRange.low / 2,
                                           .centre = kRange.high / 2 + kRange.low / 2}> {
  using Library = CentredHalf;
  static constexpr const char* name = "centred_half";
};

}  // namespace physgen::format
""")
    tree.insert("runtime/include/physgen/format.h", r"#include <physgen/format/bfloat16.h>\n",
                "#include <physgen/format/centred_half.h>\n")
    tree.add_enumerator(SCHEMA, "Encoding", "centred_half")
    tree.insert(SCHEMA, r"StorageFormat snorm16\{[^;]*;\n",
                "inline constexpr detail::StorageFormat centred_half{detail::Encoding::centred_half, 0};\n")
    tree.add_enumerator(CATALOG, "Encoding", "centred_half")
    tree.add_row("encoding_rows", """{.key = Encoding::centred_half,
     .word = "centred_half",
     .type = "CentredHalf",
     .bytes = 2,
     .scaling = Scaling::interval,
     .largest = FLT_MAX,
     .steps = 4096,
     .name = "centred half",
     .components = "halves",
     .rotation_error = "2e-3"},""")


def add_shape(tree):
    """Lower triangular matrices: factors of Cholesky's."""
    tree.insert("runtime/include/physgen/fields/shape.h", r"(?=/// Diagonal N x N matrix)",
                """/// Lower triangular N x N matrix: the lower triangle, column by column. The value is the full matrix.
template <int N>
struct Lower : Symmetric<N> {
  template <class S>
  using Value = Eigen::Matrix<S, N, N>;
  template <class S, class Elements>
  [[nodiscard]] PHYSGEN_FUNCTION static Value<S> value(const Elements& elements) {
    Value<S> m = Symmetric<N>::template value<S>(elements);
    for (int c = 1; c < N; ++c)
      for (int r = 0; r < c; ++r) m(r, c) = S(0);
    return m;
  }
};

""")
    tree.insert(SCHEMA, r"struct Symmetric \{\};\n",
                "\n/// Lower triangular matrix.\ntemplate <int Size, class Element = Scalar>\nstruct Lower {};\n")
    tree.add_enumerator(CATALOG, "Shape", "lower")
    tree.add_row("shape_rows", """{.key = Shape::lower,
     .word = "lower",
     .type = "Lower",
     .phrase = "lower triangular",
     .sides = Sides::square,
     .count = detail::lower_triangle,
     .entry = detail::in_lower_triangle,
     .uniform = false},""")


def run(command, **options):
    done = subprocess.run([str(word) for word in command], **options)
    if done.returncode != 0:
        sys.exit(f"{command[0]} ended with status {done.returncode}")
    return done.stdout


def values_come_back(arguments, everything, runtime, expected):
    """Compiles and runs the program that `everything` writes, which must name what is expected."""
    drawing = run([everything, arguments.folder, runtime], stdout=subprocess.PIPE, text=True)
    program = (arguments.folder / "all.cpp").read_text()
    for word in expected:
        if f'"{word}"' not in program:
            sys.exit(f"the program has no {word}")
    run([*arguments.compiler, f"-I{runtime}", f"-I{arguments.root}/tests/generator/catalog",
         arguments.folder / "all.cpp", *arguments.runtime, "-o", arguments.folder / "all"])
    print(run([arguments.folder / "all"], stdout=subprocess.PIPE, text=True), end="")
    return drawing


def as_it_is(arguments):
    values_come_back(arguments, arguments.everything, arguments.root / "runtime/include", ["half", "aosoa"])


def extended(arguments):
    copy = arguments.folder / "copy"
    shutil.rmtree(copy, ignore_errors=True)
    for part in ("generator", "runtime/include", "tools/physgen"):
        shutil.copytree(arguments.root / part, copy / part)
    for add in (add_layout, add_format, add_shape):
        tree = Tree(copy)
        add(tree)
        print(f"{add.__name__}: {len(tree.touched)} files, {', '.join(sorted(tree.touched))}")
        if len(tree.touched) > LARGEST_ADDITION:
            sys.exit(f"that is more than {LARGEST_ADDITION}")
    parts = [copy / "generator" / part for part in ("model", "plan", "emit")]
    sources = [source for part in parts for source in sorted(part.rglob("*.cpp"))]
    sources += sorted((copy / "tools/physgen").glob("layout_*.cpp"))
    sources.append(arguments.root / "tests/generator/catalog/everything.cpp")
    # All sources are compiled as one, since reading the headers that they share is what takes time.
    together = arguments.folder / "together.cpp"
    together.write_text("".join(f'#include "{path}"\n' for path in sources if not path.stem.endswith("json")))
    folders = [f"-I{copy}/{folder}" for folder in ("generator", "tools/physgen", "runtime/include")]
    everything = arguments.folder / "everything"
    run([*arguments.compiler, *folders, "-DPHYSGEN_ANY_MODE", together, *arguments.link, "-o", everything])
    drawing = values_come_back(arguments, everything, copy / "runtime/include",
                               ["soa_odd", "centred_half", "shape_lower"])
    for words in ("shape_lower(2,2)", "Layout_soa_odd on host, soa_odd,", "pitch 1048608 for 1048576 objects"):
        if words not in drawing:
            sys.exit(f"the drawing has no '{words}'")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("test", choices=["as_it_is", "extended"])
    parser.add_argument("--root", type=Path, required=True, help="the sources")
    parser.add_argument("--folder", type=Path, required=True, help="of what is written")
    parser.add_argument("--everything", type=Path, required=True, help="the program made of everything.cpp")
    parser.add_argument("--runtime", type=Path, action="append", required=True, help="library that the program is linked to; repeated")
    parser.add_argument("--link", action="append", default=[], help="what everything.o is linked to; repeated")
    parser.add_argument("--compiler", nargs=argparse.REMAINDER, required=True, help="and its flags")
    arguments = parser.parse_args()
    arguments.folder /= arguments.test
    arguments.folder.mkdir(parents=True, exist_ok=True)
    {"as_it_is": as_it_is, "extended": extended}[arguments.test](arguments)


if __name__ == "__main__":
    main()
