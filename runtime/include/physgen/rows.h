// Rows: a list of entries, of any length, for each object of a set: the tets of a node, the neighbours of a particle,
// contacts. Kernels hold them; row_arrays.h makes and changes them.
#pragma once
#pragma push_macro("I")  // of <complex.h>
#undef I

#include <physgen/arrays/view.h>
#include <physgen/detail/row_visit.h>
#include <physgen/kernels/lanes.h>

#include <utility>

namespace physgen {

/// A trivially copyable value, as views are. Row i has the entries begin .. end-1 of its range: objects of a generated
/// type of one's own, such as elasticity::Incidence, which say by an Index which object of another set (or of the same)
/// they mean. Ranges are objects like all others of their set, so the set is permuted, compacted and appended to
/// without moving an entry; that is why they have a begin and an end, and are not a list of offsets with one number
/// more.
///
/// All functions take the index that a kernel is called with: one object (a CUDA thread, too), a Pack or a PartialPack.
/// Entries of a row come in ascending order, so sums have the same bits under each of them.
/// @tparam RangesView a view of objects with two fields `Index begin, end`
/// @tparam EntriesView a view of any objects
template <class RangesView, class EntriesView>
class Rows {
 public:
  using Precision = typename EntriesView::Precision;

  /// @param targets how many objects there are for entries to name; see require()
  Rows(const RangesView& ranges, const EntriesView& entries, index_t targets)
      : ranges_(ranges), entries_(entries), targets_(targets) {}

  /// Rows.
  [[nodiscard]] PHYSGEN_FUNCTION index_t size() const { return ranges_.size(); }
  /// Objects that entries may name.
  [[nodiscard]] PHYSGEN_FUNCTION index_t targets() const { return targets_; }
  [[nodiscard]] PHYSGEN_FUNCTION const RangesView& ranges() const { return ranges_; }
  [[nodiscard]] PHYSGEN_FUNCTION const EntriesView& entries() const { return entries_; }

  /// For kernels to say which rows they want, before they run: two lists may have the same types, but seldom the same
  /// sizes.
  /// @param of names the rows in the message, such as "GatherForces: node_tets"
  /// @throw Error when there are not `size` rows, or their entries do not name objects of a set of `targets`
  void require(const char* of, index_t size, index_t targets) const {
    detail::require_rows(of, ranges_.size(), targets_, size, targets);
  }

  /// The number of entries of row(s) i.
  template <class I>
  [[nodiscard]] PHYSGEN_FUNCTION lanes_t<std::int32_t, I> size(const I& i) const {
    const auto range = ranges_[i];
    const lanes_t<std::int32_t, I> begin = range.begin(), end = range.end();
    return end - begin;
  }

  /// Calls body(entry, active) for each entry of row(s) i: for one object as often as its row has entries; for a pack
  /// as often as the longest row of its objects has. `entry` is the reference that a read-only view[k] gives, and
  /// `active` says which lanes it belongs to: `true`, or a mask of lanes_t<T, I>. A lane that is not active, since its
  /// row has ended, is shown an entry of an active one; one outside the kernel's range, that of the lane it repeats. So
  /// everything that is read exists, and what a body adds depends on `active`: `add(i, view[j].m(), select(active, m,
  /// S(0)))`. (Entries are written by kernels over entries, where no two lanes are one.)
  template <class T = Precision, class I, class Body>
  PHYSGEN_FUNCTION void for_each(const I& i, const Body& body) const {
    detail::RowVisit<detail::Bare<I>>::template each<T>(ranges_, detail::read_only(entries_), i, body);
  }

  /// For each entry of row(s) i, in their order: total = step(total, entry). Lanes whose rows have ended keep theirs.
  /// @param total a number or matrix of lanes_t<.., I>
  /// @param step returns a value of its type, and changes nothing
  template <class Value, class I, class Step>
  [[nodiscard]] PHYSGEN_FUNCTION auto fold(const I& i, const Value& total, const Step& step) const {
    using Sum = typename detail::Summand<Value>::type;
    using T = lane_of_t<typename detail::Summand<Value>::Scalar>;
    Sum sum = total;
    if constexpr (std::is_integral_v<detail::Bare<I>>) {
      for_each<T>(i, [&](const auto& entry, bool /*active*/) {
        sum = detail::next_total<Sum>(step(std::as_const(sum), entry));
      });
    } else {
      for_each<T>(i, [&](const auto& entry, const auto& active) {
        detail::RowVisit<detail::Bare<I>>::replace_where(active, sum,
                                                         detail::next_total<Sum>(step(std::as_const(sum), entry)));
      });
    }
    return detail::handed_out(sum);
  }

  /// total + term(entry) + term(next entry) + ..., added in this order; of a row without entries, `total`.
  /// `rows.sum(i, V(V::Zero()), [&](const auto& entry) -> V { return ...; })`
  template <class Value, class I, class Term>
  [[nodiscard]] PHYSGEN_FUNCTION auto sum(const I& i, const Value& total, const Term& term) const {
    using Sum = typename detail::Summand<Value>::type;
    return fold(i, total, [&](const Sum& sum, const auto& entry) -> Sum {
      using Added = std::remove_cvref_t<decltype(term(entry))>;
      static_assert(!std::is_arithmetic_v<Added> || std::is_same_v<Added, Sum>,
                    "rows.sum(): `total` has another type than the terms, which would be cut down to it: S(0)");
      static_assert(detail::returned_whole<Added>,
                    "rows.sum(): `term` returns an expression of Eigen that refers to matrices of its own, which are "
                    "gone by then; write its type, [&](const auto& entry) -> Vector { ... }");
      return sum + term(entry);
    });
  }

 private:
  RangesView ranges_;
  EntriesView entries_;
  index_t targets_;
};

}  // namespace physgen

#pragma pop_macro("I")
