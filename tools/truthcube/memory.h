// How much memory there is to allocate in.
#pragma once

#include <cstdint>
#include <string>

namespace physgen::truthcube {

/// Memory of the host: all that the machine has, or as much of it as this process may have.
[[nodiscard]] std::int64_t host_memory();

/// Free in the GPU that would be used. @throw Error when there is none, or this build has no CUDA
[[nodiscard]] std::int64_t cuda_memory();

/// "1.25 GB"
[[nodiscard]] std::string gigabytes(std::int64_t bytes);

/// @param who takes the memory, such as "a cube of 300^3 cells"
/// @param where the memory is, such as "this machine"
/// @throw Error with both numbers of bytes and the remedy, when there is too little
void require_memory(const std::string& who, std::int64_t needed, const std::string& where, std::int64_t there_is,
                    const std::string& remedy);

}  // namespace physgen::truthcube
