// Libraries that are looked for when the program runs: one that has all functions, that lacks one, and that is not
// there.
#include <gtest/gtest.h>
#include <unistd.h>

#include "vendor/library.h"

int no_library_has_this_function();  // declared only, as a newer header does what an older library lacks

#define ALL_THERE(USE) USE(getpid) USE(getppid)
#define ONE_MISSING(USE) USE(getpid) USE(no_library_has_this_function) USE(getppid)

namespace physgen::bench {
namespace {

PHYSGEN_VENDOR_LIBRARY(Complete, ALL_THERE, "libc.so", {".6"});
PHYSGEN_VENDOR_LIBRARY(Old, ONE_MISSING, "libc.so", {".6"});
PHYSGEN_VENDOR_LIBRARY(Absent, ALL_THERE, "libno_vendor_has_this.so");

TEST(VendorLibrary, that_has_all_functions_can_be_called) {
  const Complete library;
  EXPECT_EQ(library.shared.missing(), "");
  EXPECT_EQ(library.getpid(), ::getpid());
}

TEST(VendorLibrary, that_lacks_a_function_says_which_and_leaves_its_rows_out) {
  const Old library;
  EXPECT_EQ(library.shared.missing(), "libc.so has no no_library_has_this_function: its rows are left out");
  EXPECT_EQ(library.no_library_has_this_function, nullptr);
}

TEST(VendorLibrary, that_is_not_there_says_so) {
  const Absent library;
  EXPECT_EQ(library.shared.missing(), "no libno_vendor_has_this.so: its rows are left out");
  EXPECT_EQ(library.getpid, nullptr);
}

}  // namespace
}  // namespace physgen::bench
