// The fields that a program's steps read and write, as plain comparable structs. analyse.h fills them; the table,
// the JSON and whoever prunes arrays read them. Nothing of Clang appears here.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace physgen::usage {

/// A place in a source file. The file is named as #include names it: "fem/kernels/compute_svd.h".
struct Place {
  std::string file;
  int line = 0, column = 0;
  auto operator<=>(const Place&) const = default;
};

/// The use of one field of one array.
struct FieldUse {
  std::string array;  ///< as the program names it: "svds"
  std::string field;  ///< "svd.U" of a nested object, "points.x" of a fixed array of them
  bool read = false, written = false;
  bool address_taken = false;  ///< by `&` of an element or an atomic operation
  // The objects that are meant. None: types do not tell, where a kernel takes single objects alone or makes an index.
  bool own = false;       ///< of those that the step is called for
  bool gathered = false;  ///< of others, which it finds by indices of its own making, or of a part: object_of_part()
  bool added = false;     ///< of others, by add()
  // Those of the set that it runs over, and others, of reads and of writes apart. None: as above.
  bool reads_own = false, reads_others = false, writes_own = false, writes_others = false;
  bool whole_object = false;                       ///< by a get() or put() of all fields, too, at `whole_places`
  std::vector<Place> places;                       ///< in the kernel's own source, in ascending order, each once
  std::vector<Place> read_places, written_places;  ///< those of them where it is read, and where it is written
  std::vector<Place> whole_places;                 ///< those of them where all fields are read or written at once
  bool operator==(const FieldUse&) const = default;
};

/// The views that a kernel holds, in the order of its members: Rows are two, their ranges and their entries, and
/// members that are structs count with their own.
struct KernelViews {
  std::vector<std::string> arrays;                        ///< of each view; empty: of no array with a name
  std::vector<std::pair<std::string, std::string>> rows;  ///< arrays of ranges, and of their entries
  bool operator==(const KernelViews&) const = default;
};

/// A kernel of a step: of a fused one there are several, of work of a program's own none.
struct KernelUse {
  std::string name;  ///< "physgen::fem::ComputeSvd"; empty: a lambda, or a kernel of the runtime's over one
  KernelViews views;
  std::vector<FieldUse> fields;  ///< by array and field, in ascending order; without those of what follows a reduction
  std::set<std::string> calculated = {};  ///< arrays of which it finds objects by numbers that it calculates
  bool operator==(const KernelUse&) const = default;
};

/// The uses that one step of a program makes of fields.
struct StepUse {
  std::string kernel;               ///< "physgen::fem::ComputeSvd", or "lambda in physgen::fem::multiply"
  Place place;                      ///< where the kernel is defined
  std::vector<std::string> arrays;  ///< that the kernel is given, in the order of its parameters
  bool root = false;               ///< what it reads is wanted whatever becomes of it: a predicate, a value of the host
  std::vector<FieldUse> fields;    ///< by array and field, in ascending order
  std::vector<KernelUse> kernels;  ///< that it consists of, in their order; files of usages do not have them
  bool operator==(const StepUse&) const = default;
};

/// A use of a probed array that types do not show: data(), memcpy, reinterpret_cast, sizeof.
struct UnknownUse {
  std::string array;
  std::string what;  ///< "data()"
  Place place;
  auto operator<=>(const UnknownUse&) const = default;
};

/// Two kernels of one fused kernel that may not be fused, because of this field.
struct Race {
  std::string array, field;
  std::string writer, other;  ///< the kernels
  Place writer_place, other_place;
  auto operator<=>(const Race&) const = default;
};

/// A place where the program's code is another over arrays with all fields, over probes, or over arrays that store
/// nothing: it depends on how fields are stored.
struct Dependence {
  Place place;
  std::string what;  ///< "1 or 0": what stands there over arrays with all fields, and over others
  auto operator<=>(const Dependence&) const = default;
};

/// A field that a program may read before any of its steps has written it, in the order in which it calls them.
struct EarlyRead {
  std::string array, field;
  StepUse step;               ///< without its fields; no kernel: code outside of steps
  Place place;                ///< in the step's own source
  bool whole_object = false;  ///< by a get() of all fields, which tells of none that it is needed
  bool operator==(const EarlyRead&) const = default;
};

struct Usage {
  std::vector<StepUse> steps;           ///< by kernel, arrays and place, in ascending order
  std::vector<FieldUse> unattributed;   ///< by no step that the analysis can name: these are wanted
  std::vector<UnknownUse> unknown;      ///< errors, but where the program declares the arrays' fields
  std::vector<Race> races;              ///< errors
  std::vector<Dependence> dependences;  ///< errors
  std::vector<EarlyRead> early_reads;   ///< of a scene's program: of each field the first by itself, and by a get()
  bool operator==(const Usage&) const = default;
};

/// A program and what was found in it.
struct Program {
  std::string name;  ///< of a scene, or of a file
  Usage usage;
  bool operator==(const Program&) const = default;
};

/// The union of the analyses of one program for two sides. A kernel on the same arrays is one step.
[[nodiscard]] Usage unite(const Usage& a, const Usage& b);

/// Every field that is used, over all steps: by array and field, in ascending order.
[[nodiscard]] std::vector<FieldUse> all_fields(const Usage& usage);

/// Puts everything in ascending order, equal steps and fields together.
void sort(Usage& usage);

/// Whether two kernels may use one field, one after the other for the same objects in one fused kernel: each its own
/// objects alone, or both to add, or none of them to write. Else other objects' threads come in between.
[[nodiscard]] bool may_be_fused(const FieldUse& one, const FieldUse& other);

/// Adds what `use` says to the uses of the same field, or as a new one.
void add(std::vector<FieldUse>& uses, const FieldUse& use);

/// "physgen::fem::ComputeSvd(gradients, svds)"; of many arrays the first.
[[nodiscard]] std::string name_of(const StepUse& step);

/// "compute_svd.h:42:9", or with all of the file's name
[[nodiscard]] std::string short_text(const Place& place);
[[nodiscard]] std::string text_of(const Place& place);

/// The message: what is wrong and what to write instead, without the first place and without a full stop.
[[nodiscard]] std::string text_of(const Race& race);
[[nodiscard]] std::string text_of(const Dependence& dependence);

}  // namespace physgen::usage
