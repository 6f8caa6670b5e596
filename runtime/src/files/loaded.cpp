// What came of load() and load_npy() as a sentence.
#include <physgen/arrays/loaded.h>

#include "names.h"

namespace physgen {

std::string Loaded::text() const {
  std::string text = std::to_string(objects) + " objects were loaded with " + files::list(fields);
  if (!left_out.empty()) text += "; left out, since the array does not store it: " + files::list(left_out);
  if (!kept.empty()) text += "; not in the file, so that it keeps its values: " + files::list(kept);
  return text;
}

}  // namespace physgen
