"""Programs that were right when the others of attack_programs.py gave other numbers: they stay apart, or are joined and right."""
from attack_programs import FIRST, LAST, S, asks, between, kernel
from scene_programs import Block

BOTH = "on.run(N, Both{IN.const_view(), ACC.view(), MID.view()});\n"
TWO = "on.run(N, Shift{IN.const_view(), MID.view(), 1});\non.run(N, Shift{MID.view(), OUT.view(), 2});"


def behind(name, body, joined, head=""):
    """A kernel with a body, and a step behind it."""
    return Block(name, asks(name, body, head).text, kernel(name.capitalize(), body, head), joined)


HELD = [
    # What kernels do with their own objects.
    behind("heldreference", "const auto r = from[i];\n    to[i].a() = S(r.a()) * S(Scalar(3));", True),
    behind("wholeobject", "const auto value = from.get(i);\n    to[i].a() = value.a * S(Scalar(3));", True),
    behind("bound", "const auto [a] = from.get(i);\n    to[i].a() = a * S(Scalar(3));", True),
    behind("compoundly", "to[i].a() = S(from[i].a());\n    to[i].a() += S(Scalar(2));\n    to[i].a() *= S(Scalar(3));", False),
    behind("ofitsown", "to[i].a() = S(from[i].a());\n    to[i].a() = S(to[i].a()) * S(Scalar(3));", False),
    behind("deephelpers", "to[i].a() = thrice(S(from[i].a()));", True,
           "template <class T> PHYSGEN_FUNCTION T doubled_of(const T& x) { return x + x; }\n"
           "template <class T> PHYSGEN_FUNCTION T thrice(const T& x) { return doubled_of(x) + x; }\n"),
    behind("recursivehelpers", "to[i].a() = times<3>(S(from[i].a()));", True,
           "template <int n, class T> PHYSGEN_FUNCTION T times(const T& x) { if constexpr (n == 0) return x; else return times<n - 1>(x) + x; }\n"),
    behind("lambdareference", "S x = from[i].a();\n    const auto more = [](S& y) { y = y * S(Scalar(3)); };\n    more(x);\n    to[i].a() = x;", True),
    behind("fixedobject", "to[i].a() = S(from[i].a()) + S(Scalar(from[index_t{0}].a()));", True),
    Block("basekernel", "on.run(N, Basekernel{BaseOfKernel{IN.const_view(), MID.view()}});\non.run(N, Shift{MID.view(), OUT.view(), 1});",
          "template <class From, class To> struct BaseOfKernel { From from; To to; };\ntemplate <class A, class B> BaseOfKernel(A, B) -> BaseOfKernel<A, B>;\n"
          "template <class From, class To> struct Basekernel : BaseOfKernel<From, To> {\n  using Scalar = typename To::Precision;\n"
          "  template <class I> PHYSGEN_FUNCTION void operator()(I i) const {\n    using S = lanes_t<Scalar, I>;\n"
          "    this->to[i].a() = S(this->from[i].a()) + S(Scalar(1));\n  }\n};\n"
          "template <class A, class B> Basekernel(BaseOfKernel<A, B>) -> Basekernel<A, B>;"),
    Block("neighbours", "on.run(N, Shift{IN.const_view(), MID.view(), 1});\non.run(N, Neighbours{MID.const_view(), OUT.view(), int(N) - 1});",
          "template <class From, class To> struct Neighbours {\n  using Scalar = typename To::Precision;\n  From from;\n  To to;\n  int last;\n"
          "  PHYSGEN_FUNCTION void operator()(index_t i) const { to[i].a() = Scalar(from[i < last ? i + 1 : i].a()); }\n};\n"
          "template <class A, class B> Neighbours(A, B, int) -> Neighbours<A, B>;"),
    Block("oneviewtwice", "on.run(N, Shift{IN.const_view(), MID.view(), 1});\non.run(N, Combine{MID.const_view(), MID.const_view(), OUT.view()});",
          joined=True),
    Block("inplace", "on.run(N, Shift{IN.const_view(), MID.view(), 1});\non.run(N, Shift{MID.view(), MID.view(), 1});\n"
          "on.run(N, Shift{MID.view(), OUT.view(), 2});", joined=True),
    # How steps stand in the program.
    Block("ranagain", TWO + "\n" + TWO),
    Block("returnsearly", "const auto steps = [&] {\non.run(N, Shift{IN.const_view(), MID.view(), 1});\nif (pick > 1) return;\n"
          "on.run(N, Shift{MID.view(), OUT.view(), 2});\n};\nsteps();"),
    Block("ternary", "on.run(N, Shift{IN.const_view(), MID.view(), 1});\npick > 1 ? on.run(N, Shift{MID.view(), OUT.view(), 2}) : on.run(N, Shift{MID.view(), OUT.view(), 3});"),
    Block("hostbranch", "on.run(N, Shift{IN.const_view(), MID.view(), 1});\nif (pick > 1) {\non.run(N, Shift{MID.view(), OUT.view(), 2});\n}"),
    Block("unbraced", "on.run(N, Shift{IN.const_view(), MID.view(), 1});\nif (pick > 1) on.run(N, Shift{MID.view(), OUT.view(), 2});\n"
          "on.run(N, Combine{MID.view(), IN.const_view(), ACC.view()});"),
    Block("whilecounting", "int left = 3;\nwhile (const int k = left--) {\n" + "on.run(N, Shift{IN.const_view(), MID.view(), float(k)});\n"
          "on.run(N, Shift{MID.view(), OUT.view(), 2});\n}", joined=True),
    Block("fallsthrough", "switch (int(pick)) {\ncase 2: on.run(N, Shift{IN.const_view(), MID.view(), 1}); [[fallthrough]];\n"
          "default: on.run(N, Shift{MID.view(), OUT.view(), 2});\n}"),
    Block("carried", "for (int k = 0; k < 3; ++k) {\non.run(N, Shift{MID.view(), OUT.view(), 1});\non.run(N, Shift{IN.const_view(), MID.view(), float(k)});\n}"),
    # Effects that were seen.
    between("assignment", S + " Assigned a{&s, 1};", "const float z = (a = 2.0F).v;",
            "struct Assigned { float* p; float v; Assigned& operator=(float x) { *p = 7; v = x; return *this; } };"),
    between("valueor", S + " const std::optional<float> none;", "const float z = none.value_or(Valued{&s});",
            "struct Valued { float* p; operator float() const { *p = 7; return 2; } };"),
    between("applied", S, "const float z = std::apply([&](float x) { s = 7; return x; }, std::tuple(2.0F));"),
    between("lambdapointer", S + " const auto tick = [&] { s = 7; return 2.0F; }; const auto* const q = &tick;", "const float z = (*q)();"),
    between("lambdaofreference", S + " const auto tick = [&r = s] { r = 7; return 2.0F; };", "const float z = tick();"),
    Block("comparatorstores", "float z0 = 0; const auto less = [&](float a, float b) { ACC.view()[index_t{0}].a() = 7.0F; return a < b; };\n"
          + BOTH + "const float z = std::max(1.0F, 2.0F, less);\n" + LAST + "\n(void)z0;"),
]
