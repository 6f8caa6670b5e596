// See command.h.
#include "command.h"

#include <physgen/version.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <ostream>
#include <set>
#include <stdexcept>
#include <system_error>

#include "emit/emitter.h"
#include "exit_status.h"
#include "files.h"
#include "frontend/frontend.h"
#include "layout_boxes.h"
#include "layout_request.h"
#include "model/json.h"
#include "model/model.h"
#include "model/text.h"
#include "precompile_command.h"
#include "scene_command.h"
#include "scenes/report.h"
#include "usage_command.h"

namespace physgen::command {
namespace {

struct Arguments {
  std::vector<std::string> schemas;
  std::string output_dir;
  std::string depfile;
  std::string stamp;
  std::string emitter{emit::emitters().front().name};
  frontend::ParseOptions options;
  std::optional<std::string> layout_of_all;  // of every object, in place of the schema's
  LayoutRequest layout;
  SceneRequest scene;
  UsageRequest usage;
  PrecompileRequest precompile;
  std::string drawing;  // file of the JSON; empty: standard output
  bool json = false, svg = false, verbose = false, python = false;
};

struct Streams {
  std::ostream& out;
  std::ostream& err;
};

struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Parsed {
  std::vector<model::Schema> schemas;
  std::vector<std::string> dependencies;  // of all of them, each once
};

/// Parses all schemas, so that all their errors are seen at once; none: there are errors.
std::optional<Parsed> parse_all(const Arguments& arguments, std::ostream& err) {
  for (const std::string& path : arguments.schemas) require_readable(path);
  Parsed parsed;
  bool good = true;
  frontend::ParseOptions options = arguments.options;
  options.objections = emit::emitter(arguments.python ? "python" : arguments.emitter).objections;
  for (const std::string& path : arguments.schemas) {
    auto result = frontend::parse(path, options);
    err << result.diagnostics;
    if (result.schema) parsed.schemas.push_back(std::move(*result.schema));
    good = good && result.schema;
    for (std::string& file : result.dependencies)
      if (std::find(parsed.dependencies.begin(), parsed.dependencies.end(), file) == parsed.dependencies.end())
        parsed.dependencies.push_back(std::move(file));
  }
  if (!good) return std::nullopt;
  return parsed;
}

/// @throws UsageError if two schemas would write one header
void require_different_headers(const Arguments& arguments) {
  std::map<std::string, std::string> written;
  for (const std::string& path : arguments.schemas) {
    const std::string header = emit::file_of(emit::emitter(arguments.emitter), path);
    const auto [first, is_new] = written.emplace(header, path);
    if (!is_new && first->second == path) throw UsageError("'" + path + "' is given twice");
    if (!is_new)
      throw UsageError("'" + first->second + "' and '" + path + "' would both write '" + header +
                       "'; rename one, or generate them into different folders");
  }
}

/// Gives every object of a schema one layout in both spaces. @throws LayoutError
void set_layouts(model::Schema& schema, const std::string& word) {
  for (model::Object& object : schema.objects) {
    object.host_layout = read_layout(word, model::Space::host);
    object.cuda_layout = read_layout(word, model::Space::cuda);
  }
}

int generate(const Arguments& arguments, const Streams& streams) {
  if (arguments.output_dir.empty()) throw UsageError("the folder given with -o is empty; write -o . for this folder");
  const Stamp stamp{arguments.stamp};
  std::vector<const emit::Emitter*> chosen{&emit::emitter(arguments.emitter)};
  if (arguments.python) chosen.push_back(&emit::emitter("python"));
  require_different_headers(arguments);
  if (arguments.layout_of_all) (void)read_layout(*arguments.layout_of_all, model::Space::host);
  auto parsed = parse_all(arguments, streams.err);
  if (!parsed) return errors;
  if (arguments.layout_of_all)
    for (model::Schema& schema : parsed->schemas) set_layouts(schema, *arguments.layout_of_all);
  std::vector<File> files;
  for (const model::Schema& schema : parsed->schemas)
    for (const emit::Emitter* one : chosen)
      files.push_back({arguments.output_dir + "/" + emit::file_of(*one, schema.file), one->emit(schema)});
  if (!arguments.depfile.empty()) files.push_back({arguments.depfile, depfile(arguments.stamp, parsed->dependencies)});
  const auto changed = write_outputs(files, parsed->dependencies, stamp);
  if (arguments.verbose)
    for (std::size_t i = 0; i < files.size(); ++i)
      streams.out << (changed[i] ? "written   " : "unchanged ") << files[i].path << '\n';
  return done;
}

int check(const Arguments& arguments, const Streams& streams) {
  const auto parsed = parse_all(arguments, streams.err);
  if (!parsed) return errors;
  for (const model::Schema& schema : parsed->schemas) {
    std::size_t fields = 0;
    for (const model::Object& object : schema.objects) fields += object.fields.size();
    streams.out << schema.file << ": " << schema.objects.size() << " objects, " << fields << " fields\n";
  }
  return done;
}

int print_model(const Arguments& arguments, const Streams& streams) {
  const auto parsed = parse_all(arguments, streams.err);
  if (!parsed) return errors;
  streams.out << model::to_json(parsed->schemas.front());
  return done;
}

int print_layout(const Arguments& arguments, const Streams& streams) {
  if (arguments.svg)
    throw UsageError(
        "physgen cannot draw SVG; write '--json -o x.json' in place of --svg, and draw x.json with "
        "'tools/report/layout_picture.py x.json -o x.svg' of physgen's sources");
  if (!arguments.drawing.empty() && !arguments.json) throw UsageError("-o is the file of the JSON; add --json");
  const auto parsed = parse_all(arguments, streams.err);
  if (!parsed) return errors;
  const auto maps = layout_maps(parsed->schemas.front(), arguments.layout);
  const std::string drawing = arguments.json ? layout_json(maps) : layout_text(maps);
  if (arguments.drawing.empty())
    streams.out << drawing;
  else
    write_outputs({{arguments.drawing, drawing}}, parsed->dependencies, {});
  return done;
}

CLI::App* add_command(CLI::App& app, const char* name, const char* what, Arguments& arguments) {
  auto* command = app.add_subcommand(name, what);
  command
      ->add_option("-I,--include", arguments.options.include_dirs, "Folder in which #include looks for other schemas")
      ->allow_extra_args(false)
      ->type_name("DIR");
  return command;
}

/// "Kind of output: cpp (accessor classes in C++ and CUDA; the default)"
std::string emitter_choices() {
  std::vector<std::string> choices;
  for (const emit::Emitter& one : emit::emitters())
    choices.push_back(std::string(one.name) + " (" + std::string(one.what) +
                      (choices.empty() ? "; the default)" : ")"));
  return "Kind of output: " + model::joined(choices, " or ");
}

void describe_layout(CLI::App& app, Arguments& arguments) {
  auto* layout =
      add_command(app, "layout", "Draw where arrays place every element, and what a warp touches", arguments);
  LayoutRequest& request = arguments.layout;
  layout->add_option("SCHEMA", arguments.schemas, "Schema header")->required()->expected(1);
  layout->add_option("--object", request.objects, "Object to draw; may be repeated; without: all of the schema")
      ->allow_extra_args(false)
      ->type_name("NAME");
  layout->add_option("--space", request.space, space_choices() + " (default)")->type_name("SPACE");
  layout->add_option("--real", request.real, "Precision where the schema says Scalar: float (default) or double")
      ->type_name("TYPE");
  layout
      ->add_option("--layout", request.layout,
                   layout_choices() + "; aosoa: " + standard_layouts() +
                       "; all: every layout, to compare; without: what the schema says, else " + standard_layouts())
      ->type_name("LAYOUT");
  layout->add_flag("--json", arguments.json, "Write JSON instead of text; tools/report/layout_picture.py draws it");
  layout->add_option("-o,--output", arguments.drawing, "File of the JSON; without: standard output")->type_name("FILE");
  layout->add_flag("--svg", arguments.svg)->group("");  // not in the help: refused with what to write instead
}

void describe(CLI::App& app, Arguments& arguments) {
  app.set_version_flag("--version", "physgen " PHYSGEN_VERSION);
  app.require_subcommand(1);
  app.footer(
      "'physgen SCHEMA... -o DIR' is short for 'physgen generate SCHEMA... -o DIR'.\n"
      "Exit status: 0: done; 1: a schema, scene or program has errors and nothing was written, or a --check failed;\n"
      "2: the use is wrong, or a file cannot be read or written.");
  auto* generate =
      add_command(app, "generate", "Write the accessor classes of schemas: x.h gives DIR/x.physgen.h", arguments);
  generate->add_option("SCHEMA", arguments.schemas, "Schema headers")->required();
  generate
      ->add_option("-o,--output", arguments.output_dir, "Folder of the generated headers; made if it does not exist")
      ->required()
      ->type_name("DIR");
  generate
      ->add_option("--layout", arguments.layout_of_all,
                   "Layout of every object in both spaces, in place of what the schema says; an array whose program "
                   "names a layout keeps it: " +
                       layout_choices_of_a_space() + " (" + standard_layouts() + ")")
      ->type_name("LAYOUT");
  auto* emitter = generate->add_option("--emitter", arguments.emitter, emitter_choices())->type_name("NAME");
  generate
      ->add_flag("--python", arguments.python,
                 "Write the source of a Python module as well: x.h gives DIR/x.python.cpp")
      ->excludes(emitter);
  describe_stamp(*generate, arguments.stamp, arguments.depfile);
  generate->add_flag("--verbose", arguments.verbose, "Say which files were written and which were unchanged");
  auto* check = add_command(app, "check", "Report the errors of schemas, write nothing", arguments);
  check->add_option("SCHEMA", arguments.schemas, "Schema headers")->required();
  auto* model = add_command(app, "model", "Print what physgen reads from a schema, as JSON", arguments);
  model->add_option("SCHEMA", arguments.schemas, "Schema header")->required()->expected(1);
  describe_layout(app, arguments);
  describe_scene(app, arguments.scene);
  describe_usage(app, arguments.usage);
  describe_precompile(app, arguments.precompile);
}

const std::set<std::string> commands = {"generate", "check",      "model", "layout", "scene",
                                        "usage",    "precompile", "-h",    "--help", "--version"};
const std::set<std::string> commands_with_flags = {"scene", "usage", "precompile"};  // of a compiler, behind "--"

/// @throws UsageError if the first argument is neither an option nor a file: a command that is not there
void require_command_or_schema(const std::string& first) {
  std::error_code ignored;
  if (first.starts_with('-') || std::filesystem::exists(first, ignored)) return;
  throw UsageError(
      "there is no command or schema '" + first +
      "'; commands are generate, check, model, layout, scene, usage and precompile, and a schema is a file");
}

}  // namespace

int run(std::vector<std::string> arguments, std::ostream& out, std::ostream& err) {
  Arguments values;
  CLI::App app("physgen writes classes for arrays of physics objects from schemas, and of the fields that scenes need.",
               "physgen");
  describe(app, values);
  if (!arguments.empty() && commands_with_flags.contains(arguments.front())) {
    const auto flags = std::find(arguments.begin(), arguments.end(), "--");
    if (flags != arguments.end()) values.scene.flags.assign(flags + 1, arguments.end());
    values.usage.flags = values.precompile.flags = values.scene.flags;
    arguments.erase(flags, arguments.end());
  }
  const Streams streams{out, err};
  try {
    if (!arguments.empty() && !commands.contains(arguments.front())) {
      require_command_or_schema(arguments.front());
      arguments.insert(arguments.begin(), "generate");
    }
    std::reverse(arguments.begin(), arguments.end());  // as CLI11 wants them
    app.parse(std::move(arguments));
    if (app.got_subcommand("generate")) return generate(values, streams);
    if (app.got_subcommand("check")) return check(values, streams);
    if (app.got_subcommand("scene")) return scene(values.scene, out, err);
    if (app.got_subcommand("usage")) return usage(values.usage, out, err);
    if (app.got_subcommand("precompile")) return precompile(values.precompile, err);
    if (app.got_subcommand("layout")) return print_layout(values, streams);
    return print_model(values, streams);
  } catch (const CLI::ParseError& error) {
    return app.exit(error, out, err) == 0 ? done : wrong_use;
  } catch (const FileError& error) {
    err << "physgen: error: " << error.what() << '\n';
  } catch (const UsageError& error) {
    err << "physgen: error: " << error.what() << '\n';
  } catch (const scenes::UnknownName& error) {
    err << "physgen: error: " << error.what() << '\n';
  } catch (const LayoutError& error) {
    err << "physgen: error: " << error.what() << '\n';
  } catch (const emit::UnknownEmitter& error) {
    err << "physgen: error: " << error.what() << '\n';
  }
  return wrong_use;
}

}  // namespace physgen::command
