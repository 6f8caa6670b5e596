// saved_rates FOLDER [MB [ROUNDS]]: how fast arrays of so many megabytes are saved and loaded in each layout, beside
// write() with fsync() and read() of as many bytes, in turn. The shortest time of all rounds counts. Exit status 1
// where a loaded array has other bits than the saved one.
#include <elasticity.physgen.h>
#include <fcntl.h>
#include <physgen/save.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <vector>

namespace {

using namespace physgen;
namespace fs = std::filesystem;

constexpr std::size_t block = std::size_t{8} << 20;

class Descriptor {
 public:
  Descriptor(const fs::path& file, int flags) : id_(::open(file.c_str(), flags, 0666)) {
    if (id_ < 0) throw Error(file.string() + " cannot be opened");
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { ::close(id_); }
  [[nodiscard]] int id() const { return id_; }

 private:
  int id_;
};

/// Seconds of the shortest call.
class Shortest {
 public:
  void time(const std::function<void()>& call) {
    const auto begin = std::chrono::steady_clock::now();
    call();
    seconds_ = std::min(seconds_, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  [[nodiscard]] double seconds() const { return seconds_; }

 private:
  double seconds_ = std::numeric_limits<double>::max();
};

void write_plainly(const fs::path& file, std::size_t bytes, const std::vector<char>& from) {
  const Descriptor out(file, O_WRONLY | O_CREAT | O_TRUNC);
  for (std::size_t at = 0; at < bytes; at += block) {
    const std::size_t count = std::min(block, bytes - at);
    if (::write(out.id(), from.data(), count) != static_cast<ssize_t>(count)) throw Error("write() failed");
  }
  if (::fsync(out.id()) != 0) throw Error("fsync() failed");
}

void read_plainly(const fs::path& file, std::vector<char>& to) {
  const Descriptor in(file, O_RDONLY);
  ssize_t count = 0;
  do {
    count = ::read(in.id(), to.data(), block);
    if (count < 0) throw Error("read() failed");
  } while (count > 0);
}

/// The next read of the file comes from the disk. @pre fsync()
void forget(const fs::path& file) {
  const Descriptor in(file, O_RDONLY);
  ::posix_fadvise(in.id(), 0, 0, POSIX_FADV_DONTNEED);
}

/// Objects whose elements are all different.
template <class Array>
void number(Array& array) {
  const UntypedArray untyped = array.untyped();
  for (index_t i = 0; i < array.size(); ++i) {
    int place = 0;
    for (const FieldInfo& field : untyped.fields) {
      for (int k = 0; k < field.count; ++k, ++place) {
        const float value = static_cast<float>(i % 8000017) + 0.03125F * static_cast<float>(place);
        std::memcpy(untyped.address(i, field.offset + 4 * k, 4), &value, sizeof value);
      }
    }
  }
}

template <class Array>
bool equal(const Array& a, const Array& b) {
  const UntypedArray one = a.untyped(), other = b.untyped();
  if (a.size() != b.size()) return false;
  for (index_t i = 0; i < a.size(); ++i) {
    for (const FieldInfo& field : one.fields) {
      for (int k = 0; k < field.count; ++k) {
        const int offset = field.offset + 4 * k;
        if (std::memcmp(one.address(i, offset, 4), other.address(i, offset, 4), 4) != 0) return false;
      }
    }
  }
  return true;
}

template <class Object, class Layout>
bool measure(const fs::path& folder, const char* name, std::size_t bytes, int rounds) {
  using Objects = Array<Object, float, Host, Layout>;
  const fs::path file = folder / "saved_rates.h5", plain = folder / "saved_rates.plain";
  Objects saved(static_cast<index_t>(bytes) / Objects::record_bytes);
  number(saved);
  std::vector<char> memory(block, 'x');
  Shortest write, save_it, read, load_new, load_again, cold_read, cold_load;
  bool same = true;
  for (int round = 0; round < rounds; ++round) {
    write.time([&] { write_plainly(plain, static_cast<std::size_t>(saved.size() * Objects::record_bytes), memory); });
    save_it.time([&] { save(file, {{"objects", saved}}); });
    forget(plain);
    forget(file);
    cold_read.time([&] { read_plainly(plain, memory); });
    {
      Objects loaded;
      cold_load.time([&] { load(file, "objects", loaded); });
    }
    read_plainly(file, memory);
    read.time([&] { read_plainly(file, memory); });
    Objects loaded;
    load_new.time([&] { load(file, "objects", loaded); });
    same = same && equal(saved, loaded);
    number(loaded);
    load_again.time([&] { load(file, "objects", loaded); });
    same = same && equal(saved, loaded);
  }
  const double mb = static_cast<double>(saved.size() * Objects::record_bytes) / 1e6;
  const auto rate = [mb](const Shortest& time) { return mb / time.seconds(); };
  std::printf("%-26s %6.0f | %6.0f %6.0f %5.2f | %6.0f %6.0f %5.2f | %6.0f %6.0f %5.2f | %6.0f %5.2f\n", name, mb,
              rate(write), rate(save_it), rate(save_it) / rate(write), rate(cold_read), rate(cold_load),
              rate(cold_load) / rate(cold_read), rate(read), rate(load_new), rate(load_new) / rate(read),
              rate(load_again), rate(load_again) / rate(read));
  std::fflush(stdout);
  fs::remove(file);
  fs::remove(plain);
  return same;
}

template <class Object>
bool measure_layouts(const fs::path& folder, const char* name, std::size_t bytes, int rounds) {
  const auto named = [name](const char* layout) { return std::string(name) + " " + layout; };
  bool same = measure<Object, Aos>(folder, named("aos").c_str(), bytes, rounds);
  same = measure<Object, AosPadded>(folder, named("aos_padded").c_str(), bytes, rounds) && same;
  same = measure<Object, Soa>(folder, named("soa").c_str(), bytes, rounds) && same;
  return measure<Object, Aosoa<16>>(folder, named("aosoa16").c_str(), bytes, rounds) && same;
}

}  // namespace

int main(int count, char** words) try {
  const fs::path folder = count > 1 ? words[1] : ".";
  const std::size_t bytes = static_cast<std::size_t>(count > 2 ? std::atoi(words[2]) : 512) * 1000000;
  const int rounds = count > 3 ? std::atoi(words[3]) : 3;
  std::puts(
      "[MB/s]                         MB |  write   save ratio | cold read load     | read    load ratio | again "
      "ratio");
  bool same = measure_layouts<elasticity::StressDerivativeObject>(folder, "StressDerivative", bytes, rounds);
  same = measure_layouts<elasticity::DeformationSvdObject>(folder, "DeformationSvd", bytes, rounds) && same;
  if (!same) std::puts("what was loaded is not what was saved");
  return same ? 0 : 1;
} catch (const std::exception& error) {
  return std::fprintf(stderr, "%s\n", error.what()), 1;
}
