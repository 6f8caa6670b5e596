// Initial values of objects, on the host and by the backend.
#include <physgen/device.h>
#include <physgen/initial_values.h>

#include "backend/objects.h"

namespace physgen {

void initialize(const UntypedArray& array, index_t begin, index_t end) {
  if (begin == end) return;
  detail::wait_for_host_work(array.space);
  for (const FieldInfo& field : array.fields) {
    if (!field.is_stored()) continue;
    const detail::Fill fill(field);
    if (fill.is_zero()) continue;
    if (host_accessible(array.space)) {
      const detail::Addressing addresses(array);
#pragma omp parallel for schedule(static) if (end - begin > 8192)
      for (index_t i = begin; i < end; ++i) fill.apply(addresses, i);
    } else {
      backend::fill(array, fill, begin, end);
    }
  }
}

}  // namespace physgen
