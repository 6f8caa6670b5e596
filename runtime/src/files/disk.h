// Services of the file system that every file of a run needs: room for its contents, and replacement in one step, so
// that a full disk or a kill leaves what was there before.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>

namespace physgen::disk {

/// Lets an existing file grow by so many bytes: they are allocated behind its end, which stays where it is, or, on file
/// systems that cannot, known to be free.
/// @throws Error naming the file, the bytes needed and the bytes free; the file is then as it was
void reserve_space(const std::filesystem::path& file, std::uint64_t bytes);

/// Replaces a file by a new version, which `write` writes, and closes, under the name that it is given. Whoever opens
/// the file finds the old version or the new one, also after the machine lost power.
/// @throws Error naming the file, and what `write` throws; an old version is then as it was, and nothing is left of the
/// new one
void replace_file(const std::filesystem::path& file, const std::function<void(const std::filesystem::path&)>& write);
/// The same, written under another name of the same folder.
void replace_file(const std::filesystem::path& file, const std::filesystem::path& written,
                  const std::function<void(const std::filesystem::path&)>& write);
/// A name for the new version of a file that no other call and no other process of the machine has.
[[nodiscard]] std::filesystem::path new_name(const std::filesystem::path& file);

/// Writes a text file, by replace_file().
/// @throws Error naming the file
void write_text(const std::filesystem::path& file, std::string_view text);

/// Appends to an existing text file.
/// @throws Error naming the file, which is then as it was
void append_text(const std::filesystem::path& file, std::string_view text);

}  // namespace physgen::disk
