// What happens before and after a step on several ranks, without the types of its kernel: which objects it is called
// for, which fields of ghosts are fetched before, and which are stale behind it.
#pragma once

#include <physgen/distributed/kernel_view.h>
#include <physgen/distributed/partition.h>

#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace physgen {

/// A field of a ghost is fresh where it has its owner's value. All ranks run the same steps, so each knows of every
/// field whether it is fresh, without asking.
class HaloSteps {
 public:
  /// A kernel of a step, and its views.
  struct Kernel {
    const std::string* name;
    std::vector<KernelView> views;
  };
  /// The objects of a step, by local numbers. No set: all ranks do the same.
  struct Objects {
    index_t begin, end;
    const LocalSet* set;
  };

  /// @param poisons whether fields of ghosts become signalling NaN (index fields: the lowest number) when they turn
  /// stale, so that a step that reads them, which nothing here knows of, does not go unseen
  HaloSteps(Partition& arrays, bool poisons) : arrays_(arrays), poisons_(poisons) {}

  /// Fetches what the step needs. With owned_only it is called for no ghost, as reductions are.
  /// @param size with which the program calls the kernel
  /// @throw Error when the kernel writes objects of others, when what it reads is not to be had, or when it is not
  /// known over which set it runs
  [[nodiscard]] Objects begin(std::span<const Kernel> kernels, index_t size, bool owned_only);
  /// Behind the step that was begun last.
  void end();
  /// Of code that is not called for the objects of a set: it may use what all ranks have alone.
  /// @throw Error when one of the views is of an array of which ranks have parts
  void require_replicated(std::span<const KernelView> views, const std::string& of) const;

  /// Kernels that the table lacks; all that they could read is fetched before each of their steps.
  [[nodiscard]] const std::set<std::string>& unknown() const { return unknown_; }

 private:
  struct Field {
    int array, field;
    auto operator<=>(const Field&) const = default;
  };
  struct Step {
    int set = -1;  ///< that it runs over
    std::set<Field> own, gathered, written;
    bool is_known = true;           ///< whether the table says all of what it reads of others
    bool reaches_on_ghosts = true;  ///< whether all that an object reads of others is here for ghosts, too
  };
  struct Use;
  using Key = std::vector<std::intptr_t>;

  [[nodiscard]] Step resolve(std::span<const Kernel> kernels, index_t size);
  [[nodiscard]] std::vector<Use> uses_of(std::span<const Kernel> kernels);
  [[nodiscard]] int set_of(const std::vector<Use>& uses, index_t size);
  [[nodiscard]] int set_of_all_ranks(const std::vector<Use>& uses, index_t size, const std::string& kernels);
  [[nodiscard]] static std::string names_of(const std::vector<Use>& uses);
  [[nodiscard]] bool may_write(const std::string& kernel, int view) const;
  /// Whether objects that an index field names are here, of all objects that the step may read it of.
  [[nodiscard]] bool reaches(const Step& step, const Partition::Naming& naming) const;
  void check_writes(const Use& use, int set) const;
  void add_gathered(Step& step, const Use& use) const;
  [[nodiscard]] bool is_fresh(const Field& field) const;
  void exchange(const std::vector<Field>& fields);
  void poison(const Field& field);
  [[nodiscard]] const DistributedSet& set_of_array(int array) const;
  [[nodiscard]] std::string name_of(const Field& field) const;

  Partition& arrays_;
  bool poisons_;
  std::map<Key, Step> steps_;
  const Step* current_ = nullptr;
  bool on_ghosts_ = false;
  std::set<std::string> unknown_;
};

}  // namespace physgen
