// The record: where each field begins, as named constants with visible numbers.
#include "emit/pieces.h"
#include "emit/text.h"

namespace physgen::emit {

void record_struct(Printer& out, const plan::Record& record) {
  const model::Object& object = *record.object;
  out.line("/// Where each field begins in the record of one " + object.name + " [bytes].");
  out.line("template <class Real>");
  out.open("struct " + object.name + "Record {");
  for (const int f : record.order) {
    const auto field = static_cast<std::size_t>(f);
    out.line("static constexpr int " + object.fields[field].name + " = " + bytes(record.slots[field].offset) + ";");
  }
  out.line("static constexpr int bytes = " + bytes(record.bytes) + ";");
  out.line("static constexpr int alignment = " + bytes(record.alignment) + ";");
  out.close("};");
}

}  // namespace physgen::emit
