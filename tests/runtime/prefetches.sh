#!/usr/bin/env bash
# prefetches.sh COMPILER FLAGS...: counts the prefetches of AVX-512 packs that read nine channels. All go to the second
# cache, because those to the first one hold its miss buffers; where a pack is a tile, hardware needs none.
set -euo pipefail
compiler=$1
shift
assembly=$("$compiler" "$@" -std=c++20 -O2 -march=x86-64-v4 -x c++ -S -o - - <<'E2'
#include <elasticity.physgen.h>
#include <physgen/parallel_for.h>
using namespace physgen;
template <class Layout>
using Objects = elasticity::DeformationGradientView<float, Layout>;
#define MOVE(name, ...)                                                                                   \
  extern "C" void name(const Objects<__VA_ARGS__>& from, const Objects<__VA_ARGS__>& to, index_t i) { \
    to.put(Pack<16>{i}, from.get(Pack<16>{i}));                                                         \
  }
MOVE(tiles_of_16, Aosoa<16>)
MOVE(tiles_of_32, Aosoa<32>)
MOVE(structs_of_arrays, Soa)
E2
)
failed=0
check() {  # function prefetches
  local text first second
  text=$(sed -n "/^$1:/,/\.cfi_endproc/p" <<<"$assembly")
  [[ $text ]] || { echo "FAILED: the assembly has no $1" >&2; exit 1; }
  first=$(grep -cE 'prefetch(t0|nta)' <<<"$text" || true)
  second=$(grep -cE 'prefetcht[12]' <<<"$text" || true)
  echo "$1: $first prefetches into the first cache, $second into the second"
  if [ "$first" -ne 0 ] || [ "$second" -ne "$2" ]; then failed=1; fi
}
check tiles_of_16 0
check tiles_of_32 9
check structs_of_arrays 9
if [ $failed -ne 0 ]; then echo 'FAILED: expected 0 into the first, and 0, 9, 9 into the second' >&2; fi
exit $failed
