// Analyses of small programs: what the walk from a step must not lose, and what it cannot follow. They need no
// header.
#include <gtest/gtest.h>

#include <set>

#include "small.h"
#include "usage/analyse.h"

namespace physgen::usage {
namespace {

struct Analysis {
  std::optional<Usage> usage;
  Diagnostics diagnostics;
};

Analysis analysed(const std::string& text) {
  Analysis analysis;
  analysis.usage = analyse("small.cpp", test::small_probes + text, {}, Side::host, analysis.diagnostics);
  return analysis;
}

/// "a RW 3:14" of the only step.
std::string of_step(const std::string& text) {
  const Analysis analysis = analysed(text);
  EXPECT_TRUE(analysis.usage) << analysis.diagnostics.text;
  if (!analysis.usage) return "errors";
  EXPECT_TRUE(analysis.usage->unattributed.empty()) << text;
  EXPECT_EQ(analysis.usage->steps.size(), 1U) << text;
  std::string result;
  for (const StepUse& step : analysis.usage->steps)
    for (const FieldUse& use : step.fields) {
      result += (result.empty() ? "" : "; ") + use.array + ' ' + (use.read ? "R" : "") + (use.written ? "W" : "");
      for (const Place& place : use.places)
        result += ' ' + std::to_string(place.line) + ':' + std::to_string(place.column);
    }
  return result;
}

/// A kernel whose call operator has this body, given to run().
std::string kernel(const std::string& body) {
  return "struct K { V<A> a; V<B> b; void operator()(int i) const {\n" + body + "\n} };\nvoid f() { run(K{}); }\n";
}

TEST(UsageWalk, finds_reads_and_writes_with_line_and_column) {
  EXPECT_EQ(of_step(kernel("float x = a.get(); b.put(x);")), "a R 2:13; b W 2:22");
  EXPECT_EQ(of_step(kernel("a.put(a.get());")), "a RW 2:3 2:9");
  EXPECT_EQ(of_step(kernel("i ? a.get() : b.get();")), "a R 2:7; b R 2:17");
  EXPECT_EQ(of_step("#define READ(v) v.get()\n" + kernel("READ(a);")), "a R 3:1");
}

TEST(UsageWalk, goes_wherever_code_may_be_called_from) {
  const auto written = [](const std::string& before, const std::string& body) {
    return of_step(before + kernel(body));
  };
  EXPECT_EQ(written("", "auto f = [this] { a.put(1); }; f();"), "a W 2:21");
  EXPECT_EQ(written("", "auto f = [](auto v) { v.put(1); }; f(a);"), "a W 2:25");
  EXPECT_EQ(written("", "void (*f)(V<A>) = [](V<A> v) { v.put(1); }; f(a);"), "a W 2:34");
  EXPECT_EQ(written("template <class T> void g(T v) { v.put(1); }\n", "void (*f)(V<A>) = g; f(a);"), "a W 1:36");
  EXPECT_EQ(written("inline float g(float x = V<A>().get()) { return x; }\n", "g();"), "a R 1:33");
  EXPECT_EQ(written("struct S { V<A> v; float x = v.get(); };\n", "S s{a};"), "a R 1:32");
  EXPECT_EQ(written("struct S { float x; S(V<A> v) : x(v.get()) {} };\n", "S s(a);"), "a R 1:37");
  EXPECT_EQ(written("struct S { V<A> v; ~S() { v.put(1); } };\n", "S s{a};"), "a W 1:29");
  EXPECT_EQ(written("struct S { V<A> v; ~S() { v.put(1); } };\nstruct T { S s; };\n", "T t{{a}};"), "a W 1:29");
  EXPECT_EQ(written("struct S { V<A> v; operator float() const { return v.get(); } };\n", "float x = S{a};"),
            "a R 1:54");
  EXPECT_EQ(
      written("inline float g(V<A> v) { return v.get(); }\nfloat (*const table[])(V<A>) = {g};\n", "table[i](a);"),
      "a R 1:35");
  EXPECT_EQ(written("struct S { virtual void g(V<A>) = 0; };\n"
                    "struct T : S { void g(V<A> v) override { v.put(1); } };\n",
                    "T t; S& s = t; s.g(a);"),
            "a W 2:44");
}

TEST(UsageWalk, leaves_out_what_is_not_evaluated_or_not_instantiated) {
  EXPECT_EQ(of_step(kernel("static_assert(sizeof(a.get()) == 4); decltype(a.get()) x = 0; (void)noexcept(a.put(x));")),
            "");
  EXPECT_EQ(of_step(kernel("struct Local { void never(V<A> v) {} }; (void)i; b.put(1);")), "b W 2:52");
  EXPECT_EQ(of_step("template <class T> void never(T v) { v.put(1); }\n" + kernel("b.put(1);")), "b W 3:3");
  EXPECT_EQ(of_step("template <bool yes, class T> void g(T v) { if constexpr (yes) v.put(1); }\n" +
                    kernel("g<false>(a); b.put(1);")),
            "b W 3:16");
}

TEST(UsageWalk, gives_code_of_no_step_to_none) {
  const Analysis analysis = analysed(kernel("a.get();") + "void g(V<B> v) { v.put(1); }\n");
  ASSERT_TRUE(analysis.usage) << analysis.diagnostics.text;
  ASSERT_EQ(analysis.usage->unattributed.size(), 1U);
  EXPECT_EQ(analysis.usage->unattributed[0].array, "b");
  EXPECT_TRUE(analysis.usage->unattributed[0].written);
}

std::string unknown_of(const std::string& body) {
  const Analysis analysis = analysed(kernel(body));
  EXPECT_TRUE(analysis.usage) << analysis.diagnostics.text;
  std::string result;
  if (analysis.usage)
    for (const UnknownUse& use : analysis.usage->unknown)
      result += (result.empty() ? "" : "; ") + use.array + ' ' + use.what + ' ' + std::to_string(use.place.line) + ':' +
                std::to_string(use.place.column);
  return result;
}

TEST(UsageWalk, reports_what_it_cannot_follow) {
  const std::string cast = " a cast to other types, as of memcpy or reinterpret_cast ";
  EXPECT_EQ(unknown_of("a.data()[0] = 1;"), "a data() 2:3");
  EXPECT_EQ(unknown_of("auto* p = reinterpret_cast<const char*>(&b);"), "b" + cast + "2:11");
  EXPECT_EQ(unknown_of("char c[8]; __builtin_memcpy(c, &a, 8);"), "a" + cast + "2:32");
  EXPECT_EQ(unknown_of("auto n = sizeof(b);"), "b sizeof 2:10");
  EXPECT_EQ(unknown_of("auto n = sizeof(V<A>);"), "a sizeof 2:10");
  EXPECT_EQ(unknown_of("union { V<A> v; int n; }; n = i;"), "a a union 2:27");
  EXPECT_EQ(unknown_of("a.put(b.get()); auto n = sizeof(i); auto* p = reinterpret_cast<char*>(&i);"), "");
}

TEST(UsageErrors, are_those_of_clang_and_nothing_is_found) {
  const Analysis analysis = analysed("void f() { run(Nothing{}) }\nvoid g( {\n");
  EXPECT_FALSE(analysis.usage);
  EXPECT_NE(analysis.diagnostics.text.find(":1:16: error: use of undeclared identifier 'Nothing'"), std::string::npos)
      << analysis.diagnostics.text;
  EXPECT_NE(analysis.diagnostics.text.find("void g( {"), std::string::npos) << "the line with a caret";
}

TEST(UsageErrors, of_kernels_over_concrete_views_say_what_to_write) {
  const auto expect = [](const std::string& view, const std::string& error) {
    const Analysis analysis = analysed(view +
                                       "\nstruct K { Plain a; void operator()(int) const {} };\n"
                                       "void f(V<A> v) { run(K{v}); }\n");
    EXPECT_FALSE(analysis.usage);
    EXPECT_NE(analysis.diagnostics.text.find(":3:24: error: " + error), std::string::npos) << analysis.diagnostics.text;
    EXPECT_NE(analysis.diagnostics.text.find("write it as a template over its views"), std::string::npos)
        << analysis.diagnostics.text;
  };
  expect("using Plain = physgen::View<float>;", "no viable conversion");
  expect("struct Plain { Plain(); template <class Probe> Plain(const physgen::View<Probe>&) = delete; };",
         "conversion function");
  const Analysis other = analysed("struct K { int a; };\nK f(void* v) { return K{v}; }\n");
  EXPECT_FALSE(other.usage);
  EXPECT_EQ(other.diagnostics.text.find("template over its views"), std::string::npos) << other.diagnostics.text;
}

TEST(UsageErrors, of_the_flags_are_told) {
  Diagnostics diagnostics;
  EXPECT_FALSE(analyse("small.cpp", "", {"-std=c++1"}, Side::host, diagnostics));
  EXPECT_NE(diagnostics.text.find("invalid value 'c++1'"), std::string::npos) << diagnostics.text;
}

TEST(Usage, of_a_program_without_steps_is_empty) {
  const Analysis analysis = analysed("int f() { return 1; }\n");
  ASSERT_TRUE(analysis.usage) << analysis.diagnostics.text;
  EXPECT_EQ(*analysis.usage, Usage{});
  Diagnostics diagnostics;
  EXPECT_EQ(analyse("empty.cpp", "", {}, Side::host, diagnostics), Usage{});
}

}  // namespace
}  // namespace physgen::usage
