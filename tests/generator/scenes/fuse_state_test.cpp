// Steps that share what no array holds, or that stand where names and macros change their meaning, stay apart: one
// block of a scene for each way to hide it.
#include <gtest/gtest.h>

#include "fuse_case.h"
#include "fuse_kernels.h"

namespace physgen::test {
namespace {

/// A kernel that copies `a`, and does `text` beside it. @param member declared behind its views
std::string kernel(const std::string& name, const std::string& text, const std::string& member = {}) {
  return "template <class From, class To>\nstruct " + name +
         " {\n  using Scalar = typename To::Precision;\n  From from;\n  To to;\n" + member +
         "  template <class I>\n  PHYSGEN_FUNCTION void operator()(I i) const {\n"
         "    using S = physgen::lanes_t<Scalar, I>;\n    const S a = from[i].a();\n" +
         text + "  }\n};\nSTEP(" + name + ")\n";
}

const std::string store = "    to[i].a() = a;\n";

std::string kernels() {
  return particles_kernels + R"(#include <physgen/fuse.h>
#include <array>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <tuple>
#include <utility>
inline float memory = 0;
inline float* const shared = &memory;
struct State { static inline float kept = 0; };
struct Holder { float* to; };
struct Box { mutable float number = 0; };
template <class A, class B> struct Both { A a; B b; };
struct AtItsBegin { float n; AtItsBegin() : n(++last) {} };
struct AtItsEnd { ~AtItsEnd() { ++last; } };
struct HasOne { AtItsEnd one; };
struct Counts { void operator()(int n) const { last += float(n); } };
struct Adds { float operator()(float x) const { return x + 1; } };
inline void count(int n) { last += float(n); }
constexpr float twice(float x) { float y = x; y += x; return y; }
constexpr float counted(float x) { if (x < 0) return x; return ++last; }
template <class I> void begin_again(I* /*i*/) {}
template <int W> void begin_again(physgen::Pack<W>* i) { i->begin = 0; }
template <class V> constexpr float cleared(const V& view) { view[0].a() = 0.0F; return 1; }
)" + kernel("CopyHarmless", "    to[i].a() = a + S(std::invoke(Adds(), twice(scale)));\n", "  float scale = 2;\n") +
         kernel("CopyByMember", store + "    state.kept = 1;\n", "  State state = {};\n") +
         kernel("CopyByPointer", store + "    *shared = 1;\n") +
         kernel("CopyByHolder", store + "    *holder->to = 1;\n", "  const Holder* holder = nullptr;\n") +
         kernel("CopyByBox", store + "    box->number = 1;\n", "  Box own = {};\n  const Box* box = nullptr;\n") +
         kernel("CopyByConst", store + "    *const_cast<float*>(number) = 1;\n", "  const float* number = nullptr;\n") +
         kernel("CopyByConstructor", store + "    (void)AtItsBegin();\n") +
         kernel("CopyByDestructor", store + "    const HasOne has;\n") +
         kernel("CopyInvoking", store + "    std::invoke(Counts(), 1);\n") +
         kernel("CopyApplying", store + "    std::apply(count, std::tuple(1));\n") +
         kernel("CopyRandom", "    to[i].a() = a + S(Scalar(std::rand()));\n") +
         kernel("CopyElsewhere", store + " # ifdef __CUDA_ARCH__\n    ++last;\n # endif\n") +
         kernel("CopyAddressed",
                "    auto own = i;\n    begin_again(std::addressof(own));\n    to[i].a() = a + from[own].a();\n") +
         kernel("CopyZeroed", "    auto own = i;\n    std::memset(&own, 0, 8);\n    to[i].a() = a + from[own].a();\n") +
         kernel("CopyCast",
                "    const auto first = std::bit_cast<I>(std::array<char, sizeof(I)>{});\n"
                "    to[i].a() = a + from[first].a();\n") +
         kernel("CopyUnevaluated", "    (void)__builtin_constant_p((to[i].a() = a, 1));\n");
}

/// A step of this kernel, and one that reads what it stores.
Block block(const std::string& name, const std::string& kernel, const std::string& between = {}) {
  return {name, "on.run(n, " + kernel + "{in, M});\n    " + between + "on.run(n, Shift{1, M, OUT});", "\"a\""};
}

const std::vector<Block> blocks_with_state = {
    block("harmless", "CopyHarmless"),
    {"twice", "on.run(n, Copy{in, M});\n    on.run(n, Shift{twice(2), M, OUT});", "\"a\""},
    block("member", "CopyByMember"),
    block("sharedpointer", "CopyByPointer"),
    block("holder", "CopyByHolder"),
    block("box", "CopyByBox"),
    block("constant", "CopyByConst"),
    block("constructor", "CopyByConstructor"),
    block("destructor", "CopyByDestructor"),
    block("invoking", "CopyInvoking"),
    block("applying", "CopyApplying"),
    block("random", "CopyRandom"),
    block("elsewhere", "CopyElsewhere"),
    block("unevaluated", "CopyUnevaluated"),
    block("addressed", "CopyAddressed"),
    block("zeroed", "CopyZeroed"),
    block("cast", "CopyCast"),
    {"byhand", "on.run(n, physgen::fuse(physgen::locals(), CopyCounting{in, M}));\n    on.run(n, Shift{1, M, OUT});",
     "\"a\""},
    {"counted", "on.run(n, Copy{in, M});\n    on.run(n, Shift{counted(2), M, OUT});", "\"a\""},
    block("cleared", "Copy", "const float s = cleared(body.further.view());\n    "),
    block("binding", "Copy", "const auto [in, two] = Both{body.further.const_view(), 2};\n    "),
    block("enumerator", "Copy", "enum { in, out };\n    "),
    block("directive", "Copy", "using namespace m;\n    "),
    {"reduced",
     "on.run(n, Copy{in, M});\n    on.reduce(n, Value{M}, physgen::Sum{}, Keep{body.sum.view()});\n"
     "    on.run(n, Shift{1, M, OUT});",
     "\"a\""},
    {"macro", "on.run(n, Copy{SOURCE, M});\n    on.run(n, Shift{1, M, OUT});", "\"a\""},
};

TEST_F(Command, keeps_steps_apart_that_share_what_no_array_holds_or_whose_words_would_mean_something_else) {
  folder.write("particles.h", particles_schema);
  folder.write("kernels.h", kernels());
  folder.write("scenes/groups.h", scene_of(blocks_with_state, "#define SOURCE in\n"));
  ASSERT_EQ(run("generate particles.h -o generated").status, 0);
  const auto outcome = run("scene scenes/groups.h -o out -- -I. -Igenerated " PHYSGEN_FLAGS);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto needs = nlohmann::json::parse(text_of(folder / "out/groups.need.json"));
  auto why = apart_of(needs, blocks_with_state, folder / "").why;
  std::vector<std::string> locals;
  for (const auto& group : needs.at("groups"))
    for (const auto& local : group.at("locals")) locals.push_back(local.at("array"));
  EXPECT_EQ(locals, std::vector<std::string>{"body.m_harmless"}) << needs.at("groups");
  for (const auto& [name, reason] : std::map<std::string, std::string>{
           {"member", "CopyByMember: it uses the variable 'state.kept' at kernels.h:"},
           {"sharedpointer", "CopyByPointer: it holds '*shared' at kernels.h:"},
           {"twice", "Shift: it is given 'twice(2)' at scenes/groups.h:"},
           {"holder", "CopyByHolder: its holder is neither a number nor a view of the scene's arrays, at kernels.h:"},
           {"box", "CopyByBox: its box is neither a number nor a view of the scene's arrays, at kernels.h:"},
           {"constant", "CopyByConst: its number is neither a number nor a view of the scene's arrays, at kernels.h:"},
           {"constructor", "CopyByConstructor: it uses the variable 'last' at kernels.h:"},
           {"destructor", "CopyByDestructor: it runs a destructor at kernels.h:"},
           {"invoking", "CopyInvoking: it uses the variable 'last' at kernels.h:"},
           {"applying", "CopyApplying: it holds 'count' at kernels.h:"},
           {"random", "CopyRandom: it calls what is not known, 'std::rand()' at kernels.h:"},
           {"elsewhere", "CopyElsewhere: it holds a directive of the preprocessor at kernels.h:"},
           {"unevaluated", "CopyUnevaluated: it holds '__builtin_constant_p((to[i].a() = a, 1))' at kernels.h:"},
           {"addressed", "CopyAddressed: it asks what its index is at kernels.h:"},
           {"zeroed", "CopyZeroed: it asks what its index is at kernels.h:"},
           {"cast", "CopyCast: it asks what its index is at kernels.h:"},
           {"byhand", "it uses the variable 'last' at kernels.h:"},
           {"counted", "Shift: it is given 'counted(2)' at scenes/groups.h:"},
           {"cleared", "the declaration of s by 'cleared(body.further.view())' at scenes/groups.h:"},
           {"binding", "a declaration of something other than a value, 'const auto [in, two]"},
           {"enumerator", "a declaration of something other than a value, 'enum { in, out };' at scenes/groups.h:"},
           {"directive", "a declaration of something other than a value, 'using namespace m;' at scenes/groups.h:"},
           {"macro", "Copy: it is given the macro 'SOURCE' at scenes/groups.h:"}})
    EXPECT_NE(why[name].find(reason), std::string::npos) << name << ": " << why[name];
}

}  // namespace
}  // namespace physgen::test
