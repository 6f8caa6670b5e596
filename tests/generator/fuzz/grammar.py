"""Writes random schemas, most of them sound or nearly so: names, types and options are drawn from ordinary ones and from
those that could make trouble in generated code."""

ORDINARY_FIELDS = ["x", "y", "z", "F", "U", "V", "s", "mass", "velocity", "J2", "EA", "x1111", "dPdF", "k_1", "node_of"]
TRICKY_FIELDS = [
    "value", "entry", "cursor", "name", "fields", "size", "index", "time", "at", "view", "T", "S", "Host", "Cuda",
    "Layout", "data", "begin", "end", "setZero", "other", "from", "to", "swap", "field", "Object", "Array", "View",
    "Ref", "self", "i", "lanes", "Lanes", "plan", "offset", "stride", "half", "float32", "host", "cuda", "Scalar",
    "Index", "Vector", "min", "max", "abs", "int32_t", "same_lanes_t", "all_lanes", "shape", "format", "nested", "slot",
    "N", "E", "Aos", "ElementRef", "FieldRef", "batch", "select", "sum", "add", "detail", "SIGMA", "string_view",
    "array", "int8_t", "B0", "is_sound_record", "Native", "Rotation", "Diagonal", "source", "result", "target", "that",
    "ArrayTag", "Base", "first", "Probe",
]
ORDINARY_OBJECTS = ["Node", "Tet", "Stress", "Svd", "Corner", "Edge", "Grain", "Shell", "Beam", "Link"]
TRICKY_OBJECTS = [
    "Foo", "FooRef", "FooArray", "FooView", "FooFormats", "FooProbe", "FooRecord", "FooObject", "index", "time", "Host",
    "Cuda", "Field", "Soa", "Slot", "T", "E", "detail", "format", "shape", "FILE", "Error", "Losses", "Stream", "Half",
    "Native", "Unit", "Range", "Pattern", "x", "F", "value", "entry", "string_view", "array", "FieldInfo", "Lanes",
    "Tile", "S", "A", "B", "int32_t", "Ref2",
]
REFUSED_NAMES = [
    "Array", "Cursor", "Cursor_", "EDOM", "Eigen", "Formats", "INT_MAX", "K_IC", "Layout", "M_PI", "Matrix", "NAN",
    "NULL", "Real", "Record", "Space", "Value", "Xi_", "Xi__1", "_x", "a__b", "alignment", "assert", "at_", "bytes",
    "class", "decltype_", "errno", "get", "linux", "offsetof", "operator", "physgen", "plan_", "put", "std", "x_", "λ",
]
# All words of C++20: keywords, alternative tokens, and identifiers with a special meaning.
WORDS = '''alignas alignof and and_eq asm auto bitand bitor bool break case catch char char8_t char16_t char32_t class compl
concept const consteval constexpr constinit const_cast continue co_await co_return co_yield decltype default delete do double
dynamic_cast else enum explicit export extern false float for friend goto if inline int long mutable namespace new noexcept not
not_eq nullptr operator or or_eq private protected public register reinterpret_cast requires return short signed sizeof static
static_assert static_cast struct switch template this thread_local throw true try typedef typeid typename union unsigned using
virtual void volatile wchar_t while xor xor_eq final import module override'''.split()
REFUSED_NAMES += WORDS + ["I", "major", "minor", "makedev", "MAX", "howmany", "restrict", "complex", "asm", "typeof", "unix"]
INNER_NAMESPACES = ["detail", "shape", "m", "n1", "FooRef", "FooArray", "NodeView", "host", "a", "index", "v1", "Foo", "std",
                    "physgen", "Eigen", "M_PI", "E", "x"]
OUTER_NAMESPACES = ["index", "time", "std", "physgen", "Eigen", "xsimd", "exp", "y0", "tm", "FILE", "M_PI", "EOF", "linux", "detail", *WORDS]
ELEMENTS = ["Scalar", "Scalar", "Scalar", "Index", "float", "double", "int"]
SIZES = [1, 2, 3, 3, 3, 4, 6, 9, 12]
WILD_SIZES = [0, -1, 7, 16, 33, 100, 128, 129, 181, 182, 200, 1024, 1025, 65536, 2147483647, 99999999999, "3 - 2", "sizeof(int)",
              "n", "'a'", "true"]
EXTENTS = [1, 2, 3, 4, 8, 32, 33]
WILD_EXTENTS = [0, -1, 1000, 5000, 65536, 65537, 2147483648, "n", ""]
NUMBERS = ["0", "1", "-1", "0.5", "2", "1e-3", "100", "1.0 / 3", "0.1", "-0.25"]
WILD_NUMBERS = ["1e-60", "0x1p64", "1e300", "1e39", "-0.0", "1e-45", "1e-46", "3.4028235e38", "1e9", "65504", "65505",
                "2147483647", "-2147483648", "2147483648", "1e-320", "__builtin_inf()", "__builtin_nan(\"\")", "1e20",
                "1.2345678901234568e20", "9223372036854775807", "1e-34", "2e-35", "4.9e-324", "1.7976931348623157e308", "'x'",
                "0x1p115", "0x1p-86", "1e15", "1e16", "1e17", "123456789", "16777217"]
UNITS = ["m", "Pa", "N/m^2", "1", "kg m^-3", "µm"]
WILD_UNITS = ["", "\\\"", "\\\\", "*/", "//", "%s", "\\n", "x" * 64, "x" * 65, "??/", "\\x01", "}"]
STORAGES = ["float32", "float64", "half", "bfloat16", "half", "snorm16"]
WILD_STORAGES = ["quaternion()", "quaternion(half)", "quaternion(quaternion())", "{static_cast<detail::Encoding>(77), 0}",
                 "{detail::Encoding::half, 2}", "halv", "3", "quaternion(float64)", "{detail::Encoding::native, 0}", "{}"]
PATTERNS = ["aos", "aos_padded", "soa", "aosoa(16)", "aosoa(32)", "aosoa(8)"]
WILD_PATTERNS = ["aosoa(0)", "aosoa(1)", "aosoa(33)", "aosoa(1024)", "aosoa(2048)", "sao", "{static_cast<detail::Arrangement>(9), 0}",
                 "{detail::Arrangement::soa, 4}", "aosoa(-2)", "{}"]
ALIGNMENTS = ["align(16)", "align(64)", "align(1)", "align(256)"]
WILD_ALIGNMENTS = ["align(0)", "align(24)", "align(512)", "align(-16)", "align(1 << 31)"]
DOCS = ["", "", "", "/// Position of a node.\n", "/** A block\n * of two lines. */\n", "/// %s\n" % ("word " * 60)]
WILD_DOCS = ["/// ends with */ or /* in the middle\n", "/// backslash at the end \\\n", "/// question marks ??/\n", "///\n",
             "/** # define X\n#define Y 1\n*/\n", "/// tab\tand form feed \f and \v\n", "/// caf\xe9 \u2028 \u202e\n",
             "/// R\"( )\" \" ' \n", "/// @tparam Real @pre \\brief\n", "/// \udcff\udcfe not UTF-8\n", "/// " + "x" * 3000 + "\n",
             "/// two\n///\n///\n/// paragraphs \\ \t\n/// #endif\n", "/*! #endif */\n", "//! #error\n"]
WILD_MEMBERS = ["Scalar& r;", "Scalar* p;", "int b : 3;", "virtual void f();", "static int n;", "void f();", "Scalar x = 3;",
                "struct Inner { Scalar x; };", "union { int a; float b; };", "using T = Scalar;", "const Scalar c;",
                "mutable Scalar m;", "private: Scalar h;", "alignas(16) Scalar q;", "Scalar w[2][3];", "unsigned u;", "bool o;",
                "Vector<3, unsigned> vu;", "std::vector<double> v;", "Eigen::Vector3d e;", "enum { red };", "Self s;",
                "friend struct Z;", "int : 0;", "Scalar;", ";", "static_assert(true);", "template <class T> T t;", "Scalar a, a;",
                "_Complex float z;", "Matrix<3> m;", "auto au;", "[[deprecated]] Scalar d;", "Scalar f() const;", "long l;"]


class Grammar:
    """One schema, drawn from `random`; `wild` is the chance of each unusual choice."""

    def __init__(self, random, number):
        self.random = random
        self.number = number
        self.wild = random.choice([0.0, 0.0, 0.0, 0.003, 0.003, 0.01, 0.03, 0.2])
        self.tricky = random.choice([0.0, 0.1, 0.1, 0.3])
        self.objects = []  # (qualified name, scope, name) of those declared so far
        self.taken = set()  # names in the object or the namespace that is being written

    def pick(self, usual, unusual):
        return self.random.choice(unusual if self.random.random() < self.wild else usual)

    def name(self, ordinary, tricky):
        random = self.random
        while True:
            name = random.choice(ordinary) + random.choice(["", "", str(random.randrange(10)), chr(random.randrange(97, 123))])
            if random.random() < self.tricky:
                name = self.pick(tricky, REFUSED_NAMES)
            if name not in self.taken or random.random() < self.wild:
                self.taken.add(name)
                return name

    def files(self):
        """The schema files by name, the main one first."""
        files = {}
        includes = ""
        if self.random.random() < 0.15:
            base = f"base{self.number}.h"
            files[base] = self.file("", f"base{self.number}")
            includes = f'#include "{base}"\n'
        outer = f"s{self.number}"
        if self.random.random() < self.wild / 2:
            outer = self.random.choice(OUTER_NAMESPACES)
        main = self.file(includes, outer)
        return {f"schema{self.number}.h": main, **files}

    def file(self, includes, outer):
        random = self.random
        text = self.pick(["#pragma once\n", ""], ["\ufeff", "#pragma once\r\n", "#if 0\n#else\n#endif\n"])
        text += self.pick(["#include <physgen/schema.h>\n"], ["", "#include <vector>\n#include <physgen/schema.h>\n"]) + includes
        if random.random() < self.wild:
            text += "using namespace physgen::schema;\n" + self.object("")
        text += f"namespace {outer} {{\n" + self.pick(["using namespace physgen::schema;\n"], ["", "namespace p = physgen::schema;\n"])
        text += "inline constexpr int n = 3;\n"
        if random.random() < 0.06:
            text += self.explosion(outer)
        for _ in range(random.choice([1, 1, 2, 2, 3, 5])):
            if random.random() < 0.15:
                inner = random.choice(INNER_NAMESPACES)
                kind = random.choice(["namespace", "namespace", "inline namespace"])
                scope = outer if kind.startswith("inline") else f"{outer}::{inner}"
                text += f"{kind} {inner} {{\n" + self.object(scope) + "}\n"
            else:
                text += self.object(outer)
        return text + "}\n" + self.pick([""], ["}", "#endif\n", "namespace {\n" + self.object("") + "}\n"])

    def explosion(self, scope):
        """Objects that nest each other: a chain, or a tree."""
        random = self.random
        depth, copies = random.choice([(3, 1), (3, 2), (10, 1), (8, 2), (40, 1), (100, 1), (14, 2), (25, 2), (4, 30), (6, 65536)])
        text = "struct PHYSGEN_OBJECT() Level0 { Scalar x; };\n"
        for level in range(1, depth):
            nested = f"Level{level - 1} a, b;" if copies == 2 else f"Level{level - 1} a{f'[{copies}]' if copies > 2 else ''};"
            text += f"struct PHYSGEN_OBJECT() Level{level} {{ {nested} }};\n"
        self.objects.append((f"{scope}::Level{depth - 1}", scope, f"Level{depth - 1}"))
        return text

    def object(self, scope):
        random = self.random
        self.taken = {other for _, inside, other in self.objects if inside == scope}
        name = self.name(ORDINARY_OBJECTS, TRICKY_OBJECTS)
        self.taken = set()
        options = []
        for space in ("host", "cuda"):
            if random.random() < 0.25:
                options.append(f"layout({self.pick([space], ['host', 'gpu', 'static_cast<detail::Space>(5)'])}, "
                               f"{self.pick(PATTERNS, WILD_PATTERNS)})")
        if random.random() < 0.15:
            options.append(self.pick(ALIGNMENTS, WILD_ALIGNMENTS))
        key = self.pick(["struct"], ["class", "union", "template <int N> struct", "struct alignas(64)", "enum"])
        text = self.doc() + f"{key} PHYSGEN_OBJECT({', '.join(options)}) {name} {{\n"
        if random.random() < 0.02:
            many = random.choice([200, 1000, 3000, 10000])
            text += "Scalar " + ", ".join(f"m{i}" for i in range(many)) + ";\n"
        for _ in range(self.pick([1, 2, 3, 4, 6], [0, 40])):
            text += "  " + self.field(scope)
        text += "}" + self.pick([""], [" variable", ""]) + ";\n"
        self.objects.append((f"{scope}::{name}" if scope else name, scope, name))
        return text

    def doc(self):
        return self.pick(DOCS, WILD_DOCS)

    def type(self, scope):
        random = self.random
        if self.objects and random.random() < 0.2:
            qualified, inside, name = random.choice(self.objects)
            return name if inside == scope else random.choice([qualified, "::" + qualified]), True
        element = random.choice(ELEMENTS)
        last = "" if element == "Scalar" else ", " + element
        size, cols = self.pick(SIZES, WILD_SIZES), self.pick(SIZES, WILD_SIZES)
        return random.choice([element, element, f"Vector<{size}{last}>", f"Matrix<{size}, {cols}{last}>", f"Symmetric<{size}{last}>",
                              f"Diagonal<{size}{last}>", f"Skew<{size if size != 1 else 3}{last}>", "Rotation", "Vector<3>"]), False

    def field(self, scope):
        random = self.random
        if random.random() < self.wild / 2:
            return random.choice(WILD_MEMBERS) + "\n"
        kind, nested = self.type(scope)
        options = [] if nested and random.random() > self.wild else self.field_options(kind)
        marker = f"PHYSGEN({', '.join(options)}) " if options else ""
        names = []
        for _ in range(random.choice([1, 1, 1, 2, 3])):
            extent = f"[{self.pick(EXTENTS, WILD_EXTENTS)}]" if random.random() < 0.15 else ""
            names.append(self.name(ORDINARY_FIELDS, TRICKY_FIELDS) + extent)
        after = self.pick(["\n", "\n", "  ///< with a unit\n"], ["  ///< ends \\\n", "  ///< */\n", "  // nothing\n"])
        return self.doc() + marker + kind + " " + ", ".join(dict.fromkeys(names)) + ";" + after

    def field_options(self, kind):
        """Options that mostly suit each other and the type of the field."""
        random = self.random
        whole = "Index" in kind or "int" in kind
        options = []
        if random.random() < 0.3:
            options.append(f'unit("{self.pick(UNITS, WILD_UNITS)}")')
        has_range = random.random() < 0.2
        if has_range:
            low, high = self.pick([("0", "1"), ("-1", "1"), ("-2", "1e3"), ("0", "200e9")], [(self.number_(), self.number_())])
            options.append(f"range({low}, {high})")
        if random.random() < 0.2 and (kind != "Rotation" or random.random() < self.wild):
            options.append(f"initial({self.pick(['0', '1'] if whole or has_range else NUMBERS, WILD_NUMBERS)})")
        for space in ("host", "cuda"):
            if random.random() < 0.15 and (not whole or random.random() < self.wild):
                usual = STORAGES + ["quaternion()", "quaternion(half)", "quaternion(snorm16)"] * 2 if kind == "Rotation" else \
                    STORAGES if has_range else STORAGES[:5]
                options.append(f"format({space}, {self.pick(usual, WILD_STORAGES)})")
        random.shuffle(options)
        return options

    def number_(self):
        return self.pick(NUMBERS, WILD_NUMBERS)
