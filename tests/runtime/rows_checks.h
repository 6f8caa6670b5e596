// Rows held against vectors of vectors: what kernels make of them, and what changes of topology make of them. One
// source for host and CUDA; parallel_for is included by the files that instantiate it.
#pragma once

#include <physgen/math.h>
#include <physgen/row_arrays.h>

#include <limits>

#include "array_model.h"

namespace physgen::test {

/// @tparam kLanes as parallel_for takes it
template <class Real_, class Space_, class Layout, int kLanes_ = 0>
struct RowsCase {
  using Real = Real_;
  using Space = Space_;
  static constexpr int lanes = kLanes_;
  template <class Object>
  using Array = physgen::Array<Object, Real, Space, Layout>;
  using Rows = RowArrays<Array<elasticity::IncidenceRangeObject>, Array<elasticity::IncidenceObject>>;
  using Entry = typename Rows::Value;
};

template <class Entry>
using RowModel = std::vector<std::vector<Entry>>;

/// Rows of 0 to `longest` entries that name `targets` objects; `local` numbers the entries.
template <class Entry>
RowModel<Entry> random_rows(index_t n, int longest, index_t targets, std::mt19937& random) {
  RowModel<Entry> rows(static_cast<std::size_t>(n));
  std::int32_t number = 0;
  for (auto& row : rows) {
    const int length = std::uniform_int_distribution<int>(0, longest)(random);
    for (int k = 0; k < length; ++k) {
      row.push_back(
          {std::uniform_int_distribution<std::int32_t>(0, static_cast<std::int32_t>(targets) - 1)(random), number++});
    }
  }
  return rows;
}

template <class Rows>
auto objects_of_rows(const Rows& rows) {
  const RowArrays<elasticity::IncidenceRangeArray<float>, elasticity::IncidenceArray<float>> host(rows);
  RowModel<typename Rows::Value> model(static_cast<std::size_t>(host.size()));
  for (index_t i = 0; i < host.size(); ++i) {
    const auto range = host.ranges().view().get(i);
    for (index_t k = range.begin; k < range.end; ++k) {
      const auto entry = host.entries().view().get(k);
      model[static_cast<std::size_t>(i)].push_back({entry.element, entry.local});
    }
  }
  return model;
}

template <class Rows>
void expect_rows(const Rows& rows, const RowModel<typename Rows::Value>& expected) {
  const auto found = objects_of_rows(rows);
  ASSERT_EQ(found.size(), expected.size());
  std::size_t entries = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    entries += expected[i].size();
    ASSERT_EQ(found[i].size(), expected[i].size()) << "row " << i;
    for (std::size_t k = 0; k < expected[i].size(); ++k) {
      ASSERT_EQ(found[i][k].element, expected[i][k].element) << "entry " << k << " of row " << i;
      ASSERT_EQ(found[i][k].local, expected[i][k].local) << "entry " << k << " of row " << i;
    }
  }
  ASSERT_EQ(rows.entries().size(), static_cast<index_t>(entries)) << "no entry outlives its row";
  rows.check();
}

/// Puts what no kernel may see into the memory behind the last object.
template <class Array>
void plant_garbage(Array& array) {
  const UntypedArray untyped = array.untyped();
  for (index_t i = untyped.size; i < untyped.padded; ++i) {
    for (const FieldInfo& field : untyped.fields) {
      const int size = element_bytes(field.type);
      for (int k = 0; k < field.count; ++k) {
        std::byte* at =
            untyped.base + address_by_law(field.offset + k * size, i, untyped.pitch, untyped.record_bytes, size);
        const std::uint64_t bits = field.type == ElementType::int32     ? 0x7fffffff
                                   : field.type == ElementType::float64 ? 0x7ff4000000000000
                                                                        : 0x7fa00000;
        std::memcpy(at, &bits, static_cast<std::size_t>(size));
      }
    }
  }
}

/// Every function of Rows. Only adds and subtracts, so that no compiler fuses anything.
template <class Rows, class In, class Counts, class Sums, class Differences>
struct VisitRows {
  using Scalar = typename In::Precision;
  Rows rows;
  In in;                    ///< NodePosition of each target
  Counts counts;            ///< Incidence: the length of the row, and how many entries were counted
  Sums sums;                ///< NodeForce: of the targets' positions
  Differences differences;  ///< NodeDisplacement: an alternating sum, the sum of `local`, the largest position

  template <class I>
  PHYSGEN_FUNCTION void operator()(I i) const {
    using S = lanes_t<Scalar, I>;
    using N = lanes_t<std::int32_t, I>;
    using V = Eigen::Matrix<S, 3, 1>;
    using math::select;
    const auto position = [this](const auto& entry) -> V {
      const N target = entry.element();
      return in[target].x();
    };
    counts[i].element() = rows.size(i);
    counts[i].local() = rows.sum(i, N(0), [](const auto& /*entry*/) -> N { return N(1); });
    sums[i].f() = rows.sum(i, V(V::Constant(S(Scalar(0)))), position);
    V alternating = rows.fold(i, V(V::Constant(S(Scalar(1)))),
                              [&](const V& total, const auto& entry) -> V { return position(entry) - total; });
    S largest_x(Scalar(-1));
    rows.template for_each<Scalar>(i, [&](const auto& entry, const auto& active) {
      const S x = position(entry)[0];
      largest_x = select(active, select(x > largest_x, x, largest_x), largest_x);
    });
    alternating[2] = largest_x;
    differences[i].dx() = alternating;
  }
};
template <class... Views>
VisitRows(Views...) -> VisitRows<Views...>;

/// The arrays of VisitRows, their naive values, and the run of a part of them.
template <class Case>
class RowVisits {
  using Real = typename Case::Real;
  using Space = typename Case::Space;
  using Entry = typename Case::Entry;
  template <class Object>
  using Array = typename Case::template Array<Object>;
  template <class Object>
  using HostArray = physgen::Array<Object, Real, Host, Aos>;

 public:
  RowVisits(const RowModel<Entry>& rows, index_t targets, std::mt19937& random)
      : model_(rows),
        rows_(Case::Rows::from_lists({"element", targets}, rows)),
        positions_(targets),
        in_(targets),
        counts_(size()),
        sums_(size()),
        differences_(size()) {
    randomise(positions_, random);
    copy(in_, positions_);
    synchronize();
    if constexpr (host_accessible(Space::kind)) {
      plant_garbage(in_);
      plant_garbage(counts_);
      plant_garbage(sums_);
      plant_garbage(differences_);
      ranges_ = rows_.ranges();
      entries_ = rows_.entries();
      plant_garbage(ranges_);
      plant_garbage(entries_);
    }
  }

  [[nodiscard]] index_t size() const { return static_cast<index_t>(model_.size()); }

  /// Runs over the rows begin .. end-1, and expects the plain loop's bits there and nothing written elsewhere.
  void expect_right(index_t begin, index_t end) {
    const auto before = std::tuple(on_host(counts_), on_host(sums_), on_host(differences_));
    if constexpr (Space::kind == SpaceKind::cuda) {
      parallel_for(Cuda{}, begin, end,
                   VisitRows{rows_.const_view(), in_.const_view(), counts_.view(), sums_.view(), differences_.view()});
      synchronize();
    } else {
      const Rows rows{ranges_.const_view(), entries_.const_view(), in_.size()};
      parallel_for<Case::lanes>(Host{}, begin, end,
                                VisitRows{rows, in_.const_view(), counts_.view(), sums_.view(), differences_.view()});
    }
    const auto after = std::tuple(on_host(counts_), on_host(sums_), on_host(differences_));
    for (index_t i = 0; i < size(); ++i) {
      auto count = std::get<0>(before).view().get(i);
      auto sum = std::get<1>(before).view().get(i);
      auto difference = std::get<2>(before).view().get(i);
      if (i >= begin && i < end) visit(i, count, sum, difference);
      ASSERT_EQ(std::get<0>(after).view().get(i).element, count.element) << "row " << i;
      ASSERT_EQ(std::get<0>(after).view().get(i).local, count.local) << "row " << i;
      ASSERT_EQ(std::get<1>(after).view().get(i).f, sum.f) << "row " << i;
      ASSERT_EQ(std::get<2>(after).view().get(i).dx, difference.dx) << "row " << i;
    }
  }

 private:
  void visit(index_t i, elasticity::Incidence<Real>& count, elasticity::NodeForce<Real>& sum,
             elasticity::NodeDisplacement<Real>& difference) const {
    const auto& row = model_[static_cast<std::size_t>(i)];
    count.element = count.local = static_cast<std::int32_t>(row.size());
    sum.f.setZero();
    difference.dx.setOnes();
    Real most = -1;
    for (const Entry& entry : row) {
      const Eigen::Matrix<Real, 3, 1> x = positions_.view().get(entry.element).x;
      sum.f += x;
      difference.dx = (x - difference.dx).eval();
      most = std::max(most, x[0]);
    }
    difference.dx[2] = most;
  }
  template <class Object>
  static HostArray<Object> on_host(const Array<Object>& array) {
    HostArray<Object> host(array.size());
    copy(host, array);
    synchronize();
    return host;
  }

  RowModel<Entry> model_;
  typename Case::Rows rows_;
  Array<elasticity::IncidenceRangeObject> ranges_;  // copies with garbage in their padding
  Array<elasticity::IncidenceObject> entries_;
  HostArray<elasticity::NodePositionObject> positions_;
  Array<elasticity::NodePositionObject> in_;
  Array<elasticity::IncidenceObject> counts_;
  Array<elasticity::NodeForceObject> sums_;
  Array<elasticity::NodeDisplacementObject> differences_;
};

template <class Case>
void check_visits() {
  using Entry = typename Case::Entry;
  std::mt19937 random(seed());
  for (index_t n = 0; n <= 70; ++n) {
    const int longest = n % 7 == 0 ? 0 : 8;  // no entry at all, so that whatever is read does not exist
    RowVisits<Case> visits(random_rows<Entry>(n, longest, 17, random), 17, random);
    visits.expect_right(0, n);
    for (int range = 0; range < 4 && n > 0; ++range) {
      const index_t begin = std::uniform_int_distribution<index_t>(0, n - 1)(random);
      visits.expect_right(begin, std::uniform_int_distribution<index_t>(begin, n)(random));
    }
  }
  RowVisits<Case> visits(random_rows<Entry>(1003, 8, 500, random), 500, random);
  visits.expect_right(0, 1003);
  visits.expect_right(3, 1001);
  RowModel<Entry> one(64);  // a single entry: all other lanes repeat it
  one[37].push_back({0, 0});
  RowVisits<Case>(one, 1, random).expect_right(0, 64);
}

/// Rows made in three ways are those of the model.
template <class Case>
void check_construction() {
  using Entry = typename Case::Entry;
  using Rows = typename Case::Rows;
  std::mt19937 random(seed());
  for (const index_t n : {0, 1, 2, 33, 1003}) {
    const auto model = random_rows<Entry>(n, 8, 100, random);
    std::vector<std::pair<index_t, Entry>> pairs;
    std::vector<Entry> entries;
    std::vector<std::int32_t> first{0};
    for (std::size_t i = 0; i < model.size(); ++i) {
      for (const Entry& entry : model[i]) {
        pairs.emplace_back(static_cast<index_t>(i), entry);
        entries.push_back(entry);
      }
      first.push_back(static_cast<std::int32_t>(entries.size()));
    }
    // Unsorted by row, in order within each.
    std::shuffle(pairs.begin(), pairs.end(), random);
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const auto& a, const auto& b) { return a.second.local < b.second.local; });
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const auto& a, const auto& b) { return a.first * 7919 % 1009 < b.first * 7919 % 1009; });
    const RowTargets targets{"element", 100};
    expect_rows(Rows::from_lists(targets, model), model);
    expect_rows(Rows::from_pairs(targets, n, pairs), model);
    const Rows made = Rows::from_offsets(targets, first, entries);
    expect_rows(made, model);
    expect_rows(Rows(targets, made.ranges(), made.entries()), model);
  }
}

/// A random sequence of changes of both sets, and the same on vectors.
template <class Case>
void check_row_topology() {
  using Entry = typename Case::Entry;
  using Rows = typename Case::Rows;
  std::mt19937 random(seed());
  index_t targets = 60;
  RowModel<Entry> model = random_rows<Entry>(90, 8, targets, random);
  Rows rows = Rows::from_lists({"element", targets}, model);
  const auto pick = [&](const std::vector<index_t>& order) {
    RowModel<Entry> picked;
    for (const index_t i : order) picked.push_back(model[static_cast<std::size_t>(i)]);
    model = picked;
  };
  const auto renumber_model = [&](const std::vector<index_t>& number) {
    for (auto& row : model) {
      std::erase_if(row, [&](const Entry& e) { return number[static_cast<std::size_t>(e.element)] < 0; });
      for (Entry& e : row) e.element = static_cast<std::int32_t>(number[static_cast<std::size_t>(e.element)]);
    }
  };
  for (int step = 0; step < 40; ++step) {
    SCOPED_TRACE("step " + std::to_string(step));
    const auto n = static_cast<index_t>(model.size());
    if (step % 5 == 0) {
      const auto order = random_order(n, random);
      rows.permute(order);
      pick(order);
    } else if (step % 5 == 1) {
      std::vector<index_t> gone = random_part(n, random);
      gone.resize(gone.size() / 4);
      const auto kept = remaining(n, gone);
      if (step % 2 == 0) {
        rows.compact(kept);
      } else {
        rows.erase(gone);
      }
      pick(kept);
    } else if (step % 5 == 2) {
      rows.append(7);
      model.resize(model.size() + 7);
    } else if (step % 5 == 3) {  // targets are erased, and new ones come behind them
      std::vector<index_t> gone = random_part(targets, random);
      gone.resize(gone.size() / 8);
      const auto kept = remaining(targets, gone);
      const auto number = new_numbers(kept, targets);
      targets = static_cast<index_t>(kept.size()) + 3;
      rows.renumber(number, targets);
      renumber_model(number);
    } else {
      const auto number = inverse(random_order(targets, random));
      rows.renumber(number, targets);
      renumber_model(number);
    }
    expect_rows(rows, model);
    ASSERT_EQ(rows.targets().count, targets);
  }
  rows.compact(std::vector<index_t>{});
  model.clear();
  expect_rows(rows, model);
}

/// A failure names what is wrong and changes nothing.
template <class Case>
void check_refused_changes() {
  using Entry = typename Case::Entry;
  using Rows = typename Case::Rows;
  using List = std::vector<index_t>;
  const RowModel<Entry> model{{{0, 0}, {2, 1}}, {}, {{1, 2}}};
  Rows rows = Rows::from_lists({"element", 3}, model);
  const auto refuses = [&](const auto& change, const std::string& wanted) {
    const std::string said = message_of(change);
    EXPECT_NE(said.find(wanted), std::string::npos) << said;
    expect_rows(rows, model);
    EXPECT_EQ(rows.targets().count, 3);
  };
  refuses([&] { rows.permute(List{0, 1, 1}); }, "rows of elasticity::Incidence: number 1 at position 2 of the list");
  refuses([&] { rows.compact(List{1, 0}); }, "rows of elasticity::Incidence: number 0 at position 1");
  refuses([&] { rows.erase(List{3}); }, "there is no such object; write 0 to 2");
  refuses([&] { rows.append(-1); }, "cannot append -1 objects");
  refuses([&] { rows.renumber(List{0, 1}, 3); },
          "2 new numbers are given, and entries name 3 objects; give one for each, -1 where it is gone");
  refuses([&] { rows.renumber(List{0, 1, 2}, 2); },
          "the new number of object 2 is 2, of 2 objects; give a number from 0 to 1, or -1 where it is gone");
  refuses([&] { rows.renumber(List{0, -2, 2}, 3); }, "the new number of object 1 is -2");
}

}  // namespace physgen::test
