// The version of physgen: CMake, the commands and results take it from here. CHANGELOG.md says what each version
// changed.
#pragma once

#define PHYSGEN_VERSION "0.2.0"
/// For comparisons: 10000 * major + 100 * minor + patch.
#define PHYSGEN_VERSION_NUMBER 200
