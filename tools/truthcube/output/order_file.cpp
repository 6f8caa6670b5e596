// An HDF5 file of its own, with a checksum, as a checkpoint is.
#include <files/disk.h>
#include <hdf5/h5.h>
#include <hdf5/raw_rows.h>
#include <physgen/error.h>
#include <truthcube/output/hash.h>
#include <truthcube/output/order_file.h>

#include <string>
#include <system_error>
#include <vector>

namespace physgen::truthcube {

namespace {

using h5::one;

constexpr std::int32_t order_version = 1;
constexpr const char* order_format = "physgen truthcube order";
constexpr std::uint64_t room_beside_order = std::uint64_t{1} << 16U;

// A file that can be read, and must not be used.
struct UnusableOrder : Error {
  using Error::Error;
};

void write_numbers(h5::File& file, const std::string& name, const std::vector<fem::Index>& numbers) {
  const hsize_t rows = numbers.size();
  file.make_fixed(name, H5T_STD_I32LE, one(rows));
  h5::RawRows(file, name, H5T_NATIVE_INT32).write(0, rows, numbers.data());
}

std::vector<fem::Index> read_numbers(const h5::File& file, const std::string& name) {
  if (!file.holds_all(name)) throw Error(name + " has fewer numbers than it counts");
  const std::vector<hsize_t> shape = file.shape(name);
  if (shape.size() != 1) throw Error(name + " is not a list");
  std::vector<fem::Index> numbers(shape[0]);
  h5::RawRows(file, name, H5T_NATIVE_INT32).read(0, shape[0], numbers.data());
  return numbers;
}

}  // namespace

std::uint64_t MeshOrder::digest() const {
  if (is_own()) return 0;
  Hash hash;
  hash.add(mesh_hash);
  hash.add(std::as_bytes(std::span(numbers.node_order)));
  hash.add(std::as_bytes(std::span(numbers.tet_order)));
  return hash.value();
}

void write_order(const std::filesystem::path& path, const MeshOrder& order) {
  disk::replace_file(path, [&order](const std::filesystem::path& written) {
    const auto& [nodes, tets] = order.numbers;
    h5::File file = h5::File::create(written, (nodes.size() + tets.size()) * sizeof(fem::Index) + room_beside_order);
    file.write_attribute("/", "format", std::string(order_format));
    file.write_attribute("/", "version", one(order_version));
    file.write_attribute("/", "mesh_hash", one(order.mesh_hash));
    write_numbers(file, "/nodes", nodes);
    write_numbers(file, "/tets", tets);
    file.write_attribute("/", "checksum", one(order.digest()));
    file.close();
  });
}

MeshOrder read_order(const std::filesystem::path& path, std::uint64_t mesh_hash) {
  const std::string name = path.string();
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    throw Error(name + ": the order of this run's mesh does not exist; remove --restart to start from the beginning");
  }
  try {
    const h5::File file = h5::File::open(path, false);
    if (!file.has_attribute("/", "format") || file.read_text_attribute("/", "format") != order_format) {
      throw UnusableOrder(name + ": this is not the order of a mesh");
    }
    if (const auto version = file.read_attribute<std::int32_t>("/", "version"); version != order_version) {
      throw UnusableOrder(name + ": has version " + std::to_string(version) + ", but this program reads version " +
                          std::to_string(order_version));
    }
    MeshOrder order;
    order.mesh_hash = file.read_attribute<std::uint64_t>("/", "mesh_hash");
    order.numbers.node_order = read_numbers(file, "/nodes");
    order.numbers.tet_order = read_numbers(file, "/tets");
    if (order.digest() != file.read_attribute<std::uint64_t>("/", "checksum")) {
      throw UnusableOrder(name +
                          ": is damaged: its checksum is not that of its contents; remove --restart to start from "
                          "the beginning");
    }
    if (order.mesh_hash != mesh_hash) {
      throw UnusableOrder(name + ": this order belongs to another mesh, of " +
                          std::to_string(order.numbers.node_order.size()) + " nodes and " +
                          std::to_string(order.numbers.tet_order.size()) +
                          " tets; give the --mesh of that run, or remove --restart to start from the beginning");
    }
    return order;
  } catch (const UnusableOrder&) {
    throw;
  } catch (const Error& failure) {
    throw Error(name + ": this file is damaged, or is not the order of a mesh: " + failure.what());
  }
}

}  // namespace physgen::truthcube
