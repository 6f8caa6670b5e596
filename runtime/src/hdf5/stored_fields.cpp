// See stored_fields.h. scale_factor, add_offset and _FillValue are the conventions of netCDF, by which its readers find
// the numbers that integers of equal steps and scaled numbers stand for.
#include "stored_fields.h"

#include <physgen/error.h>

#include <array>
#include <bit>
#include <string>
#include <string_view>

namespace physgen::h5 {

static_assert(std::endian::native == std::endian::little, "files hold the bytes of elements as processors do");

namespace {

constexpr std::array element_types{ElementType::float32, ElementType::float64,  ElementType::int32,
                                   ElementType::int64,   ElementType::uint64,   ElementType::boolean,
                                   ElementType::half,    ElementType::bfloat16, ElementType::snorm16};

constexpr const char* matrices = "rotation matrices, by columns";
constexpr const char* quaternions = "unit quaternions w, x, y, z";
constexpr const char* numbers = "numbers";

/// A float of 16 bits: its mantissa, exponent and sign from the lowest bit on.
Handle float16(std::size_t mantissa, std::size_t exponent, std::size_t bias) {
  Handle type(H5Tcopy(H5T_IEEE_F32LE), H5Tclose);
  const bool done = H5Tset_fields(type.id(), 15, mantissa, exponent, 0, mantissa) >= 0 &&
                    H5Tset_size(type.id(), 2) >= 0 && H5Tset_ebias(type.id(), bias) >= 0;
  if (!done) throw Error("HDF5 refuses a float of 16 bits");
  return type;
}

/// Bytes of 0 and 1 with these names, as h5py writes and reads numpy's bool.
Handle boolean() {
  Handle type(H5Tenum_create(H5T_STD_I8LE), H5Tclose);
  const signed char no = 0, yes = 1;
  const bool done = H5Tenum_insert(type.id(), "FALSE", &no) >= 0 && H5Tenum_insert(type.id(), "TRUE", &yes) >= 0;
  if (!done) throw Error("HDF5 refuses an enumeration of FALSE and TRUE");
  return type;
}

double stored_one(const FieldInfo& form) { return form.type == ElementType::snorm16 ? form.scale / 32767 : form.scale; }

}  // namespace

Handle type_of(ElementType type) {
  switch (type) {
    case ElementType::float32:
      return {H5Tcopy(H5T_IEEE_F32LE), H5Tclose};
    case ElementType::float64:
      return {H5Tcopy(H5T_IEEE_F64LE), H5Tclose};
    case ElementType::int32:
      return {H5Tcopy(H5T_STD_I32LE), H5Tclose};
    case ElementType::int64:
      return {H5Tcopy(H5T_STD_I64LE), H5Tclose};
    case ElementType::uint64:
      return {H5Tcopy(H5T_STD_U64LE), H5Tclose};
    case ElementType::boolean:
      return boolean();
    case ElementType::half:
      return float16(10, 5, 15);
    case ElementType::bfloat16:
      return float16(7, 8, 127);
    case ElementType::snorm16:
      return {H5Tcopy(H5T_STD_I16LE), H5Tclose};
    case ElementType::none:
      break;
  }
  throw Error("nothing is stored of this field");
}

const char* name_of(ElementType type) {
  switch (type) {
    case ElementType::float32:
      return "float32";
    case ElementType::float64:
      return "float64";
    case ElementType::int32:
      return "int32";
    case ElementType::int64:
      return "int64";
    case ElementType::uint64:
      return "uint64";
    case ElementType::boolean:
      return "bool";
    case ElementType::half:
      return "half";
    case ElementType::bfloat16:
      return "bfloat16";
    case ElementType::snorm16:
      return "snorm16";
    case ElementType::none:
      break;
  }
  return "none";
}

FieldInfo form_in_file(const FieldInfo& field) {
  FieldInfo form = field;
  form.offset = 0;
  if (field.own == nullptr) return form;
  form.type = field.in_double ? ElementType::float64 : ElementType::float32;
  form.scale = 1;
  form.centre = 0;
  form.own = nullptr;
  return form;
}

void write_attributes(File& file, const std::string& dataset, const FieldInfo& form) {
  file.write_attribute(dataset, "unit", std::string(form.unit));
  if (!form.doc.empty()) file.write_attribute(dataset, "doc", std::string(form.doc));
  file.write_attribute(dataset, "format", std::string(name_of(form.type)));
  file.write_attribute(dataset, "elements",
                       std::string(!form.rotation    ? numbers
                                   : form.quaternion ? quaternions
                                                     : matrices));
  file.write_attribute(dataset, "scale", one(form.scale));
  file.write_attribute(dataset, "centre", one(form.centre));
  if (form.type != ElementType::snorm16 && form.scale == 1 && form.centre == 0) return;
  file.write_attribute(dataset, "scale_factor", one(stored_one(form)));
  file.write_attribute(dataset, "add_offset", one(form.centre));
  if (form.type == ElementType::snorm16) file.write_attribute(dataset, "_FillValue", one(std::int32_t{-32768}));
}

FieldInfo read_form(const File& file, const std::string& place, const std::string& dataset) {
  FieldInfo form{};
  form.type = ElementType::none;
  const std::string format = file.read_text_attribute(dataset, "format");
  for (const ElementType type : element_types) {
    if (format == name_of(type)) form.type = type;
  }
  const std::string elements = file.read_text_attribute(dataset, "elements");
  form.quaternion = elements == quaternions;
  form.rotation = form.quaternion || elements == matrices;
  if (!form.is_stored() || (!form.rotation && elements != numbers)) {
    throw Error(place + " " + dataset + " holds " + elements + " in the format " + format +
                ", which this version of physgen does not know");
  }
  if (!file.has_type(dataset, type_of(form.type).id()))
    throw Error(place + " " + dataset + " is not stored as " + format);
  form.scale = file.read_attribute<double>(dataset, "scale");
  form.centre = file.read_attribute<double>(dataset, "centre");
  const std::vector<hsize_t> shape = file.shape(dataset);
  if (shape.empty() || shape.size() > 2) {
    throw Error(place + " " + dataset + " has " + std::to_string(shape.size()) +
                " dimensions, where save() writes 1 or 2: another program has changed the file");
  }
  form.count = static_cast<int>(shape.size() == 2 ? shape[1] : 1);
  return form;
}

std::string read_unit(const File& file, const std::string& dataset) {
  return file.read_text_attribute(dataset, "unit");
}

}  // namespace physgen::h5
