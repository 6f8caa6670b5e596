// Entries of a row that are made one after the other, while they are read.
#pragma once

#include <physgen/config.h>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>

namespace physgen::fem {

/// make(begin), ..., make(end - 1), as a forward range.
template <class Make>
class MadeEntries {
 public:
  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = std::invoke_result_t<const Make&, index_t>;
    using difference_type = std::ptrdiff_t;
    using pointer = void;
    using reference = value_type;

    Iterator() = default;
    Iterator(const Make* make, index_t number) : make_(make), number_(number) {}
    value_type operator*() const { return (*make_)(number_); }
    Iterator& operator++() {
      ++number_;
      return *this;
    }
    Iterator operator++(int) { return {make_, number_++}; }
    bool operator==(const Iterator& other) const { return number_ == other.number_; }

   private:
    const Make* make_ = nullptr;
    index_t number_ = 0;
  };

  MadeEntries(index_t begin, index_t end, Make make) : begin_(begin), end_(end), make_(std::move(make)) {}
  [[nodiscard]] Iterator begin() const { return {&make_, begin_}; }
  [[nodiscard]] Iterator end() const { return {&make_, end_}; }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }

 private:
  index_t begin_, end_;
  Make make_;
};

}  // namespace physgen::fem
