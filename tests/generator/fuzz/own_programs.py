"""More programs that must not be joined, or must be: each block has one way to be something else before its steps than between them."""
from attack_programs import FIRST, LAST, PLAIN, S, TICK, VALUES, asks, between, kernel
from scene_programs import Block

TWO = "on.run(N, Shift{IN.const_view(), MID.view(), 1});\non.run(N, Shift{MID.view(), OUT.view(), 2});"


def counts(name, declared, count):
    return Block(name, f"{declared}\non.run(N, Both{{IN.const_view(), ACC.view(), MID.view()}});\non.run({count}, Shift{{MID.view(), OUT.view(), 2}});")


def picked(name, head, body):
    """A kernel that stores always in float, and in double as the program is told."""
    text = kernel(name.capitalize(), body, head, "float pick;")
    text = text[:text.rindex("template <class... V>")] + f"template <class A, class B>\n{name.capitalize()}(A, B, float) -> {name.capitalize()}<A, B>;\n"
    return Block(name, f"on.run(N, {name.capitalize()}{{IN.const_view(), MID.view(), pick}});\non.run(N, Shift{{MID.view(), OUT.view(), 1}});", text)


def in_double(name, head, body):
    """A kernel that reads objects other than its own in double alone."""
    text = kernel(name.capitalize(), body, head, "Y y;").replace("template <class From, class To>", "template <class From, class To, class Y>")
    return Block(name, "on.run(N, Both{IN.const_view(), ACC.view(), MID.view()});\n"
                 f"on.run(N, {name.capitalize()}{{MID.view(), OUT.view(), ACC.view()}});", text)


STATEMENTS = [
    between("assigns", S, "s = 3;\nconst float z = 1;"),
    between("increments", S, "++s;\nconst float z = 1;"),
    between("incrementsindeclaration", S, "const float z = s++;"),
    between("assignsindeclaration", S, "const float z = s = 4;"),
    between("compound", S, "s *= 3;\nconst float z = s;"),
    between("comma", S, "const float z = (s = 3, 1.0F);"),
    between("bypointer", S + " float* const p = &s;", "*p = 3;\nconst float z = 1;"),
    between("pointerindeclaration", S + " float* const p = &s;", "const float z = *p = 3;"),
    between("byreference", S + " float& r = s;", "r = 3;\nconst float z = 1;"),
    between("swaps", S + " float t = 4;", "std::swap(s, t);\nconst float z = t;"),
    between("exchanges", S, "const float z = std::exchange(s, 4.0F);"),
    between("function", S, "const float z = function_of(s);", "inline float function_of(float& x) { x = 4; return 1; }"),
    between("byfunctionpointer", S + " float (*const f)(float&) = pointed_at;", "const float z = f(s);",
            "inline float pointed_at(float& x) { x = 4; return 1; }"),
    between("functor", S + " const Functor f{&s};", "const float z = f();", "struct Functor { float* p; float operator()() const { *p = 4; return 1; } };"),
    between("converts", S + " const Converts c{&s};", "const float z = c;", "struct Converts { float* p; operator float() const { *p = 4; return 1; } };"),
    between("adds", S + " const Adds c{&s};", "const float z = c + 1;", "struct Adds { float* p; float operator+(int) const { *p = 4; return 1; } };"),
    between("subscripts", S + " const Subscripts c{&s};", "const float z = c[1];",
            "struct Subscripts { float* p; float operator[](int) const { *p = 4; return 1; } };"),
    between("makes", S, "const Makes m(s);\nconst float z = 1;", "struct Makes { Makes(float& x) { x = 4; } };"),
    between("literalword", S, "const float z = 1.0_ticks;",
            "inline float literal_memory = 0;\ninline float operator\"\"_ticks(long double) { return ++literal_memory; }"),
    between("initialiser", S, "const Initialised i{};\nconst float z = i.v;",
            "inline float initial_memory = 0;\nstruct Initialised { float v = ++initial_memory; };"),
    between("immediately", S, "const float z = [&] { s = 4; return 1.0F; }();"),
    between("bynew", S, "const std::unique_ptr<float> made(new float(s = 4));\nconst float z = *made;"),
    between("tries", TICK, "try { throw tick(); } catch (float) {}\nconst float z = 1;"),
    between("branches", S, "if (s > 0) s = 4;\nconst float z = 1;"),
    between("loops", S, "for (int k = 0; k < 3; ++k) s += 1;\nconst float z = 1;"),
    between("whiles", S, "while (s < 5) s += 1;\nconst float z = 1;"),
    between("switches", S, "switch (int(s)) { case 1: s = 4; }\nconst float z = 1;"),
    between("nests", S, "{ s = 4; }\nconst float z = 1;"),
    between("chooses", TICK, "const float z = s > 0 ? tick() : 2;"),
    between("ands", TICK, "const bool y = s > 0 && tick() > 0;\nconst float z = y;"),
    between("binds", TICK, "const auto [y, z] = std::pair(tick(), 2.0F);"),
    between("statics", TICK, "static const float kept = tick();\nconst float z = 1;"),
    between("volatiles", "volatile float s = 1;", "s = s + 1;\nconst float z = s;"),
    between("atomics", "std::atomic<float> s = 1;", "const float z = s.exchange(4);"),
    between("cleansup", S, "{ [[gnu::cleanup(clean_up)]] const float q = 1; (void)q; }\nconst float z = clean_memory;",
            "inline float clean_memory = 0;\ninline void clean_up(const float*) { clean_memory += 1; }"),
    between("memoised", S + " const auto next = [t = 1.0F]() mutable { return t += 1; }; auto own = next;", "const float z = own();"),
    between("optional", S + " std::optional<float> o(2.0F);", "const float z = o.emplace(s = 4);"),
    Block("hostwrites", "on.run(N, Both{IN.const_view(), ACC.view(), MID.view()});\nACC.view()[index_t{0}].a() = 7;\nconst float z = 1;\n" + LAST),
    Block("hostreads", "on.run(N, Both{IN.const_view(), ACC.view(), MID.view()});\nconst float z = ACC.view()[index_t{0}].a();\n" + LAST),
    Block("hostgets", "on.run(N, Both{IN.const_view(), ACC.view(), MID.view()});\nconst float z = float(ACC.view().get(index_t{0}).a);\n" + LAST),
    Block("shadows", "const float s = 1;\n{\n" + FIRST + "const float s = 4;\nconst float z = s;\n" + LAST + "\n}"),
    Block("renames", "using Word = Choice;\n{\non.run(N, Shift{IN.const_view(), MID.view(), Word().by});\nstruct Word { float by = 4; };\n"
          "const float z = 1;\n" + LAST + "\n}"),
    Block("defines", S + "\n" + FIRST + "/* a */ #define s 4.0F\nconst float z = 1;\n" + LAST + "\n#undef s"),
    Block("digraph", S + "\n" + FIRST + "%:define s 4.0F\nconst float z = 1;\n" + LAST + "\n#undef s"),
    Block("twospellings", "{\non.run(N, Shift{IN.const_view(), MID.view(), \\u00e9});\nconst float z = 9, \u00e9 = 9;\n" + LAST + "\n}",
          "inline constexpr float \u00e9 = 2;"),
    Block("macroinatype", "on.run(N, Numbered{IN.const_view(), MID.view(), Number<NUMBERED>{}});\nconstexpr int numbered = 9;\nconst float z = numbered;\n" + LAST,
          "#define NUMBERED numbered\ninline constexpr int numbered = 2;\ntemplate <int k>\nstruct Number { static constexpr int value = k; };\n"
          + kernel("Numbered", "const S x = from[i].a();\n    to[i].a() = x * S(Scalar(V::value));", tail="V v;")
          .replace("template <class From, class To>", "template <class From, class To, class V>")),
    Block("otherobject", "float s = 1; const auto tick = [&] { return s += 1; };\non.run(N, Shift{IN.const_view(), MID.view(), s});\n"
          "on.run((tick(), N), Shift{MID.view(), OUT.view(), 1});"),
    Block("otherexecutor", S + "\n(s += 1, on).run(N, Shift{IN.const_view(), MID.view(), s});\n(s += 1, on).run(N, Shift{MID.view(), OUT.view(), s});"),
    Block("othergroup", S + "\non.run((s += 1, body).in.size(), Shift{IN.const_view(), MID.view(), s});\n"
          "on.run((s += 1, body).in.size(), Shift{MID.view(), OUT.view(), s});"),
    Block("kernelmakes", S + "\n" + FIRST + "on.run(N, Ticked{MID.view(), OUT.view()});",
          "inline float ticked = 0;\n" + kernel("Ticked", "to[i].a() = S(from[i].a()) + S(Scalar(by));", tail="float by = ++ticked;")),
    Block("byparentheses", S + "\non.run(N, Shift(IN.const_view(), MID.view(), s++));\non.run(N, Shift(MID.view(), OUT.view(), s));"),
    Block("bylambda", S + "\nconst auto mid = MID.view();\nconst auto in = IN.const_view();\n"
          "on.run(N, over<typename Body::Real>([in, mid, by = s++](auto i) {\n"
          "  using S = lanes_t<typename Body::Real, decltype(i)>;\n  mid[i].a() = S(in[i].a()) + S(typename Body::Real(by));\n}));\non.run(N, Shift{mid, OUT.view(), s});"),
]

COUNTS = [
    counts("countbyint", "const int k = int(N) / 2;", "k"),
    counts("countbyuint16", "const std::uint16_t k = N * 123;", "k"),
    counts("countless", "", "N - 5"),
    counts("countstatic", "static const index_t k = pick > 1 ? N : N / 2;", "k"),
    counts("countchanges", "index_t k = N; k = 9;", "k"),
    counts("countcalled", "const auto k = [&] { return N / 3; };", "k()"),
    counts("countoffew", "const index_t k = body.few.size();", "k"),
    counts("countliteral", "", "11"),
]

KERNELS = [
    asks("alignofindex", "if constexpr (alignof(I) == 4) " + PLAIN + "\n    else to[i].a() = S(from[i].a()) * S(Scalar(int(sizeof(i)) + 1));"),
    asks("copiedindex", "const auto j = i;\n    to[i].a() = S(from[i].a()) * S(Scalar(int(sizeof(j)) + 1));"),
    asks("helperofindex", "to[i].a() = S(from[i].a()) * S(Scalar(sized(i)));", "template <class J> constexpr int sized(J) { return int(sizeof(J)) + 1; }\n"),
    asks("classofindex", "to[i].a() = S(from[i].a()) * S(Scalar(Sized<I>::value));", "template <class J> struct Sized { static constexpr int value = int(sizeof(J)) + 1; };\n"),
    asks("defaultofindex", "to[i].a() = S(from[i].a()) * S(Scalar(by_default(i)));", "template <class J, int n = int(sizeof(J)) + 1> constexpr int by_default(const J&) { return n; }\n"),
    asks("constrained", "to[i].a() = S(from[i].a()) * S(Scalar(constrained(i)));",
         "template <class J> constexpr int constrained(const J&) { return 2; }\n"
         "template <class J> requires(sizeof(J) > 8) constexpr int constrained(const J&) { return 3; }\n"),
    asks("lambdaofindex", "to[i].a() = S(from[i].a()) * S(Scalar([](auto j) { return int(sizeof(j)) + 1; }(i)));"),
    asks("libraryofindex", "to[i].a() = S(from[i].a()) * S(Scalar(int(std::tuple_size_v<decltype(std::tuple(i))> + sizeof(std::tuple(i)))));"),
    picked("keptbyoverload", "template <class T, class A, class X> void keep_one(float, const T& to, A i, const X& x, float) { to[i].a() = x; }\n"
           "template <class T, class A, class X> void keep_one(double, const T& to, A i, const X& x, float p) { if (p > 1) to[i].a() = x; }\n",
           "keep_one(Scalar(), to, i, S(from[i].a()), pick);"),
    picked("keptbyreturn", "", "if constexpr (sizeof(Scalar) == 8) {\n      if (pick < 2) return;\n    }\n    " + PLAIN),
    in_double("othersindouble", "", "if constexpr (sizeof(Scalar) == 8) to[i].a() = S(Scalar(y[index_t{500}].a()));\n"
              "    else to[i].a() = S(from[i].a());"),
    in_double("othersbyoverload", "template <class Y> float other_of(float, const Y&) { return 1; }\n"
              "template <class Y> double other_of(double, const Y& y) { return y[index_t{500}].a(); }\n",
              "to[i].a() = S(from[i].a()) + S(other_of(Scalar(), y));"),
    Block("countsmine", "on.run(N, Countsmine{IN.const_view(), MID.view()});\non.run(N, Shift{MID.view(), OUT.view(), 1});",
          kernel("Countsmine", PLAIN + "\n    mine_count += 1;")),
    Block("holdspointer", "float s = 1;\non.run(N, Holdspointer{IN.const_view(), MID.view(), &s});\non.run(N, Shift{MID.view(), OUT.view(), 1});",
          kernel("Holdspointer", "to[i].a() = S(from[i].a()) + S(Scalar(*p));", tail="const float* p;")
          .replace("template <class... V>\nHoldspointer(V...) -> Holdspointer<V...>;",
                   "template <class A, class B>\nHoldspointer(A, B, const float*) -> Holdspointer<A, B>;")),
]

JOINED = [
    Block("plain", TWO, joined=True),
    between("constant", S, "const float z = s * 2 + 1;", joined=True),
    between("view", "const float s = 1;", "const auto out = OUT.view();\nconst float z = -s;", joined=True),
    between("sizes", "const float s = 1;", "const auto m = IN.size();\nconst float z = float(m);", joined=True),
    between("parameters", "const float s = pick;", "const float z = choice.by + s;", joined=True),
    between("capturedconstant", "const float s = 1; const auto f = [&] { return s; };", "const float z = s > 0 ? 2.0F : 3.0F;", joined=True),
    between("constexprs", "constexpr float s = 1;", "constexpr float z = s + 1;", joined=True),
    between("countedby", S + " const index_t k = N;", "const float z = 2;", joined=True),
    Block("inloop", "for (int k = 0; k < 2; ++k) {\n  const float s = float(k);\n" + FIRST + "const float z = s + float(k);\n" + LAST + "\n}", joined=True),
    Block("changedbefore", "float s = 1;\ns += 2;\n" + FIRST + "on.run(N, Shift{MID.view(), OUT.view(), s + 1});\ns = 9;", joined=True),
    Block("inlambda", "const float s = 1;\nconst auto twice = [&] {\n" + FIRST + "const float z = 2;\n" + LAST + "\n};\ntwice();\ntwice();", joined=True),
    Block("three", "on.run(N, Both{IN.const_view(), ACC.view(), MID.view()});\non.run(N, Shift{MID.view(), MORE.view(), 2});\n"
          "on.run(N, Combine{MORE.view(), ACC.view(), OUT.view()});", joined=True),
]

# In a scene of its own, since nothing of a program is joined whose text depends on the line that it stands on.
OF_LINES = [Block("ofline", TWO + "\non.run(N, Shift{IN.const_view(), ACC.view(), float(__LINE__)});")]

OWN = STATEMENTS + COUNTS + KERNELS + JOINED
