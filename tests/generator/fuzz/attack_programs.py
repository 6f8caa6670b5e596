"""Programs between whose steps something happens, or whose kernels ask what they must not: each was joined once and gave other numbers."""
from scene_programs import Block

MINE = """#pragma once
inline float mine_count = 0;
struct Mine {
  float v;
  constexpr Mine(float& x) : v(1) { x = 7; }
};
namespace physgen {
constexpr float local(float& x) { x = 7; return 1; }
}
"""

FIRST = "on.run(N, Shift{IN.const_view(), MID.view(), s});\n"
LAST = "on.run(N, Shift{MID.view(), OUT.view(), z});"


def between(name, declared, statement, before="", joined=False):
    """A step that is given s, a statement that defines z, and a step that is given z."""
    return Block(name, f"{declared}\n{FIRST}{statement}\n{LAST}", before, joined)


def kernel(name, body, head="", tail=""):
    return f"""{head}template <class From, class To>
struct {name} {{
  using Scalar = typename To::Precision;
  From from;
  To to;
  {tail}
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {{
    using S = lanes_t<Scalar, I>;
    {body}
  }}
}};
template <class... V>
{name}(V...) -> {name}<V...>;
"""


def asks(name, body, head=""):
    """A kernel that asks something of its index, and a step behind it."""
    return Block(name, f"on.run(N, {name.capitalize()}{{IN.const_view(), MID.view()}});\non.run(N, Shift{{MID.view(), OUT.view(), 1}});",
                 kernel(name.capitalize(), body, head))


S = "float s = 1;"
TICK = "float s = 1; const std::function<float()> tick = [&] { s = 7; return 1.0F; };"
VALUES = TICK + " const std::vector<float> h{1, 2, 3};"
PLAIN = "to[i].a() = S(from[i].a()) + S(Scalar(1));"

REVIEWED = [
    Block("invoke", "float z0 = 0; const auto fix = [&] { ACC.view()[index_t{0}].a() = 7.0F; return 1.0F; };\n"
          "on.run(N, Both{IN.const_view(), ACC.view(), MID.view()});\nconst float z = std::invoke(fix);\n" + LAST),
    between("lamcap", S + " const auto advance = [&] { s = s + 0.5F; return s; };", "const float z = advance();"),
    between("lamfor", S + " const auto advance = [&] { for (int k = 0; k < 3; ++k) s += 0.5F; return s; };", "const float z = advance();"),
    between("clock", S + " const float dt = 0.1F; const auto advance = [&] { s += dt; return s; };", "const float z = advance();"),
    between("refmember", S, "const float z = refmember_fix(RefMember{s});",
            "struct RefMember { float& r; }; constexpr float refmember_fix(RefMember x) { x.r = 7; return 1; }"),
    between("maxcmp", S + " const auto less = [&](float a, float b) { s = 7; return a < b; };", "const float z = std::max(1.0F, 2.0F, less);"),
    Block("narrowsecond", "const std::uint8_t few = N;\non.run(N, Both{IN.const_view(), ACC.view(), MID.view()});\n"
          "on.run(few, Shift{MID.view(), OUT.view(), 2});"),
    Block("narrowfirst", "const std::uint8_t few = N;\non.run(few, Both{IN.const_view(), ACC.view(), MID.view()});\n"
          "on.run(N, Shift{MID.view(), OUT.view(), 2});"),
    Block("shortcount", "const short few = IN.size();\non.run(N, Both{IN.const_view(), ACC.view(), MID.view()});\n"
          "on.run(few, Shift{MID.view(), OUT.view(), 2});"),
    Block("boolcount", "const bool some = IN.size();\non.run(N, Shift{IN.const_view(), MID.view(), 1});\n"
          "on.run(some, Shift{MID.view(), OUT.view(), 2});"),
    between("virtual_", S, "const float z = virtual_read(VirtualOver{&s});",
            "struct VirtualBase { constexpr virtual float get() const { return 1; } };\n"
            "struct VirtualOver : VirtualBase { float* p; constexpr VirtualOver(float* to) : p(to) {}\n"
            "  constexpr float get() const override { *p = 7; return 1; } };\n"
            "constexpr float virtual_read(const VirtualBase& b) { return b.get(); }"),
    between("inherit", S, "const float z = InheritOver(&s).v;",
            "struct InheritBase { float v; constexpr InheritBase(float* p) : v(1) { *p = 7; } };\n"
            "struct InheritOver : InheritBase { using InheritBase::InheritBase; };"),
    between("aggtemp", S, "const float z = AggTemp{&s, 2}.v;", "struct AggTemp { float* p; float v; ~AggTemp() { *p = 7; } };"),
    between("stdfill", S + " std::vector<float> h(1);", "const float z = *std::fill_n(&s, 1, 7.0F) > 0 ? 1 : 2;"),
    between("accum", VALUES, "const float z = std::accumulate(h.begin(), h.end(), 0.0F, [&](float a, float b) { s = 7; return a + b; });"),
    Block("argorder", f"{TICK}\n{FIRST}on.run(N, Shift{{MID.view(), OUT.view(), tick()}});"),
    Block("argeffect", TICK + "\non.run(N, Shift{IN.const_view(), MID.view(), (s += 1, s)});\non.run(N, Shift{MID.view(), OUT.view(), tick() + s});"),
    Block("ptrstore", "float w[1] = {1}; const auto tick = [&] { w[0] = 7; return 1.0F; };\non.run(N, Shift{IN.const_view(), MID.view(), w[0]});\n"
          "const float z = tick();\n" + LAST),
    between("initcap", TICK, "const auto f = [t = tick()] { return t; };\nconst float z = 2;"),
    Block("initcapread", "on.run(N, Both{IN.const_view(), ACC.view(), MID.view()});\n"
          "const auto f = [t = float(ACC.view()[index_t{5}].a())] { return t; };\non.run(N, Shift{MID.view(), OUT.view(), f()});"),
    between("foreach", VALUES, "const float z = (std::for_each(h.begin(), h.end(), [&](float x) { s = x + 7; }), 1.0F);"),
    between("ranges", VALUES, "const float z = float(std::ranges::count_if(h, [&](float) { s = 7; return true; }));"),
    between("applyc", S + " const std::tuple<float> one(1);", "const float z = std::apply([&](float x) { s = 7; return x; }, one);"),
    between("visitx", S + " const std::variant<int, float> one(1.0F);", "const float z = std::visit([&](auto x) { s = 7; return float(x); }, one);"),
    between("spanfill", S + " const std::span<float> all(&s, 1);", "const float z = std::fill_n(all.begin(), 1, 7.0F) == all.end() ? 1 : 2;"),
    between("userdir", S, "const float z = Mine(s).v;"),
    between("userlocal", S, "const float z = physgen::local(s);"),
    Block("copyarray", "on.run(N, Both{IN.const_view(), ACC.view(), MID.view()});\nconst auto copy = ACC;\n"
          "on.run(N, Combine{MID.view(), copy.view(), OUT.view()});"),
    between("vla", TICK, "float buffer[int(tick())];\nconst float z = 1;"),
    asks("sizeofindex", "if constexpr (sizeof(I) == sizeof(index_t)) to[i].a() = S(from[i].a());\n    else if constexpr (sizeof(I) <= 8) "
         "to[i].a() = S(from[i].a()) * S(Scalar(2));\n    else to[i].a() = S(from[i].a()) * S(Scalar(3));"),
    Block("keptindouble", "on.run(N, Keptindouble{IN.const_view(), MID.view(), pick});\non.run(N, Shift{MID.view(), OUT.view(), 1});",
          kernel("Keptindouble", "if constexpr (sizeof(Scalar) == 8) {\n      if (pick > 1) to[i].a() = S(from[i].a());\n    } else {\n"
                 "      to[i].a() = S(from[i].a()) * S(Scalar(pick));\n    }", tail="float pick;")
          .replace("template <class... V>\nKeptindouble(V...) -> Keptindouble<V...>;",
                   "template <class A, class B>\nKeptindouble(A, B, float) -> Keptindouble<A, B>;")),
]
