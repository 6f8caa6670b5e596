// What a scene's program reads before any of its steps has written it: small programs that need no header.
#include <gtest/gtest.h>

#include "small.h"
#include "usage/analyse.h"

namespace physgen::usage {
namespace {

/// "a Advance 2:41" of what a program of this body reads too early.
std::string too_early(const std::string& body, const std::string& before = "") {
  const std::string kernels =
      "struct Clear { V<A> v; void operator()(int) const { v.put(0); } };\n"
      "struct Advance { V<A> v; void operator()(int) const { v.put(v.get() + 1); } };\n";
  const std::string program =
      "namespace physgen_probe_unit {\nstruct Probed;\ntemplate <class T> void instantiate(V<A> a, V<B> b) {\n" + body +
      "\n}\ntemplate void instantiate<Probed>(V<A>, V<B>);\n}\n";
  Diagnostics diagnostics;
  const auto usage = analyse("small.cpp", test::small_probes + kernels + before + program, {}, Side::host, diagnostics);
  EXPECT_TRUE(usage) << diagnostics.text;
  std::string result;
  if (usage)
    for (const EarlyRead& early : usage->early_reads)
      result += (result.empty() ? "" : "; ") + early.array + ' ' + early.step.kernel + ' ' +
                std::to_string(early.place.line) + ':' + std::to_string(early.place.column);
  return result;
}

/// A kernel of this body.
std::string kernel_of(const std::string& body) {
  return "struct K { V<A> a; void operator()(int i) const { " + body + " } };\n";
}

TEST(EarlyReads, are_those_of_a_step_that_reads_what_it_alone_writes) {
  EXPECT_EQ(too_early("run(Advance{a});"), "a Advance 2:63");
  EXPECT_EQ(too_early("run(K{a});", kernel_of("for (; i < 3; ++i) a.put(a.get());")), "a K 3:78");
}

TEST(EarlyReads, follow_the_order_in_which_steps_are_called) {
  EXPECT_EQ(too_early("for (int s = 0; s < 2; run(Advance{a}), ++s) run(Clear{a});"), "");
  EXPECT_EQ(too_early("run(Clear{a}); run(Advance{a});"), "");
  EXPECT_EQ(too_early("run(Advance{a}); run(Clear{a});"), "a Advance 2:63");
  EXPECT_EQ(too_early("advance(cleared(a));",
                      "inline void advance(V<A> v) { run(Advance{v}); }\n"
                      "inline V<A> cleared(V<A> v) { run(Clear{v}); return v; }\n"),
            "");
  EXPECT_EQ(too_early("auto later = [=] { run(Advance{a}); }; run(Clear{a}); later();"), "");
  EXPECT_EQ(too_early("auto now = [=] { run(Advance{a}); }; now(); run(Clear{a});"), "a Advance 2:63");
}

TEST(EarlyReads, are_none_where_the_step_writes_first) {
  EXPECT_EQ(too_early("run(K{a});", kernel_of("a.put(1); a.put(a.get());")), "");
}

TEST(EarlyReads, are_none_where_a_condition_may_leave_them_out) {
  EXPECT_EQ(too_early("run(K{a});", kernel_of("a.put(i == 0 ? 0 : a.get());")), "");
  EXPECT_EQ(too_early("run(K{a});", kernel_of("float x = 0; if (i > 0) x = a.get(); a.put(x);")), "");
  EXPECT_EQ(too_early("run(K{a});", kernel_of("a.put(i > 0 && a.get() > 0);")), "");
  EXPECT_EQ(too_early("run(K{a});", kernel_of("if constexpr (sizeof(i) > 0) a.put(a.get());")), "a K 3:88");
  EXPECT_EQ(too_early("if (b.memory) run(Advance{a}); else run(Clear{a});"), "");
}

TEST(EarlyReads, are_none_where_a_function_is_called_by_whoever_has_its_address) {
  EXPECT_EQ(too_early("void (*f)(V<A>) = advance; run(Clear{a}); f(a);",
                      "inline void advance(V<A> v) { run(Advance{v}); }\n"),
            "");
}

}  // namespace
}  // namespace physgen::usage
