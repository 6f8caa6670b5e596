// The constant that all objects of this library's mode refer to, so that objects of the other mode do not link with it.
// As every program is linked with it, it also brings the script by which gdb shows arrays.
#include <physgen/config.h>

namespace physgen {
extern "C" {
#ifdef PHYSGEN_CHECKED
const char physgen_objects_were_compiled_with_PHYSGEN_CHECKED = 0;
#else
const char physgen_objects_were_compiled_without_PHYSGEN_CHECKED = 0;
#endif
}
}  // namespace physgen

#if defined(PHYSGEN_GDB_SCRIPT) && defined(__ELF__)
// gdb loads the text of Python (4) that it finds in this section; see its manual, ".debug_gdb_scripts".
asm(".pushsection .debug_gdb_scripts, \"MS\", %progbits, 1\n"
    ".byte 4\n"
    ".ascii \"gdb.inlined.physgen\\n\"\n"
    ".incbin \"" PHYSGEN_GDB_SCRIPT
    "\"\n"
    ".byte 0\n"
    ".popsection\n");
#endif
