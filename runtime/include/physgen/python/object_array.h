// The object array that Python holds: objects of a type, layout and precision that are chosen when the program runs.
// Views of its fields share its memory, which is not replaced while one of them exists.
#pragma once

#include <physgen/arrays/array.h>
#include <physgen/arrays/initial_values.h>
#include <physgen/python/object_type.h>

#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

namespace physgen::python {

/// The memory cannot be replaced, because somebody looks into it.
struct InUse : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// How objects are stored.
struct Storage {
  const LayoutRow* layout;
  bool in_double;
  SpaceKind space;  ///< host or cuda
};

/// Objects of one type, which own their memory together with the views of their fields.
class ObjectArray {
 public:
  /// `size` objects with their initial values.
  /// @pre size is not negative
  /// @throw Error when the memory cannot be had
  ObjectArray(const ObjectType& type, index_t size, const Storage& storage)
      : ObjectArray(type, size, storage, Uninitialised()) {
    initialize(untyped(), 0, padded_);
  }

  [[nodiscard]] const ObjectType& type() const { return *type_; }
  [[nodiscard]] const Storage& storage() const { return storage_; }
  [[nodiscard]] index_t size() const { return size_; }
  [[nodiscard]] index_t bytes() const { return memory_->bytes(); }
  [[nodiscard]] std::span<const FieldInfo> fields() const {
    return type_->record(storage_.space, storage_.in_double).fields;
  }
  [[nodiscard]] UntypedArray untyped() const { return untyped(fields()); }
  /// The same with other words on its fields.
  [[nodiscard]] UntypedArray untyped(std::span<const FieldInfo> fields) const {
    return {memory_->data(), size_,          padded_,     storage_.layout->pitch(size_),
            record_bytes_,   storage_.space, type_->name, fields};
  }
  /// The memory, which stays as long as this or what is returned does.
  [[nodiscard]] const std::shared_ptr<Buffer>& memory() const { return memory_; }

  /// Changes the number of objects. The first of them keep their values, new ones get initial values.
  /// @throw InUse while memory() is shared: views would look at memory that the array has left
  void resize(index_t size) {
    if (size == size_) return;
    if (memory_.use_count() > 1) {
      throw InUse(std::string(type_->name) + ": " + std::to_string(memory_.use_count() - 1) +
                  " views of this array exist, so it cannot get " + std::to_string(size) + " objects in place of " +
                  std::to_string(size_) + "; delete them first (del), or copy what they show (view.copy())");
    }
    ObjectArray other(*type_, size, storage_, Uninitialised());
    const index_t kept = std::min(size, size_);
    copy_range(other.untyped(), untyped(), 0, kept);
    reset(other.untyped(), kept, other.padded_);
    *this = std::move(other);
  }

  /// The view that kernels are given. Valid until the array is resized or destroyed.
  /// @tparam Array an array type such as model::StressArray<float>
  /// @throw Error where the objects have another precision or layout, or lie in another space
  template <class Array>
  [[nodiscard]] typename Array::View view() const {
    const Storage wanted{&row_of<typename Array::Layout>(), std::is_same_v<typename Array::Precision, double>,
                         Array::Space::kind};
    if (type_->name != Array::Object::name || wanted.layout != storage_.layout ||
        wanted.in_double != storage_.in_double || wanted.space != storage_.space) {
      throw Error(description() + " are given to a function that is compiled for " + std::string(Array::Object::name) +
                  in_words(wanted) + "; give it array.copy(layout=..., precision=..., space=...)");
    }
    return {memory_->data(), size_, storage_.layout->pitch(size_)};
  }

  /// "1000 model::Stress in aosoa(16) with float in host memory"
  [[nodiscard]] std::string description() const {
    return std::to_string(size_) + " " + std::string(type_->name) + in_words(storage_);
  }

 private:
  struct Uninitialised {};
  [[nodiscard]] static std::string in_words(const Storage& storage) {
    return " in " + std::string(storage.layout->name) + " with " + (storage.in_double ? "double" : "float") + " in " +
           name(storage.space) + " memory";
  }
  ObjectArray(const ObjectType& type, index_t size, const Storage& storage, Uninitialised /*memory*/)
      : type_(&type), storage_(storage), size_(size), padded_(storage.layout->padded(size)) {
    const RecordInfo& record = type.record(storage.space, storage.in_double);
    record_bytes_ = storage.layout->record_bytes(record.bytes, record.alignment);
    const index_t limit = std::numeric_limits<index_t>::max() / std::max(record_bytes_, 1) / 4;
    if (size > limit) {
      throw Error(std::string(type.name) + ": an array of " + std::to_string(size) + " objects of " +
                  std::to_string(record_bytes_) + " bytes cannot exist; give a size from 0 to " +
                  std::to_string(limit));
    }
    memory_ = std::make_shared<Buffer>(storage.space, padded_ * record_bytes_,
                                       std::string(type.name) + "[" + std::to_string(size) + "]");
  }

  const ObjectType* type_;
  Storage storage_;
  index_t size_;
  index_t padded_;
  int record_bytes_ = 0;
  std::shared_ptr<Buffer> memory_;
};

/// One field of objects by itself, packed and as code sees it: in the type that is computed with, rotations as
/// matrices. Copies convert between it and the array.
class PackedField {
 public:
  /// @param number of the field among those of `array`, which stores it
  PackedField(const ObjectArray& array, std::size_t number) : array_(&array) {
    const std::span<const FieldInfo> fields = array.fields();
    FieldInfo& packed = alone(packed_, fields, number);
    alone(stored_, fields, number);
    if (!is_whole(packed.type)) packed.type = packed.in_double ? ElementType::float64 : ElementType::float32;
    packed.offset = 0;
    packed.count = packed.visible_count();
    packed.quaternion = false;
    packed.scale = 1;
    packed.centre = 0;
    packed.own = nullptr;
    type_ = packed.type;
    record_bytes_ = packed.count * element_bytes(packed.type);
    memory_ = std::make_shared<Buffer>(SpaceKind::host, Aos::padded(array.size()) * record_bytes_,
                                       std::string(packed.name) + " of " + array.description());
  }

  [[nodiscard]] ElementType type() const { return type_; }
  [[nodiscard]] const std::shared_ptr<Buffer>& memory() const { return memory_; }

  void load() const { copy(packed(), array_->untyped()); }
  /// @throw Error naming a value that the format of the field cannot hold; the array is then unchanged
  void store() const {
    const UntypedArray to = array_->untyped(stored_);
    throw_if_falsified(losses_of_copy(to, packed()), to);
    copy(to, packed());
  }

 private:
  // The words on all fields, of which the others are stored nowhere.
  static FieldInfo& alone(std::vector<FieldInfo>& out, std::span<const FieldInfo> fields, std::size_t number) {
    out.assign(fields.begin(), fields.end());
    for (std::size_t f = 0; f < out.size(); ++f) {
      if (f == number) continue;
      out[f].type = ElementType::none;
      out[f].pruned = true;
    }
    return out[number];
  }
  [[nodiscard]] UntypedArray packed() const {
    const index_t size = array_->size();
    return {memory_->data(), size, Aos::padded(size), 1, record_bytes_, SpaceKind::host, array_->type().name, packed_};
  }

  const ObjectArray* array_;
  std::vector<FieldInfo> packed_, stored_;
  ElementType type_;
  int record_bytes_;
  std::shared_ptr<Buffer> memory_;
};

}  // namespace physgen::python
