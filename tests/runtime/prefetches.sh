#!/usr/bin/env bash
# prefetches.sh COMPILER FLAGS...: counts the prefetches of AVX-512 packs that read nine channels. All go to the second
# cache, because those to the first one hold its miss buffers; where a pack is a tile, hardware needs none.
set -euo pipefail
failed=0
check() {  # layout prefetches
  assembly=$("$1" "${@:4}" -std=c++20 -O2 -march=x86-64-v4 -x c++ -S -o - - <<E2
#include <elasticity.physgen.h>
#include <physgen/parallel_for.h>
using namespace physgen;
void move(const elasticity::DeformationGradientView<float, $2>& from,
          const elasticity::DeformationGradientView<float, $2>& to, index_t i) {
  to.put(Pack<16>{i}, from.get(Pack<16>{i}));
}
E2
  )
  first=$(grep -cE 'prefetch(t0|nta)' <<<"$assembly" || true)
  second=$(grep -cE 'prefetcht[12]' <<<"$assembly" || true)
  echo "$2: $first prefetches into the first cache, $second into the second"
  if [ "$first" -ne 0 ] || [ "$second" -ne "$3" ]; then failed=1; fi
}
compiler=$1
shift
check "$compiler" 'Aosoa<16>' 0 "$@"
check "$compiler" 'Aosoa<32>' 9 "$@"
check "$compiler" Soa 9 "$@"
if [ $failed -ne 0 ]; then echo 'FAILED: expected 0 into the first, and 0, 9, 9 into the second' >&2; fi
exit $failed
