// Checks of lists of object numbers, and lists that follow from them.
#include <physgen/arrays/object_numbers.h>
#include <physgen/error.h>

#include <algorithm>

namespace physgen {

namespace {

[[noreturn]] void refuse(const std::string& of, std::size_t position, index_t number, const std::string& why) {
  throw Error(of + ": number " + std::to_string(number) + " at position " + std::to_string(position) +
              " of the list: " + why);
}

void check_range(std::size_t position, index_t number, index_t size, const std::string& of) {
  if (number >= 0 && number < size) return;
  refuse(of, position, number,
         "this object does not exist; " +
             (size == 0 ? std::string("there are none") : "write 0 to " + std::to_string(size - 1)));
}

// Marks those of the objects 0 .. size-1 that are listed.
std::vector<bool> listed(std::span<const index_t> numbers, index_t size, const std::string& of) {
  if (size < 0) throw Error(of + ": there cannot be " + std::to_string(size) + " objects");
  std::vector<bool> seen(static_cast<std::size_t>(size), false);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    check_range(i, numbers[i], size, of);
    const auto number = static_cast<std::size_t>(numbers[i]);
    if (seen[number]) {
      const auto first = std::find(numbers.begin(), numbers.end(), numbers[i]) - numbers.begin();
      refuse(of, i, numbers[i], "it stands at position " + std::to_string(first) + " already; write each object once");
    }
    seen[number] = true;
  }
  return seen;
}

}  // namespace

void check_permutation(std::span<const index_t> order, index_t size, const std::string& of) {
  if (static_cast<index_t>(order.size()) != size) {
    throw Error(of + ": an order of " + std::to_string(order.size()) + " numbers cannot permute " +
                std::to_string(size) + " objects; write each object once");
  }
  (void)listed(order, size, of);
}

void check_ascending(std::span<const index_t> kept, index_t size, const std::string& of) {
  for (std::size_t i = 0; i < kept.size(); ++i) {
    check_range(i, kept[i], size, of);
    if (i > 0 && kept[i] <= kept[i - 1]) {
      refuse(of, i, kept[i],
             "it follows " + std::to_string(kept[i - 1]) + "; sort the list and write each object once");
    }
  }
}

std::vector<index_t> remaining(index_t size, std::span<const index_t> erased, const std::string& of) {
  const std::vector<bool> gone = listed(erased, size, of);
  std::vector<index_t> kept;
  kept.reserve(gone.size() - erased.size());
  for (index_t i = 0; i < size; ++i) {
    if (!gone[static_cast<std::size_t>(i)]) kept.push_back(i);
  }
  return kept;
}

std::vector<index_t> inverse(std::span<const index_t> order) {
  return new_numbers(order, static_cast<index_t>(order.size()));  // as many distinct numbers as objects: each once
}

std::vector<index_t> new_numbers(std::span<const index_t> kept, index_t size) {
  (void)listed(kept, size, "objects");
  std::vector<index_t> numbers(static_cast<std::size_t>(size), -1);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    numbers[static_cast<std::size_t>(kept[i])] = static_cast<index_t>(i);
  }
  return numbers;
}

}  // namespace physgen
