// What happens before and after a step on several ranks, without the types of its kernel: which objects it is called
// for, which fields of ghosts are fetched before, and which are stale behind it.
#pragma once

#include <physgen/distributed/halo_exchange.h>
#include <physgen/distributed/kernel_view.h>
#include <physgen/distributed/partition.h>
#include <physgen/launch/reduce.h>

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace physgen {

/// A field of a ghost is fresh where it has its owner's value. All ranks run the same steps, so each knows of every
/// field for which needs (halo_needs.h) it is fresh, without asking.
class HaloSteps {
 public:
  /// A kernel of a step, and its views.
  struct Kernel {
    const std::string* name;
    std::vector<KernelView> views;
  };
  /// Half-open.
  struct Range {
    index_t begin, end;
  };
  /// The objects of a step, by local numbers. No set: of a set that all ranks have, or of none.
  struct Objects {
    index_t begin, end;
    const LocalSet* set;
    /// Parts of them that need nothing of what still crosses, ascending: the kernel is called for these, then comes
    /// arrive(), and then it is called for the others. None where nothing crosses any more.
    std::vector<Range> inner = {};
    /// Of a reduction: all objects that are here, where it is called for ghosts, too, whose terms are dropped, so that
    /// what it writes of them is fresh. Else none.
    Range also = {0, 0};
  };
  /// How a step is done.
  enum class Way {
    run,     ///< for ghosts, too, where these can be done
    reduce,  ///< with the terms of owned objects, by whole blocks
    at_once  ///< for owned objects, or for more, by code that is not split
  };

  /// @param poisons whether fields of ghosts become signalling NaN (index fields: the lowest number) when they turn
  /// stale, so that a step that reads them, which nothing here knows of, does not go unseen
  /// @param exchange by which fields cross; none: through the host's memory
  HaloSteps(Partition& arrays, bool poisons, std::unique_ptr<HaloExchange> exchange = nullptr);

  /// Fetches what the step needs. One step ends before the next one begins.
  /// @param size with which the program calls the kernel
  /// @throw Error when the kernel writes objects of others, when what it reads is not to be had, or when it is not
  /// known over which set it runs, or when it is begun inside of another step; when a step over a set that all ranks
  /// have, which reads parts of others, is reduced or done by code that is not split
  [[nodiscard]] Objects begin(std::span<const Kernel> kernels, index_t size, Way way);
  /// Waits for what begin() left crossing.
  void arrive() { exchange_->end(); }
  /// Behind the step that was begun last. Of a set that all ranks have, what each has computed is given to all.
  void end();
  /// The same for a part of a reduction: its objects are those of the whole. Fields cross before the first part alone,
  /// since ranks may have other numbers of parts, but where its kernel has a window: then all have as many, and steps
  /// over windows may run between them.
  /// @throw Error, too, when parts do not follow each other, or one is larger than the window
  [[nodiscard]] Objects begin_part(std::span<const Kernel> kernels, const PartOfReduction& part);
  void end_part(const PartOfReduction& part);
  /// Of code that is not called for the objects of a set: it may use what all ranks have alone.
  /// @throw Error when one of the views is of an array of which ranks have parts
  void require_replicated(std::span<const KernelView> views, const std::string& of) const;

  /// Kernels that the table lacks; all that they could read is fetched before each of their steps.
  [[nodiscard]] const std::set<std::string>& unknown() const { return unknown_; }

 private:
  using Field = HaloField;
  struct Needs {
    int of_owned = 0;   ///< where it is called for owned objects
    int of_ghosts = 0;  ///< and for ghosts, too
  };
  struct Step {
    int set = -1;              ///< that it runs over
    bool is_gathered = false;  ///< whether ranks compute parts of a set that all have, since it reads parts of others
    std::set<Field> own, written;
    std::map<Field, Needs> gathered;
    bool is_known = true;           ///< whether the table says all of what it reads of others
    bool reaches_on_ghosts = true;  ///< whether all that an object reads of others is here for ghosts, too
  };
  struct Use;
  using Key = std::vector<std::intptr_t>;

  [[nodiscard]] Step resolve(std::span<const Kernel> kernels, index_t size);
  [[nodiscard]] Objects begin_step(std::span<const Kernel> kernels, index_t size, Way way, bool is_of_window);
  /// The objects of the smallest window of which a kernel has a view; none: it has no view of one.
  [[nodiscard]] std::optional<index_t> window_of(std::span<const Kernel> kernels) const;
  [[nodiscard]] bool writes_window(const Step& step) const;
  /// @throw Error when a step that writes a window cannot be done for ghosts, or is run over more than the window
  void require_of_window(std::span<const Kernel> kernels, const Step& step, index_t size) const;
  [[nodiscard]] std::vector<Use> uses_of(std::span<const Kernel> kernels);
  [[nodiscard]] int set_of(const std::vector<Use>& uses, index_t size);
  /// The set of a step that is gathered. @pre it uses own objects of a set that all ranks have
  [[nodiscard]] int set_that_is_gathered(const std::vector<Use>& uses) const;
  [[noreturn]] void refuse_two_sets(const std::string& kernels, int one, int other) const;
  [[noreturn]] void refuse_unknown(const std::string& kernels, int set) const;
  /// Whether a field names objects of which ranks have parts, of a set that all have: see
  /// DistributedArray::names_parts.
  [[nodiscard]] bool names_parts(const Field& field) const;
  /// Whether it is a use of something that not every rank has of all objects.
  [[nodiscard]] bool needs_parts(const Use& use) const;
  [[nodiscard]] int set_of_all_ranks(const std::vector<Use>& uses, index_t size, bool has_parts);
  [[nodiscard]] static std::string names_of(const std::vector<Use>& uses);
  /// The set of the objects that a uniform array has one record of, or -1 of other arrays and sets.
  [[nodiscard]] int set_of_uniform(const Use& use) const;
  /// Of a step of what all ranks have. @throw Error when its size is none that all ranks have
  void require_size_of_all_ranks(std::span<const Kernel> kernels, index_t size, Way way, bool is_of_window) const;
  [[nodiscard]] bool may_write(const std::string& kernel, int view) const;
  /// Whether objects that an index field names are here, of all objects that the step may read it of.
  [[nodiscard]] bool reaches(const Step& step, const Partition::Naming& naming) const;
  void check_writes(const Use& use, int set) const;
  /// @param uses all of the step
  void add_gathered(Step& step, const Use& use, const std::vector<Use>& uses) const;
  /// The index fields that a row of a use means by a name. @param uses all of the step
  [[nodiscard]] std::vector<const Partition::Naming*> namings_of(const Use& use, std::string_view through,
                                                                 const std::vector<Use>& uses) const;
  void find_needs(Step& step, const std::vector<Use>& uses) const;
  [[nodiscard]] HaloNeedBits& fresh(const Field& field) const;
  [[nodiscard]] HaloNeedBits& also(const Field& field) const;
  /// Whether what a step writes of ghosts is right there, once what it reads has crossed, and is of use.
  [[nodiscard]] bool can_be_of_ghosts(const Step& step) const;
  /// What must cross before a step.
  [[nodiscard]] std::vector<HaloFetch> stale_of(const Step& step);
  void begin_exchange(const std::vector<HaloFetch>& fetches);
  /// Owned objects of a set that name no ghost of sets of which fields cross.
  [[nodiscard]] std::vector<Range> inner_of(const DistributedSet& over, Way way) const;
  [[nodiscard]] const DistributedSet& set_of_array(int array) const;
  [[nodiscard]] const std::string& array_name(const Use& use) const;
  [[nodiscard]] std::string name_of(const Field& field) const;

  Partition& arrays_;
  bool poisons_;
  std::map<Key, Step> steps_;
  const Step* current_ = nullptr;  ///< that was begun and is not ended
  std::string current_name_;
  bool on_ghosts_ = false;
  std::unique_ptr<HaloExchange> exchange_;
  std::uint64_t crossing_ = 0;  ///< bit s % 64 where fields of set s cross
  /// A reduction of which not all parts are done: `name` of its kernel, or null.
  struct OpenReduction {
    const std::string* name = nullptr;
    index_t next = 0, of = 0;
    Objects objects{0, 0, nullptr};
    const Step* step = nullptr;
    bool on_ghosts = false, is_of_window = false;
  } open_;
  std::set<std::string> unknown_;
};

}  // namespace physgen
