// Loops of the host on several threads: the public headers give the library a loop's body without its type, so that
// programs need no flags or headers of a thread library.
#pragma once

#include <physgen/config.h>

#include <atomic>

namespace physgen::detail {

/// The work of a loop over 0 .. count-1, without its type: call(what, begin, end) does the part begin .. end-1, and
/// throws nothing.
struct Body {
  void (*call)(const void* what, index_t begin, index_t end);
  const void* what;
};

/// What one index of a loop takes, as earlier launches of the same loop took it [ns].
struct LoopCost {
  std::atomic<float> ns;
};

/// Does a loop's work, part by part, and returns when all is done: on the calling thread where `cost` promises less
/// work than other threads take to wake up, and where it is called by a part of another loop; else on threads().
void run_parts(index_t count, LoopCost& cost, const Body& body);

/// Calls work(begin, end) for parts of 0 .. count-1, each part once, on several threads where that is worth while.
/// @tparam kObjects of one index: for the guess at the first launch
/// @param work throws nothing
template <int kObjects = 1, class Work>
void for_parts(index_t count, const Work& work) {
  constexpr float ns_of_an_object = 5;
  constinit static LoopCost cost{ns_of_an_object * kObjects};
  run_parts(count, cost,
            {[](const void* what, index_t begin, index_t end) {
               const Work of_this_thread = *static_cast<const Work*>(what);  // what it refers to stays in registers
               of_this_thread(begin, end);
             },
             &work});
}

/// Calls work(i) for i = begin .. end-1, each once, on several threads where that is worth while.
/// @tparam kObjects of one call
/// @param work throws nothing
template <int kObjects = 1, class Work>
void for_each_index(index_t begin, index_t end, const Work& work) {
  for_parts<kObjects>(end - begin, [begin, &work](index_t part_begin, index_t part_end) {
    const Work of_this_thread = work;
    for (index_t i = begin + part_begin; i < begin + part_end; ++i) of_this_thread(i);
  });
}

}  // namespace physgen::detail
