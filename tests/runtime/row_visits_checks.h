// Kernels over rows, held against vectors of vectors: one source for host and CUDA; parallel_for is included by
// the files that instantiate it.
#pragma once

#include "rows_model.h"

namespace physgen::test {

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
      const VisitRows kernel{rows, in_.const_view(), counts_.view(), sums_.view(), differences_.view()};
      parallel_for(Host{}, begin, end, lanes<Case::lanes>(kernel));
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

}  // namespace physgen::test
