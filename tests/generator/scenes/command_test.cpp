// `physgen scene` as a process: what it writes and leaves alone, what it says, and its exit status.
#include <gtest/gtest.h>

#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "command_case.h"

namespace physgen::test {
namespace {

namespace fs = std::filesystem;

const std::string schema = R"(#include <physgen/schema.h>
namespace m {
using namespace physgen::schema;
struct PHYSGEN_OBJECT() Particle { Scalar a, b, c; };
}
)";

/// A kernel that copies `fields` of particles.
std::string kernel(const std::vector<std::string>& fields) {
  std::string text = R"(#pragma once
#include <particles.physgen.h>
#include <physgen/kernel.h>
template <class From, class To>
struct CopyFields {
  using Scalar = typename To::Precision;
  From from;
  To to;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
)";
  for (const std::string& field : fields)
    text += "    to[i]." + field + "() = physgen::lanes_t<Scalar, I>(from[i]." + field + "());\n";
  return text + "  }\n};\ntemplate <class... V> CopyFields(V...) -> CopyFields<V...>;\n";
}

/// @param steps of the program
std::string scene_of(const std::string& steps) {
  return R"(#pragma once
#include <physgen/scene.h>
#include "kernel.h"
using namespace physgen::scene;
struct PHYSGEN_SCENE() particles {
  using Real = float;
  struct Body {
    PHYSGEN_ARRAY(per("particle"), input()) Array<m::ParticleObject, Real> first;
    PHYSGEN_ARRAY(per("particle")) Array<m::ParticleObject, Real> between;
    PHYSGEN_ARRAY(per("particle"), output("a")) Array<m::ParticleObject, Real> last;
  };
  template <class On, class Body> static void program(On& on, Body& body) {
)" + steps +
         "  }\n};\n";
}
const std::string two_steps =
    "    on.run(body.first.size(), CopyFields{body.first.view(), body.between.view()});\n"
    "    on.run(body.first.size(), CopyFields{body.between.view(), body.last.view()});\n";

const std::string flags = "-I. -Igenerated " PHYSGEN_FLAGS;

/// The runtime's headers are read once, as in builds; what is written without is compared in a test.
class SceneCommand : public Command {
 protected:
  static void SetUpTestSuite() {
    shared = std::make_unique<Folder>();
    const std::string line =
        "cd '" + (*shared / ".") + "' && '" PHYSGEN_COMMAND "' precompile -o headers.pch -- " + flags;
    ASSERT_EQ(std::system(line.c_str()), 0);
  }

  void SetUp() override {
    folder.write("particles.h", schema);
    folder.write("kernel.h", kernel({"a"}));
    folder.write("scenes/particles.h", scene_of(two_steps));
    const auto outcome = run("generate particles.h -o generated");
    ASSERT_EQ(outcome.status, 0) << outcome.err;
  }

  [[nodiscard]] std::string written(const std::string& name) const { return text_of(folder / ("out/" + name)); }

  Outcome scene(const std::string& arguments) const {
    return run("scene scenes/particles.h --precompiled '" + (*shared / "headers.pch") + "' " + arguments + " -- " +
               flags);
  }
  static inline std::unique_ptr<Folder> shared;
};

TEST_F(SceneCommand, writes_anew_only_what_a_changed_kernel_changes) {
  const std::string arguments = "-o out --no-fuse --stamp stamp --depfile depfile";
  for (const char* ending : {"halos", "distributed"}) folder.write("out/particles." + std::string(ending) + ".h", "");
  const auto first = scene(arguments);
  ASSERT_EQ(first.status, 0) << first.err;
  for (const char* ending : {"halos", "distributed"})
    EXPECT_FALSE(exists("out/particles." + std::string(ending) + ".h")) << "of when the scene stated names";
  const std::string header = written("particles.scene.h");
  EXPECT_NE(header.find("/// - b, c: nothing uses it\n"), std::string::npos) << header;
  EXPECT_NE(header.find("#include <particles.physgen.h>\n"), std::string::npos) << header;
  EXPECT_EQ(header.find("#include \"scenes/particles.h\""), std::string::npos) << "which may include this header";
  EXPECT_EQ(header.find("LocalArray"), std::string::npos) << "steps stay apart, so that what is between them is stored";
  EXPECT_NE(written("particles.program.h").find("using fused = ::particles;\n"), std::string::npos);
  EXPECT_NE(written("particles.need.txt").find("per particle: 12 of 36 bytes, 3 of 9 numbers\n"), std::string::npos);
  EXPECT_NE(written("particles.usage.json").find("\"kernel.h:11:11\""), std::string::npos)
      << written("particles.usage.json");
  const std::string depends = text_of(folder / "depfile");
  for (const char* name : {"/scenes/particles.h", "/kernel.h", "/particles.physgen.h", "/physgen/scene.h"})
    EXPECT_NE(depends.find(name), std::string::npos) << name << " in\n" << depends;

  const std::string digest = written("particles.digest");
  EXPECT_NE(digest.find("  field b float32 1 pruned"), std::string::npos) << digest;
  const auto long_ago = fs::last_write_time(folder / "out/particles.scene.h") - std::chrono::hours(1);
  fs::last_write_time(folder / "out/particles.scene.h", long_ago);
  folder.write("kernel.h", "// A comment.\n" + kernel({"a"}));
  ASSERT_EQ(scene(arguments).status, 0);
  EXPECT_EQ(fs::last_write_time(folder / "out/particles.scene.h"), long_ago);
  EXPECT_NE(written("particles.usage.json").find("\"kernel.h:12:11\""), std::string::npos) << "one line further down";
  EXPECT_EQ(written("particles.digest"), digest);

  folder.write("kernel.h", kernel({"a", "b"}));
  const auto third = scene(arguments);
  ASSERT_EQ(third.status, 0) << third.err;
  EXPECT_NE(written("particles.digest"), digest);
  EXPECT_NE(fs::last_write_time(folder / "out/particles.scene.h"), long_ago);
  EXPECT_NE(written("particles.need.txt").find("per particle: 20 of 36 bytes, 5 of 9 numbers\n"), std::string::npos)
      << written("particles.need.txt");
  EXPECT_NE(third.err.find("kernel.h:12:11: note: field b of body.last is pruned: CopyFields(body.between, body.last) "
                           "writes it, and nothing reads it\n"),
            std::string::npos)
      << third.err;
}

TEST_F(SceneCommand, writes_arrays_for_several_ranks_of_a_scene_that_says_what_its_fields_name) {
  folder.write("scenes/relax.h", text_of(PHYSGEN_TESTED_SCENES "/relax.h"));
  const auto outcome = run("scene scenes/relax.h -o out -- -I. -I" PHYSGEN_SCHEMAS_INCLUDE " " PHYSGEN_FLAGS);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(written("relax.distributed.h"), text_of(PHYSGEN_GOLDEN_DIR "/relax.distributed.h"));
  EXPECT_EQ(written("relax.need.txt").find("no header of arrays"), std::string::npos);
}

TEST_F(SceneCommand, writes_the_same_from_a_precompiled_header_and_refuses_one_that_does_not_fit) {
  const std::string own = " -- -I" + (folder / "own") + " " + flags;
  folder.write("own/physgen/probe.h", "#pragma once\n#include_next <physgen/probe.h>\n");  // as a header that changes
  const auto precompile = run("precompile -o build/x.pch --stamp stamp --depfile depfile" + own);
  ASSERT_EQ(precompile.status, 0) << precompile.err;
  EXPECT_NE(text_of(folder / "depfile").find("/physgen/probe.h"), std::string::npos) << text_of(folder / "depfile");
  ASSERT_EQ(run("scene scenes/particles.h -o out --stamp s --depfile one.d" + own).status, 0);
  const std::string fast = "scene scenes/particles.h -o fast --stamp s --depfile two.d --precompiled build/x.pch";
  const auto outcome = run(fast + own);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  ASSERT_EQ(files("fast"), files("out"));
  for (const std::string& name : files("out")) EXPECT_EQ(text_of(folder / ("fast/" + name)), written(name)) << name;
  const auto headers = [&](const std::string& name) {
    std::ifstream in(folder / name);
    std::set<std::string> words{std::istream_iterator<std::string>(in), {}};
    words.erase("\\");
    std::erase_if(words, [](const std::string& word) { return word.ends_with(".pch"); });
    return words;
  };
  EXPECT_EQ(headers("two.d"), headers("one.d"));

  folder.write("own/physgen/probe.h", "#pragma once\n#include_next <physgen/probe.h>\nstruct Another;\n");
  const auto changed = run(fast + own);
  EXPECT_EQ(changed.status, 1);
  EXPECT_NE(changed.err.find("own/physgen/probe.h' has been modified since the precompiled header"), std::string::npos)
      << changed.err;
  const auto another = run(fast + own + " -DNDEBUG=2");
  EXPECT_EQ(another.status, 1);
  EXPECT_NE(another.err.find("note: write it again with 'physgen precompile', with the same flags behind '--'"),
            std::string::npos)
      << another.err;
  const auto missing = run("scene scenes/particles.h --precompiled none.pch" + own);
  EXPECT_EQ(missing.status, 2);
  EXPECT_EQ(missing.err, "physgen: error: cannot read 'none.pch': No such file or directory\n");
  const auto over = run("precompile -o own/physgen/probe.h" + own);
  EXPECT_EQ(over.status, 2);
  EXPECT_EQ(over.err,
            "physgen: error: cannot write 'own/physgen/probe.h': it is there, and is no precompiled header; remove it, "
            "or name another file\n");
  folder.write("other.device", "of the user\n");
  const auto beside = run("precompile -o other --device" + own);
  EXPECT_EQ(beside.status, 2);
  EXPECT_EQ(
      beside.err,
      "physgen: error: cannot write 'other.device': it is there, and is no precompiled header; remove it, or name "
      "another file\n");
  EXPECT_EQ(text_of(folder / "other.device"), "of the user\n");
}

TEST_F(SceneCommand, writes_nothing_where_a_step_is_missing_or_in_vain) {
  folder.write("scenes/particles.h",
               scene_of("    on.run(body.first.size(), CopyFields{body.between.view(), body.last.view()});\n"));
  const auto missing = scene("-o out");
  EXPECT_EQ(missing.status, 1);
  EXPECT_NE(missing.err.find("kernel.h:11:53: error: field a of body.between is read by CopyFields(body.between, "
                             "body.last), and no step writes it; declare input(\"a\") where body.between is declared, "
                             "or run the step that computes it\n"),
            std::string::npos)
      << missing.err;
  folder.write("scenes/particles.h",
               scene_of("    on.run(body.first.size(), CopyFields{body.first.view(), body.last.view()});\n"
                        "    on.run(body.first.size(), CopyFields{body.first.view(), body.between.view()});\n"));
  const auto in_vain = scene("-o out");
  EXPECT_EQ(in_vain.status, 1);
  EXPECT_NE(in_vain.err.find("error: the step CopyFields(body.first, body.between) writes only body.between.a, which "
                             "nothing that is wanted depends on;"),
            std::string::npos)
      << in_vain.err;
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST_F(SceneCommand, refuses_a_race_in_a_fused_kernel_with_both_kernels_their_places_and_the_field) {
  folder.write("kernel.h", "#include <physgen/fuse.h>\n" + kernel({"a"}) + R"(
template <class From, class To>
struct CopyNext {
  using Scalar = typename To::Precision;
  From from;
  To to;
  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    to[i].a() = physgen::lanes_t<Scalar, I>(from[physgen::numbers(i) + 1].a());
  }
};
template <class... V> CopyNext(V...) -> CopyNext<V...>;
)");
  const auto fused_with = [](const std::string& second) {
    return scene_of(
        "    on.run(body.first.size(), physgen::fuse(physgen::locals(), CopyFields{body.first.view(), "
        "body.between.view()}, " +
        second + "{body.between.view(), body.last.view()}));\n");
  };
  folder.write("scenes/particles.h", fused_with("CopyFields"));
  const auto own = scene("-o out");
  EXPECT_EQ(own.status, 0) << own.err;
  fs::remove_all(folder / "out");
  folder.write("scenes/particles.h", fused_with("CopyNext"));
  const auto race = scene("-o out");
  EXPECT_EQ(race.status, 1);
  EXPECT_NE(race.err.find("kernel.h:12:11: error: CopyFields writes body.between.a, and CopyNext uses it at "
                          "kernel.h:24:75 in the same fused kernel, one of them at other objects than its own: what it "
                          "finds there depends on how threads run; take one of the two out of fuse(...)\n"),
            std::string::npos)
      << race.err;
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST_F(SceneCommand, notes_a_field_that_a_step_reads_before_any_step_has_written_it) {
  folder.write("scenes/particles.h",
               scene_of("    on.run(body.first.size(), CopyFields{body.last.view(), body.last.view()});\n"));
  const auto outcome = scene("");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const std::string note =
      "field a of body.last is read by CopyFields(body.last) before any step has written it; declare input(\"a\") "
      "where body.last is declared, or run a step before it that writes it\n";
  EXPECT_NE(outcome.err.find("kernel.h:11:"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find(": note: " + note), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.out.find(": " + note), std::string::npos) << outcome.out;
}

TEST_F(SceneCommand, says_how_many_bytes_the_compiler_gives_a_record_without_its_pruned_fields) {
  std::string padded = schema;
  padded.replace(padded.find("PHYSGEN_OBJECT()"), 16, "PHYSGEN_OBJECT(layout(host, aos_padded), layout(cuda, aos))");
  folder.write("particles.h", padded);
  ASSERT_EQ(run("generate particles.h -o generated").status, 0);
  const auto outcome = scene("--no-fuse");
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(
      outcome.out.find("  body.last     aos_padded (host)  16     16               padding takes what pruning saves\n"
                       "  body.last     aos (cuda)         4      12\n"),
      std::string::npos)
      << outcome.out;
}

TEST_F(SceneCommand, explains_fields_and_refuses_names_and_files_that_there_are_not) {
  const auto why = scene("--why between.a");
  EXPECT_EQ(why.status, 0) << why.err;
  EXPECT_EQ(
      why.out.substr(0, why.out.find('\n')),
      "body.between.a of m::Particle is local: CopyFields(body.first, body.between) and CopyFields(body.between, "
      "body.last) are one step, and nothing else uses it; written by CopyFields(body.first, body.between); read by "
      "CopyFields(body.between, body.last)");
  const auto unknown = scene("--why betwen.a");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_EQ(unknown.err,
            "physgen: error: in the scene particles there is no array or field 'betwen.a'; did you mean "
            "'between.a'?\n");
  const auto model = scene("--print-model");
  EXPECT_EQ(model.status, 0) << model.err;
  const auto last = nlohmann::json::parse(model.out).at("groups").at(0).at("arrays").at(2);
  EXPECT_EQ(last.at("object"), "m::Particle");
  EXPECT_EQ(last.at("per"), "particle");
  EXPECT_EQ(last.at("output"), nlohmann::json({"a"}));
  EXPECT_EQ(last.at("fields").at(1).at("bytes"), 4);
  EXPECT_EQ(run("scene absent.h").status, 2);
  EXPECT_EQ(run("check -- particles.h").status, 0) << "a schema, not flags";
}

}  // namespace
}  // namespace physgen::test
