// Rows after changes of topology, held against vectors of vectors: one source for host and CUDA.
#pragma once

#include "row_visits_checks.h"

namespace physgen::test {

/// Rows made in three ways are those of the model.
template <class Case>
void check_construction(std::initializer_list<index_t> sizes = {0, 1, 2, 33, 1003}) {
  using Entry = typename Case::Entry;
  using Rows = typename Case::Rows;
  std::mt19937 random(seed());
  for (const index_t n : sizes) {
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
void check_row_topology(index_t size = 90, index_t targets = 60, int steps = 40) {
  using Entry = typename Case::Entry;
  using Rows = typename Case::Rows;
  std::mt19937 random(seed());
  RowModel<Entry> model = random_rows<Entry>(size, 8, targets, random);
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
  for (int step = 0; step < steps; ++step) {
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
  refuses([&] { rows.erase(List{3}); }, "this object does not exist; write 0 to 2");
  refuses([&] { rows.append(-1); }, "cannot append -1 objects");
  refuses([&] { rows.renumber(List{0, 1}, 3); },
          "2 new numbers are given, and entries name 3 objects; give one for each, -1 where it is gone");
  refuses([&] { rows.renumber(List{0, 1, 2}, 2); },
          "the new number of object 2 is 2, of 2 objects; give a number from 0 to 1, or -1 where it is gone");
  refuses([&] { rows.renumber(List{0, -2, 2}, 3); }, "the new number of object 1 is -2");
}

}  // namespace physgen::test
