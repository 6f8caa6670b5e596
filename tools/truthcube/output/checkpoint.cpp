// An HDF5 file of its own, with a checksum of all that a run takes from it.
#include <files/disk.h>
#include <hdf5/h5.h>
#include <physgen/error.h>
#include <truthcube/output/checkpoint.h>
#include <truthcube/output/hash.h>

#include <bit>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

namespace physgen::truthcube {

namespace {

using h5::one;
using Json = nlohmann::json;

constexpr std::int32_t current_version = 1;
constexpr const char* format = "physgen truthcube checkpoint";
constexpr std::uint64_t room_for_attributes = std::uint64_t{1} << 16U;

/// The checksum of a checkpoint, whose positions are added in order.
class Checksum {
 public:
  Checksum(const Checkpoint& head, std::uint64_t positions) : head_(head) {
    hash_.add(std::as_bytes(std::span(head.settings)));
    hash_.add(head.mesh_hash);
    hash_.add(static_cast<std::uint64_t>(head.step));
    hash_.add(std::bit_cast<std::uint64_t>(head.compression));
    hash_.add(positions * sizeof(double));
  }
  void add(std::span<const double> positions) {
    for (const double x : positions) hash_.add(std::bit_cast<std::uint64_t>(x));
  }
  /// @pre all positions are added
  [[nodiscard]] std::uint64_t value() const {
    Hash hash = hash_;
    hash.add(std::as_bytes(std::span(head_.pressures)));
    if (head_.order != OrderMark{}) {  // which older files do not have
      hash.add(std::as_bytes(std::span(head_.order.name)));
      hash.add(head_.order.digest);
    }
    return hash.value();
  }

 private:
  const Checkpoint& head_;
  Hash hash_;
};

Json parse_settings(const std::string& text, const std::string& where) {
  Json settings = Json::parse(text, nullptr, false);
  if (!settings.is_object()) throw Error(where + ": the settings are not a JSON object: " + text);
  return settings;
}

// "poisson: 0.45 in the checkpoint, 0.49 in this run; ..."
std::string differences(const Json& then, const Json& now) {
  std::set<std::string> keys;
  for (const Json* settings : {&then, &now}) {
    for (const auto& [key, value] : settings->items()) keys.insert(key);
  }
  const auto value_of = [](const Json& settings, const std::string& key) {
    return settings.contains(key) ? settings[key].dump() : "not set";
  };
  std::string text;
  for (const std::string& key : keys) {
    if (then.contains(key) && now.contains(key) && then[key] == now[key]) continue;
    text += (text.empty() ? "" : "; ") + key + ": " + value_of(then, key) + " in the checkpoint, " +
            value_of(now, key) + " in this run";
  }
  return text;
}

// A file that can be read, and must not be used.
struct Unusable : Error {
  using Error::Error;
};

OrderMark order_in(const h5::File& file) {
  if (!file.has_attribute("/", "order")) return {};  // an older one
  return {file.read_text_attribute("/", "order"), file.read_attribute<std::uint64_t>("/", "order_digest")};
}

void require_same_name(const std::string& path, const OrderMark& order, const std::string& name) {
  if (order.name == name) return;
  throw Unusable(path + ": this checkpoint has its nodes in another order than this run, --order " + order.name +
                 " and not " + name + "; add --order " + order.name);
}

// The contents of the file, unchecked but for its version and checksum.
Checkpoint read_all(const std::filesystem::path& path) {
  const std::string name = path.string();
  try {
    const h5::File file = h5::File::open(path, false);
    if (!file.has_attribute("/", "format") || file.read_text_attribute("/", "format") != format) {
      throw Unusable(name + ": this is not a checkpoint of truthcube");
    }
    const auto version = file.read_attribute<std::int32_t>("/", "version");
    if (version != current_version) {
      throw Unusable(name + ": has version " + std::to_string(version) + ", but this program reads version " +
                     std::to_string(current_version));
    }
    Checkpoint c;
    const std::vector<std::uint8_t> settings = file.read_dataset<std::uint8_t>("/settings");
    c.settings.assign(settings.begin(), settings.end());
    c.mesh_hash = file.read_attribute<std::uint64_t>("/", "mesh_hash");
    c.step = file.read_attribute<std::int32_t>("/", "step");
    c.compression = file.read_attribute<double>("/", "compression");
    c.positions = file.read_dataset<double>("/positions");
    c.pressures = file.read_dataset<double>("/pressures");
    c.order = order_in(file);
    Checksum checksum(c, c.positions.size());
    checksum.add(c.positions);
    if (checksum.value() != file.read_attribute<std::uint64_t>("/", "checksum")) {
      throw Unusable(name + ": is damaged: its checksum is not that of its contents");
    }
    return c;
  } catch (const Unusable&) {
    throw;
  } catch (const Error& error) {
    throw Error(name + ": this file is damaged, or is not a checkpoint: " + error.what());
  }
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& c, std::uint64_t count,
                      const std::function<void(const TakePositions&)>& give) {
  static_cast<void>(parse_settings(c.settings, path.string()));
  disk::replace_file(path, [&](const std::filesystem::path& written) {
    const std::uint64_t bytes = (count + c.pressures.size()) * sizeof(double) + c.settings.size();
    h5::File file = h5::File::create(written, bytes + room_for_attributes);
    file.write_attribute("/", "format", std::string(format));
    file.write_attribute("/", "version", one(current_version));
    const std::vector<std::uint8_t> settings(c.settings.begin(), c.settings.end());
    file.write_dataset<std::uint8_t>("/settings", std::span<const std::uint8_t>(settings));
    file.write_attribute("/", "mesh_hash", one(c.mesh_hash));
    file.write_attribute("/", "step", one<std::int32_t>(c.step));
    file.write_attribute("/", "compression", one(c.compression));
    file.make_dataset<double>("/positions", count);
    Checksum checksum(c, count);
    std::uint64_t done = 0;
    give([&](std::span<const double> positions) {
      if (positions.size() > count - done) throw Error(path.string() + ": more coordinates come than it has");
      file.write_rows("/positions", done, positions);
      checksum.add(positions);
      done += positions.size();
    });
    if (done < count) throw Error(path.string() + ": fewer coordinates come than it has");
    file.write_dataset<double>("/pressures", std::span<const double>(c.pressures));
    file.write_attribute("/", "order", c.order.name);
    file.write_attribute("/", "order_digest", one(c.order.digest));
    file.write_attribute("/", "checksum", one(checksum.value()));
    file.close();
  });
}

Checkpoint read_checkpoint(const std::filesystem::path& path, const std::string& settings, std::uint64_t mesh_hash,
                           const OrderMark& order) {
  const std::string name = path.string();
  const Json now = parse_settings(settings, name);
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    throw Error(name + ": this checkpoint does not exist; remove --restart to start from the beginning");
  }
  Checkpoint c = read_all(path);
  require_same_name(name, c.order, order.name);
  const std::string differing = differences(parse_settings(c.settings, name), now);
  if (!differing.empty()) {
    throw Error(name + ": this checkpoint belongs to a run with other settings: " + differing +
                "; continue it with the flags of that run, which are `command` in the run.json beside it. If an older "
                "version " +
                "of truthcube wrote it, remove --restart to start from the beginning");
  }
  if (c.order != order) {
    throw Error(name +
                ": this checkpoint belongs to another order of the mesh than the one in the folder: the files "
                "come from different runs; remove --restart to start from the beginning");
  }
  if (c.mesh_hash != mesh_hash) {
    throw Error(name + ": this checkpoint belongs to another mesh (" + std::to_string(c.positions.size() / 3) +
                " positions)");
  }
  return c;
}

void require_order(const std::filesystem::path& path, const std::string& name) {
  std::error_code error;
  if (std::filesystem::exists(path, error)) require_same_name(path.string(), read_all(path).order, name);
}

}  // namespace physgen::truthcube
